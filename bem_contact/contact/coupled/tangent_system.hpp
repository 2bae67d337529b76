#pragma once

#include "bem_contact/contact/coupled/outer_iteration.hpp"
#include "bem_contact/contact/result.hpp"
#include "bem_contact/contact/tangential/newton_matrix.hpp"

#include <Eigen/Core>

#include <optional>
#include <utility>
#include <vector>

namespace bem_contact::contact {

/// What the conditions of a contact change by per unit of an input, the tractions held.
struct TangentLoad {
  Eigen::VectorXd distance; ///< e under the approach as it is, mm; field
  Eigen::VectorXd drive;    ///< slip of a step, mm; field of two components
  Eigen::VectorXd bound;    ///< of |p_t| under the pressure as it is, MPa; field
  double approach = 0;      ///< prescribed, mm
  double force = 0;         ///< prescribed less what the tractions as they are bear, N
  Eigen::Vector2d shear_forces = Eigen::Vector2d::Zero(); ///< likewise along x and s, N
};

/// What a solution changes by per unit of an input.
struct TangentTractions {
  Eigen::VectorXd pn, pt;                             ///< MPa; fields of one component and of two
  double approach = 0;                                ///< mm
  Eigen::Vector2d creepage = Eigen::Vector2d::Zero(); ///< found for prescribed shear forces

  void add(double factor, const TangentTractions& other);
};

/// Right sides of a linear system and their answers. Of many inputs few are independent: speeds and the
/// radius of a curve do no more than creepages do.
class KnownAnswers {
public:
  /// The answer to so much of `right` as former ones answer, which is taken off it.
  Eigen::VectorXd take(Eigen::VectorXd& right) const;
  /// `right`: what take() left of one.
  void keep(const Eigen::VectorXd& right, const Eigen::VectorXd& answer);

private:
  std::vector<std::pair<Eigen::VectorXd, Eigen::VectorXd>> all_; ///< right sides orthonormal
};

/// The equations of a solved contact, linearised: elements stay in contact or apart, at the limit of the
/// pressure, in adhesion or in slip, as they are. In contact e does not change. What adheres does not slip.
/// What slips keeps |p_t| at its bound, along the slip, whose direction may change. Each input is one right
/// side. Linear systems are solved to tangent_precision.
///
/// Where pressure and shear act on each other, the answer to that feedback is found by GCR (Eisenstat, Elman,
/// Schultz 1983), whose directions serve all inputs.
class TangentSystem {
public:
  /// Everything outlives this. `solved` has no history, and friction that does not vary.
  TangentSystem(const ContactProblem& problem, const ContactResult& solved, ContactOperators& operators,
                const SolverOptions& options, WorkBudget& work);
  TangentSystem(const TangentSystem&) = delete;
  TangentSystem& operator=(const TangentSystem&) = delete;

  /// Throws ConvergenceError where a system is singular: the solution has no derivative.
  TangentTractions solve(const TangentLoad& load);

  /// What the tractions of `tangent` do to e under the approach as it is, mm; field.
  Eigen::VectorXd distance(const TangentTractions& tangent) const;
  /// What they do to the slip of a step, mm; field of two components, 0 outside the contact.
  Eigen::VectorXd slip(const TangentTractions& tangent) const;

  bool has_shear() const { return system_.shear.has_value(); }
  bool shear_bears() const { return system_.by_force; }        ///< a part of the prescribed vertical force
  bool slips(int i) const { return slips_[i] != 0; }           ///< element i in contact
  const Eigen::VectorXd& bound() const { return task_.bound; } ///< of |p_t|, MPa; field
  double bound_rate(int i) const { return friction_[i]; }      ///< by what it rises with the pressure

private:
  using Vector = Eigen::VectorXd;
  struct Direction {
    Vector feedback, image; ///< y, and (1 - K) y, of unit length
    TangentTractions answer;
  };
  void prepare_shear(const ContactResult& solved);
  Vector inverse_normal(const Vector& right);
  Vector iterated_normal(const Vector& right);
  TangentTractions respond(const TangentLoad& load, const Vector& feedback);
  Vector feedback_of(const TangentTractions& tangent) const;
  void solve_shear(const TangentLoad& load, TangentTractions& out);
  Vector inverse_shear(const Vector& right);

  const ContactProblem& problem_;
  WorkBudget& work_;
  CoupledSystem system_;
  std::vector<int> touching_;     ///< in contact below the limit of the pressure
  Eigen::MatrixXd normal_factor_; ///< Cholesky's of A_nn of these, if they are few; else empty
  Vector unit_;                   ///< of the pressure per unit of the approach, MPa/mm; field
  double force_to_length_ = 0;
  std::vector<Direction> directions_;
  KnownAnswers known_pressures_, known_shears_;
  TangentLoad nothing_;

  // of friction
  TangentialTask task_;
  Vector friction_; ///< d bound / d p_n; field
  std::vector<char> slips_;
  std::optional<ContactElements> elements_;
  std::optional<NewtonMatrix> matrix_;
  Linearisation linearisation_;
  Vector along_;                                    ///< direction of p_t of what slips; in contact
  std::vector<int> found_;                          ///< components whose creepage is found
  Eigen::MatrixXd slips_of_unit_, answers_to_unit_; ///< of each such creepage; in contact
};

} // namespace bem_contact::contact
