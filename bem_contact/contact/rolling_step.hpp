#pragma once

#include <array>

namespace bem_contact {

/// Slip of steady rolling: S(x) = w dx + sum_k rolling_step[k] u(x + k dx), k = 0, 1, 2: a particle now at x
/// was at x + k dx k steps ago (Kalker 1990, eq. 1.65 ff. has one step, u(x) - u(x + dx)).
///
/// Two steps make the derivative one of second order at x itself (backward differences, Gear 1971); one step
/// looks half an element ahead. Of Kalker's coefficients, 40 elements across, one step misses C11 by 1.5 %
/// and C33 by 6.8 % where two miss them by .4 % and 1.1 %; tests/contact has both. The symbol's real part is
/// (1 - cos k dx)^2 >= 0 against 1 - cos k dx: rolling still loses energy in every wave, but less.
inline constexpr std::array<double, 3> rolling_step{1.5, -2.0, 0.5};

/// Columns ahead of the grid in which displacements are needed.
inline constexpr int rolling_columns = static_cast<int>(rolling_step.size()) - 1;

} // namespace bem_contact
