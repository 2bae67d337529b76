#include "bem_contact/contact/tangential/linear_solution.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace bem_contact::contact {

using Eigen::VectorXd;

/// Solutions in single precision, each of which takes off four digits or so of the residual. Chosen: far more
/// than it takes.
constexpr int most_corrections = 12;

VectorXd projected(const Linearisation& at, VectorXd v, const VectorXd* stiffness) {
  for (std::size_t a = 0; a < at.projection.size(); ++a)
    v.segment<2>(2 * a) = ((stiffness ? (*stiffness)[a] : 1) * at.projection[a] * v.segment<2>(2 * a)).eval();
  return v;
}

std::optional<VectorXd> linear_solution(const NewtonMatrix& matrix, const Linearisation& at,
                                        const VectorXd& stiffness, const VectorXd& right,
                                        const LinearPrecision& precision, WorkBudget& work) {
  TangentialState state;
  VectorXd x = VectorXd::Zero(right.size()), product;
  Linearisation rest = at;
  rest.residual = -right; // J x - right
  double former = std::numeric_limits<double>::infinity();
  for (int i = 0; i < most_corrections; ++i) {
    const double left = rest.residual.norm();
    if (left <= precision.wanted * right.norm() || !(left < former))
      break;
    former = left;
    const double enough = precision.wanted * right.norm() / left;
    x += matrix.newton_step(rest, {}, std::max(precision.correction, enough), work, state).x;
    if (!x.allFinite())
      return std::nullopt;
    matrix.step(x, product);
    rest.residual = x - projected(at, x) + projected(at, product, &stiffness) - right;
  }
  return rest.residual.norm() <= precision.accepted * right.norm() ? std::optional(std::move(x))
                                                                   : std::nullopt;
}

} // namespace bem_contact::contact
