#pragma once

#include "bem_contact/geometry/contact_search.hpp"
#include "bem_contact/sequence/pair_numbers.hpp"
#include "bem_contact/sequence/potential_contact.hpp"
#include "bem_contact/sequence/solve_scene.hpp"

#include <utility>

namespace bem_contact {

/// A `wheel_rail` scene: the bodies in touch, and the grid that is solved for.
struct WheelRailScene {
  WheelOnRail pair;
  ContactLocus locus;            ///< of the pair as it stands
  std::vector<TouchPoint> touch; ///< the deepest first
  ContactEstimate estimate;
  ReferencePoint reference;  ///< the estimate's centre; the deepest point where nothing touches
  double rolling_radius = 0; ///< V / omega where xi = 0: the scene's, or the estimate's, mm
  double approach = 0;       ///< mm; where the scene prescribes it or the height of the wheelset
  GridPlan plan;
};

/// As the placement wants it.
WheelsetPosition wheelset_of(const SceneFile::Position& position);

/// Both profiles, tabulated: read once for a sequence of cases with the same bodies.
struct WheelRailProfiles {
  TabulatedProfile rail, wheel;
};
WheelRailProfiles read_profiles(const SceneFile& scene);

/// Places the bodies, lowers the wheel until it touches, estimates the contact. Without profiles, reads them.
/// With position.vertical the approach is what the wheelset stands lower than where it first touches.
/// `foresee_shear`: the estimate knows what shear bears of the load.
WheelRailScene place_wheel_rail(const SceneFile& scene, const WheelRailProfiles& profiles,
                                bool foresee_shear = true);
WheelRailScene place_wheel_rail(const SceneFile& scene);

/// Rows centred on the stations of the rail's influence file where there is one.
GridPlan plan_wheel_rail(const WheelRailScene& placed, const SceneFile& scene, const PairFiles& files);

/// The contact on the rows and columns of `placed.plan`: gap, rigid slip, stations on both bodies.
PreparedContact prepare_wheel_rail(const WheelRailScene& placed, const SceneFile& scene);

/// Both profiles around the rows s_from .. s_to of the rail, for pictures (track frame, the wheel's contact
/// locus).
std::pair<std::vector<Point2>, std::vector<Point2>> profiles_near(const WheelRailScene& placed, double s_from,
                                                                  double s_to);
/// In words: touch points and the estimate.
std::vector<std::string> describe(const WheelRailScene& placed);

} // namespace bem_contact
