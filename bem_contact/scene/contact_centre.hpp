#pragma once

#include "bem_contact/base/material.hpp"
#include "bem_contact/contact/problem.hpp"
#include "bem_contact/geometry/rail_slices.hpp"

#include <optional>
#include <span>

namespace bem_contact {

/// What presses the bodies together.
struct ContactLoad {
  LoadKind kind = LoadKind::force;
  double force = 0;    ///< Fz, N (a patch: along z of its frame); kind == force
  double approach = 0; ///< mm; kind == approach
};

/// The middle of a contact: what creepages of a wheel on a rail refer to.
struct ContactCentre {
  double s = 0, x = 0;       ///< arc length on the rail and along x, mm
  double ahead = 0;          ///< by how much unevenness moves it along x, mm
  double rolling_radius = 0; ///< V / omega at which the mean of w_x under the foundation's pressure is 0, mm
};

/// Centre of the pressure of an elastic foundation (Winkler) under the same load. Unlike the point of first
/// touch it moves continuously when a second area takes over the load, and so does all that refers to it.
/// Where the wheel is not near the rail there it is the nearest place that bears. Nothing where the bodies do
/// not touch.
std::optional<ContactCentre> contact_centre(std::span<const RailSlice> slices, const WheelOnRail& pair,
                                            const WheelFrame& frame, double compliance,
                                            const ContactLoad& load);

} // namespace bem_contact
