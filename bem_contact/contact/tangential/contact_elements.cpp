#include "bem_contact/contact/tangential/contact_elements.hpp"

namespace bem_contact::contact {

using Eigen::VectorXd;

ContactElements::ContactElements(const TangentialSystem& system, const TangentialTask& task)
    : contact(task.contact), layer(task.layer), limits(task.limits), grid_size(system.size()),
      stiffness(task.contact.size()), bound(task.contact.size()) {
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
  write(v, field);
  return field;
}

void ContactElements::write(const VectorXd& v, VectorXd& field) const {
  for (int a = 0; a < unknowns() / 2; ++a) {
    field[contact[a]] = v[2 * a];
    field[grid_size + contact[a]] = v[2 * a + 1];
  }
}

} // namespace bem_contact::contact
