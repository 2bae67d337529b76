#pragma once

#include "bem_contact/contact/tangential/linearisation.hpp"

#include <Eigen/Core>

#include <vector>

namespace bem_contact::contact {

/// B on the elements in contact and the linear systems of Newton's method with it. Few elements have a dense
/// matrix and LU factors; many have a StepBox and GCR, and LU factors if GCR does not converge.
class NewtonMatrix {
public:
  NewtonMatrix(const TangentialSystem& system, const ContactElements& elements, WorkBudget& work);

  /// result = B v
  void step(const Eigen::VectorXd& v, Eigen::VectorXd& result) const;
  /// J^-1 (-residual) with J = 1 - M (1 - r B), up to `tolerance` of the residual. Not finite where J is
  /// singular. Counts products and names the solver in `state`.
  Eigen::VectorXd newton_step(const Linearisation& at, double tolerance, WorkBudget& work,
                              TangentialState& state) const;

private:
  double product_work() const;
  bool solve_by_gcr(const Linearisation& at, double tolerance, TangentialState& state,
                    Eigen::VectorXd& step) const;
  /// By LU. An element that slips has one unknown, for J is the identity across its bound.
  Eigen::VectorXd solve_dense(const Linearisation& at) const;

  const TangentialSystem& system_;
  const ContactElements& elements_;
  const Eigen::MatrixXd* matrix_ = nullptr; ///< B of a contact of few elements; else
  const StepBox* box_ = nullptr;
  StepBoxScratch* scratch_ = nullptr;
  std::vector<int> local_; ///< places of the elements on the boxes
};

} // namespace bem_contact::contact
