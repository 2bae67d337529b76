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

std::vector<NewtonElement> newton_elements(const Linearisation& at, const VectorXd& stiffness) {
  std::vector<NewtonElement> out;
  out.reserve(at.projection.size());
  for (std::size_t a = 0; a < at.projection.size(); ++a)
    out.push_back({at.projection[a].cast<float>(),
                   static_cast<float>(stiffness[static_cast<Eigen::Index>(a)]),
                   static_cast<float>(at.projection[a].trace())});
  return out;
}

void newton_image(std::span<const NewtonElement> elements, const CarriedYield& carried,
                  Eigen::Ref<const Eigen::VectorXf> v, Eigen::Ref<const Eigen::VectorXf> bv,
                  Eigen::VectorXf& result) {
  for (std::size_t a = 0; a < elements.size(); ++a) {
    const NewtonElement& e = elements[a];
    const Eigen::Vector2f here = v.segment<2>(2 * a);
    result.segment<2>(2 * a) = here - e.projection * (here - e.stiffness * bv.segment<2>(2 * a));
  }
  if (carried.elements.empty())
    return;
  Eigen::VectorXf z = v;
  for (std::size_t a = 0; a < elements.size(); ++a)
    z.segment<2>(2 * a) -= elements[a].stiffness * bv.segment<2>(2 * a);
  carried.add(z, -1.0f, result);
}

} // namespace bem_contact::contact
