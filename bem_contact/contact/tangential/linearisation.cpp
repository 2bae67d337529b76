#include "bem_contact/contact/tangential/linearisation.hpp"

namespace bem_contact::contact {

using Eigen::Matrix2d;
using Eigen::Vector2d;
using Eigen::VectorXd;

ContactElements::ContactElements(const TangentialSystem& system, const TangentialTask& task)
    : contact(task.contact), grid_size(system.size()), stiffness(task.contact.size()),
      bound(task.contact.size()) {
  for (std::size_t a = 0; a < contact.size(); ++a) {
    stiffness[a] = system.stiffness[contact[a]];
    bound[a] = task.bound[contact[a]];
  }
}

VectorXd ContactElements::gather(const VectorXd& field) const {
  VectorXd v(unknowns());
  for (int a = 0; a < unknowns() / 2; ++a) {
    v[2 * a] = field[contact[a]];
    v[2 * a + 1] = field[grid_size + contact[a]];
  }
  return v;
}

VectorXd ContactElements::scatter(const VectorXd& v) const {
  VectorXd field = VectorXd::Zero(2 * grid_size);
  for (int a = 0; a < unknowns() / 2; ++a) {
    field[contact[a]] = v[2 * a];
    field[grid_size + contact[a]] = v[2 * a + 1];
  }
  return field;
}

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
