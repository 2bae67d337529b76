#pragma once

#include <Eigen/Core>

#include <vector>

namespace bem_contact::contact {

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
