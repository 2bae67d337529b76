#pragma once

#include "bem_contact/contact/tangential/contact_elements.hpp"
#include "bem_contact/contact/tangential/gcr.hpp"
#include "bem_contact/contact/tangential/linearisation.hpp"

#include <Eigen/Core>

#include <vector>

namespace bem_contact::contact {

/// B on the elements in contact and the linear systems of Newton's method with it, by GCR. Few elements have
/// a dense matrix, and LU factors as preconditioner. Many have a StepBox, and LU factors if GCR does not
/// converge without them.
class NewtonMatrix {
public:
  /// What its linear systems are: those of Newton's steps, each with a matrix J of its own, or one J with
  /// many right sides, whose factors or directions serve all of them.
  enum class Serves { newton_steps, many_right_sides };
  NewtonMatrix(const TangentialSystem& system, const ContactElements& elements, WorkBudget& work,
               Serves serves = Serves::newton_steps);

  /// result = B v
  void step(const Eigen::VectorXd& v, Eigen::VectorXd& result) const;
  /// J^-1 (-residual) with J = 1 - M (1 - r B), up to `tolerance` of the residual; with a border, the same of
  /// the larger system. Not finite where that is singular. Counts products and names the solver in `state`.
  BorderedSolution newton_step(const Linearisation& at, const Border& border, double tolerance,
                               WorkBudget& work, TangentialState& state) const;
  /// Of many right sides: what former ones left is not used again.
  void begin_anew() const;

private:
  struct Asked {
    const Linearisation& at;
    const Border& border;
    double tolerance;
  };
  double product_work() const;
  /// True if GCR converged, or if there are so many elements that its result has to do.
  bool solve_on_box(const Asked& asked, TangentialState& state, BorderedSolution& step) const;
  BorderedSolution solve_few(const Asked& asked, TangentialOperators::FewElements& few,
                             TangentialState& state) const;

  const TangentialSystem& system_;
  const ContactElements& elements_;
  std::optional<TangentialOperators::FewElements> own_few_; ///< of many right sides
  TangentialOperators::FewElements* few_ = nullptr;         ///< of a contact of few elements; else
  const StepBox* box_ = nullptr;
  StepBoxScratch* scratch_ = nullptr;
  mutable std::optional<Gcr> own_gcr_; ///< of many right sides
  std::vector<int> local_;             ///< places of the elements on the boxes
};

} // namespace bem_contact::contact
