#pragma once

#include "bem_contact/wheelset/pair_numbers.hpp"
#include "bem_contact/wheelset/potential_contact.hpp"
#include "bem_contact/wheelset/scene.hpp"

#include <utility>

namespace bem_contact {

/// A `wheel_rail` scene: the bodies in touch, and the grid that is solved for.
struct WheelRailScene {
  WheelOnRail pair;
  std::vector<TouchPoint> touch; ///< the deepest first
  ContactEstimate estimate;
  ReferencePoint reference; ///< the deepest point
  GridPlan plan;
};

/// Reads the profiles, places the bodies, lowers the wheel until it touches, estimates the contact.
WheelRailScene place_wheel_rail(const SceneFile& scene);

/// Rows centred on the stations of the rail's influence file where there is one.
GridPlan plan_wheel_rail(const WheelRailScene& placed, const SceneFile& scene, const PairFiles& files);

/// The contact on the rows and columns of `placed.plan`: gap, rigid slip, stations on both bodies.
PreparedContact prepare_wheel_rail(const WheelRailScene& placed, const SceneFile& scene);

/// Both profiles around the rows s_from .. s_to of the rail, for pictures (track frame, plane x = 0).
std::pair<std::vector<Point2>, std::vector<Point2>> profiles_near(const WheelRailScene& placed, double s_from,
                                                                  double s_to);
/// In words: touch points and the estimate.
std::vector<std::string> describe(const WheelRailScene& placed);

} // namespace bem_contact
