#include "bem_contact/contact/tangential/linear_solution.hpp"

#include <algorithm>
#include <utility>

namespace bem_contact::contact {

using Eigen::VectorXd;

/// Solutions in single precision, each of which takes off four digits or so of the residual. Chosen: far more
/// than it takes.
constexpr int most_corrections = 12;
/// 1. A correction that leaves more of the residual has lost its digits: directions of hundreds of right
/// sides are no longer orthogonal in single precision. Then it begins anew. Chosen.
constexpr double least_gain = 0.5;

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
  bool anew = false;
  for (int i = 0; i < most_corrections; ++i) {
    const double left = rest.residual.norm();
    if (left <= precision.wanted * right.norm())
      break;
    const double enough = precision.wanted * right.norm() / left;
    VectorXd next = x + matrix.newton_step(rest, {}, std::max(precision.correction, enough), work, state).x;
    if (!next.allFinite())
      return std::nullopt;
    matrix.step(next, product);
    VectorXd residual = next - projected(at, next) + projected(at, product, &stiffness) - right;
    const bool gains = residual.norm() < least_gain * left;
    if (residual.norm() < left) {
      x = std::move(next);
      rest.residual = std::move(residual);
    }
    if (!gains && std::exchange(anew, true))
      break;
    if (!gains)
      matrix.begin_anew();
  }
  return rest.residual.norm() <= precision.accepted * right.norm() ? std::optional(std::move(x))
                                                                   : std::nullopt;
}

} // namespace bem_contact::contact
