#pragma once

#include "bem_contact/inside/stresses_inside.hpp"

#include <array>
#include <functional>
#include <span>
#include <vector>

/// What the stresses of a body are more than those of a half-space under the same tractions. It is smooth,
/// and nothing of it is a traction of the surface.
namespace bem_contact::inside {

/// 1 (least depth). The remainder above it follows from these depths.
inline constexpr std::array<double, 3> helper_depths{1, 1.6, 2.4};

struct Remainder {
  Passage stresses;
  double error = 0; ///< as von Mises' stress, MPa
};

halfspace::Stress difference(const halfspace::Stress& a, const halfspace::Stress& b);

/// The remainder at a depth (in least depths, below 1) from those at the helper depths: a parabola through
/// all three, or for nn, xn and sn through 0 on the surface and two. `error`: that of the helpers; the
/// difference to a line comes to it.
Remainder towards_surface(std::span<const Passage> helpers, double depth, double error);

/// Says whether the body's surface is above a point.
using IsBelow = std::function<bool(const BelowSurface&)>;

/// The points at which the remainder of an area is asked for.
struct AreaPlan {
  double least_depth = 0;           ///< mm
  std::vector<BelowSurface> probes; ///< the area's points that are deep enough, then helpers of the others
  std::vector<int> own;             ///< of each point its probe; else -1
  std::vector<int> first_helper;    ///< of each point above the least depth the first of its helpers; else -1

  AreaPlan(std::span<const BelowSurface> points, double least_depth, const IsBelow& is_below);
};

struct ProbedRemainder {
  std::vector<Passage> stresses; ///< [probe][place]; nan where the body is not
  std::vector<double> error;     ///< [probe], as von Mises' stress, MPa
};

/// The body's stresses are those of the half-space, which are there already, and the remainder; nan where the
/// surface is not above a point.
void add_remainder(AreaStresses& area, const AreaPlan& plan, const ProbedRemainder& rest);

} // namespace bem_contact::inside
