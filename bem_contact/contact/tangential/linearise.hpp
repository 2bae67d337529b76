#pragma once

#include "bem_contact/contact/tangential/friction.hpp"

#include <Eigen/Core>

#include <vector>

namespace bem_contact::contact {

/// F = p - Proj(p + r S) and the derivative M of the projection, element by element. Vectors are [x, s] of
/// the first element, of the second, ...
struct Linearisation {
  Eigen::VectorXd residual;
  std::vector<Eigen::Matrix2d> projection;
};

/// B of one element under a load on another (slip_step.hpp), tangential components.
Eigen::Matrix2d step_number(const TangentialSystem& system, int target, int load);
/// The same of all pairs of these elements.
Eigen::MatrixXd step_matrix(const TangentialSystem& system, const std::vector<int>& elements);

/// p of one element with S = c - B p: S = 0 if |p| <= bound, else |p| = bound and S along p.
Eigen::Vector2d solve_element(const Eigen::Matrix2d& b, const Eigen::Vector2d& c, double bound);

Linearisation linearise(const Eigen::VectorXd& stiffness, const Eigen::VectorXd& bound,
                        const Eigen::VectorXd& p, const Eigen::VectorXd& slip);

/// Sweeps over the few rows that hold most of the residual, from the leading edge, everything else held: at a
/// narrow end of adhesion slip eats its way through a row one element a step of Newton, which need not cost a
/// step of the whole. Changes p of these rows; false: the residual is not so concentrated, or the sweeps do
/// not settle. `slip` is that of the former p.
bool sweep_rows(const TangentialSystem& system, const std::vector<int>& contact,
                const Eigen::VectorXd& stiffness, const Eigen::VectorXd& bound, const Eigen::VectorXd& slip,
                const Linearisation& at, Eigen::VectorXd& p);

} // namespace bem_contact::contact
