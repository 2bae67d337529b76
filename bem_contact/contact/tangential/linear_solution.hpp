#pragma once

#include "bem_contact/contact/tangential/newton_matrix.hpp"

#include <Eigen/Core>

#include <optional>

/// Linear systems at a solution of the tangential problem, in double precision.
namespace bem_contact::contact {

/// M v or, with `stiffness`, M r v; element by element.
Eigen::VectorXd projected(const Linearisation& at, Eigen::VectorXd v,
                          const Eigen::VectorXd* stiffness = nullptr);

/// Residuals over the right side, 1.
struct LinearPrecision {
  double wanted;     ///< no more solutions are sought below it
  double accepted;   ///< above it there is no solution
  double correction; ///< of each solution in single precision
};

/// x of J x = right with J = 1 - M (1 - r B): solutions in single precision are corrected until double
/// precision agrees, or no longer gets nearer. Nothing where J is singular, or nearly so.
std::optional<Eigen::VectorXd> linear_solution(const NewtonMatrix& matrix, const Linearisation& at,
                                               const Eigen::VectorXd& stiffness, const Eigen::VectorXd& right,
                                               const LinearPrecision& precision, WorkBudget& work);

} // namespace bem_contact::contact
