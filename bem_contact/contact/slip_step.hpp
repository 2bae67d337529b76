#pragma once

#include "bem_contact/contact/problem.hpp"

#include <array>
#include <vector>

namespace bem_contact {

/// Weights of the slip of steady rolling: S(x) = w dx + sum_k rolling_step[k] u(x + k dx), k = 0, 1, 2. A
/// particle that is now at x was at x + k dx k rolling steps ago (Kalker 1990, eq. 1.65 ff., takes one
/// difference, u(x) - u(x + dx)).
///
/// These weights are the backward difference of second order (Gear 1971): the derivative at x itself, where
/// one difference gives that half an element ahead. With 40 elements across, one difference misses Kalker's
/// C11 by 1.5 % and C33 by 6.8 %; these weights miss them by 0.4 % and 1.1 % (tests/contact checks both). The
/// real part of the symbol is (1 - cos k dx)^2 >= 0 instead of 1 - cos k dx: rolling still loses energy in
/// every wave, but less.
inline constexpr std::array<double, 3> rolling_step{1.5, -2.0, 0.5};

/// Columns ahead of the grid in which displacements are needed.
inline constexpr int rolling_columns = static_cast<int>(rolling_step.size()) - 1;

/// The slip of one rolling step or load step, mm, from the displacements u = -A p of now (k = 0) and of one
/// and two steps ago:
///     S(x) = length w(x) + sum_k present[k] u_now(x + k dx) + sum_k former[k] u_k(x + k columns dx).
/// In steady rolling u_k(x) = u_now(x), so that all weights are in `present`. In transient rolling the grid
/// moves by one column a step. In a shift the grid lies still in the material.
struct SlipStep {
  std::array<double, 3> present{}, former{};
  int columns = 0;
  double length = 1; ///< mm; 1 where the rigid slip is given in mm
};

SlipStep slip_step(const ContactProblem& problem);

/// What an element's shear traction rises by over the slip that it alone prevents: 1 / mean of B_xx and B_ss
/// of the element itself, with B = sum_k present[k] A(k dx). One value a row, MPa/mm.
std::vector<double> element_stiffness(const ContactProblem& problem);

} // namespace bem_contact
