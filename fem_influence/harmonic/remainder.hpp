#pragma once

#include "bem_contact/inside/stresses_inside.hpp"
#include "fem_influence/shared/settings.hpp"

#include <array>
#include <span>

/// What the stresses of a body are more than those of a half-space under the same tractions. It is smooth,
/// and nothing of it is a traction of the surface.
namespace bem_contact::fem {

/// 1 (smaller half width of the patch; width of a station). The least depth at which the body is solved for.
/// Nearer to the surface the mesh shows, and the more wavenumbers are needed the nearer it is.
inline constexpr double least_depth_of_size = 0.2, least_depth_of_station = 1.5;
/// 1 (least depth). The remainder above it follows from these depths.
inline constexpr std::array<double, 3> helper_depths{1, 1.6, 2.4};

struct Remainder {
  inside::Passage stresses;
  double error = 0; ///< as von Mises' stress, MPa
};

halfspace::Stress difference(const halfspace::Stress& a, const halfspace::Stress& b);

/// The remainder at a depth (in least depths, below 1) from those at the helper depths: a parabola through
/// all three, or for nn, xn and sn through 0 on the surface and two. `error`: that of the helpers; the
/// difference to a line comes to it.
Remainder towards_surface(std::span<const inside::Passage> helpers, double depth, double error);

} // namespace bem_contact::fem
