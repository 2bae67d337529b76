#pragma once

#include "bem_contact/contact/plastic_slip.hpp"
#include "bem_contact/contact/slip_step.hpp"
#include "bem_contact/contact/tangential/tangential_operators.hpp"

#include <Eigen/Core>

#include <optional>
#include <string>
#include <vector>

namespace bem_contact::contact {

/// The linear part of one rolling step or load step on a grid; vectors are fields of two components,
/// [2][ms][mx]. `problem` and `operators` outlive it; the operators belong to the problem's influence
/// numbers.
class TangentialSystem {
public:
  TangentialSystem(const ContactProblem& problem, TangentialOperators& operators);

  int size() const { return problem->grid.size(); }
  int columns() const { return problem->grid.mx; }
  /// A_tt p at x + columns dx, mm
  Eigen::VectorXd displacement(const Eigen::VectorXd& p, WorkBudget& work, int columns = 0) const;
  Eigen::VectorXd step(const Eigen::VectorXd& p, WorkBudget& work) const; ///< B_tt p, mm
  const StepNumbers& step_numbers() const;
  double product_work(int rows) const; ///< work.hpp
  TangentialOperators::BoxWithScratch box_around(const std::vector<int>& contact, WorkBudget& work) const;
  TangentialOperators::FewElements& few_elements(const std::vector<int>& contact) const;

  const ContactProblem* problem;
  SlipStep rule;
  Eigen::VectorXd stiffness;            ///< element_stiffness() of its row, MPa/mm; field of one component
  std::optional<PlasticSlip> hardening; ///< of a layer that hardens or softens

private:
  TangentialOperators* operators_;
};

/// Friction for given p_n: |p_t| <= bound; S = drive - B_tt p; an element sticks, or slips along S.
struct TangentialTask {
  Eigen::VectorXd bound;    ///< mu p_n, or less that the layer bears unless it hardens, MPa; field
  Eigen::VectorXd rigid;    ///< w of the step, mm
  Eigen::VectorXd drive;    ///< rigid - (B p_n)_t + what former tractions left, mm
  std::vector<int> contact; ///< elements with p_n > 0
  double slip_floor = 0;    ///< mm: slip below this is rounding
  /// Of a layer that hardens or softens, if it may yield: it bears less than `bound`. Null: it does not.
  const PlasticSlip* layer = nullptr;
  Eigen::VectorXd limits = {}; ///< tau_0 at the temperatures of the elements, MPa; field, or empty
};

struct TangentialState {
  Eigen::VectorXd p, slip; ///< p_t, MPa; S = drive - B p in contact, mm
  int iterations = 0;
  int products = 0; ///< of GCR
  bool converged = false;
  double violation = 0;
  std::string solver, remark;
  /// kinetic_friction.hpp: elements that have the kinetic bound, and those that had it from the start;
  /// fields, or empty.
  std::vector<char> slipped = {}, held = {};
  /// coupled/varying_friction.hpp: mu over mu(0) as used last, and where the layer softens by heat after it
  /// tau_0 over its largest; and mu over mu(0) as the slip velocity alone has it; fields, empty before the
  /// first iteration.
  Eigen::VectorXd factor, by_slip;
};

/// The largest rigid slip w or elastic slip S - w of the elements in contact, and at least `floor`; mm.
double largest_slip(const Eigen::VectorXd& rigid, const std::vector<int>& contact,
                    const Eigen::VectorXd& slip, double floor);

/// The answers of task.layer to these tractions and slips; field.
std::vector<LayerAnswer> layer_answers(const TangentialTask& task, const Eigen::VectorXd& p,
                                       const Eigen::VectorXd& slip);
/// The bounds on |p_t| in this solution, of friction and layer, MPa; field.
Eigen::VectorXd bounds_of(const TangentialTask& task, const Eigen::VectorXd& p, const Eigen::VectorXd& slip);

/// The largest violation of Coulomb's law: of the cone, and of the nearer of adhesion (|S| over the largest
/// slip) and slip (p_t against mu p_n S/|S|, over mu pmax).
double coulomb_violation(const TangentialTask& task, const Eigen::VectorXd& p, const Eigen::VectorXd& slip);

/// Sets state.slip of state.p on the whole grid, state.violation and state.converged.
void judge(const TangentialSystem& system, const TangentialTask& task, double tolerance, WorkBudget& work,
           TangentialState& state);

} // namespace bem_contact::contact
