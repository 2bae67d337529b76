#pragma once

#include "bem_contact/uses/shakedown/deviator.hpp"

#include <array>

namespace bem_contact::shakedown {

/// Which components the middle of a ball may have: the residual stresses that a point may bear.
using FreeComponents = std::array<bool, 5>;
inline constexpr FreeComponents all_free{true, true, true, true, true};

/// The smallest ball about the deviators of a path.
struct Ball {
  Deviator middle = Deviator::Zero();
  double radius = 0; ///< no point of the path lies farther away
  double least = 0;  ///< no ball is smaller than this: equal to `radius` but for rounding
};

/// With a middle that has the free components alone. The path must not be empty. Its dual is a quadratic
/// programme for weights of the points that sum up to 1; solved by pairwise steps (Lacoste-Julien and Jaggi,
/// NIPS 2015), which converge linearly.
Ball smallest_ball(const DeviatorPath& path, const FreeComponents& free = all_free);

} // namespace bem_contact::shakedown
