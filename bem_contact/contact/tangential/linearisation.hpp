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
  Eigen::VectorXd scatter(const Eigen::VectorXd& v) const; ///< zero outside the contact

  const std::vector<int>& contact; ///< of the task
  int grid_size;
  Eigen::VectorXd stiffness, bound; ///< one value an element
};

/// F = p - Proj(p + r S), which is 0 where Coulomb's law holds, and the derivative M of the projection,
/// element by element. Vectors are [x, s] of the first element, of the second, ...
struct Linearisation {
  Eigen::VectorXd residual;
  std::vector<Eigen::Matrix2d> projection;
};

/// `stiffness` is r, `bound` the radius of the friction disc; one value an element.
Linearisation linearise(const Eigen::VectorXd& stiffness, const Eigen::VectorXd& bound,
                        const Eigen::VectorXd& p, const Eigen::VectorXd& slip);

} // namespace bem_contact::contact
