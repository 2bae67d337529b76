#include "bem_contact/contact/tangential/linearisation.hpp"

namespace bem_contact::contact {

using Eigen::Matrix2d;
using Eigen::Vector2d;
using Eigen::VectorXd;

Linearisation linearise(const VectorXd& stiffness, const VectorXd& bound, const VectorXd& p,
                        const VectorXd& slip) {
  const auto n = bound.size();
  Linearisation result{VectorXd(2 * n), std::vector<Matrix2d>(n)};
  for (Eigen::Index a = 0; a < n; ++a) {
    const Vector2d z = p.segment<2>(2 * a) + stiffness[a] * slip.segment<2>(2 * a);
    const double length = z.norm();
    if (length <= bound[a]) {
      result.residual.segment<2>(2 * a) = p.segment<2>(2 * a) - z;
      result.projection[a] = Matrix2d::Identity();
    } else {
      const Vector2d direction = z / length;
      result.residual.segment<2>(2 * a) = p.segment<2>(2 * a) - bound[a] * direction;
      result.projection[a] = bound[a] / length * (Matrix2d::Identity() - direction * direction.transpose());
    }
  }
  return result;
}

} // namespace bem_contact::contact
