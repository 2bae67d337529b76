#pragma once

#include "bem_contact/contact/tangential/tangential_system.hpp"

#include <Eigen/Core>

namespace bem_contact::contact {

/// p of one element with S = c - B p: S = 0 if |p| <= bound, else |p| = bound and S along p.
Eigen::Vector2d solve_element(const Eigen::Matrix2d& b, const Eigen::Vector2d& c, double bound);

/// Gauss-Seidel from the leading edge, element by element (after SteadyGS: Vollebregt 2010), damped. At most
/// `most` sweeps.
void sweep_elements(const TangentialSystem& system, const TangentialTask& task, double tolerance, int most,
                    WorkBudget& work, TangentialState& state);

} // namespace bem_contact::contact
