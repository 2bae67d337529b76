#pragma once

#include "bem_contact/contact/tangential/tangential_system.hpp"

#include <Eigen/Core>

#include <vector>

namespace bem_contact::contact {

/// The elements in contact, in the order of the contact list. Vectors on them are [x, s] of the first
/// element, of the second, ...
struct ContactElements {
  ContactElements(const TangentialSystem& system, const TangentialTask& task);

  int unknowns() const { return 2 * static_cast<int>(contact.size()); }
  Eigen::VectorXd gather(const Eigen::VectorXd& field) const;
  Eigen::VectorXd scatter(const Eigen::VectorXd& v) const;            ///< zero outside the contact
  void write(const Eigen::VectorXd& v, Eigen::VectorXd& field) const; ///< leaves the rest as it is

  const std::vector<int>& contact; ///< of the task
  const PlasticSlip* layer;        ///< of the task
  const Eigen::VectorXd& limits;   ///< of the task
  int grid_size;
  Eigen::VectorXd stiffness, bound; ///< one value an element
};

} // namespace bem_contact::contact
