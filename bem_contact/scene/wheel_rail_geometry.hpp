#pragma once

#include "bem_contact/geometry/contact_locus.hpp"
#include "bem_contact/geometry/contact_search.hpp"
#include "bem_contact/geometry/plane_motion.hpp"
#include "bem_contact/geometry/rail_slices.hpp"
#include "bem_contact/geometry/rigid_slip.hpp"
#include "bem_contact/scene/grid_plan.hpp"
#include "bem_contact/scene/scene_file.hpp"
#include "bem_contact/scene/sectioned_bodies.hpp"

#include <future>
#include <memory>
#include <optional>
#include <vector>

namespace bem_contact {

/// Says by how much a rail is turned in its file (rail_turn() of like_standard.hpp), rad; 0 of a standard
/// profile. It is found by whoever first asks for it: few do, and it takes as long as many a contact.
using RailInclination = std::shared_future<double>;

/// Holds both profiles, tabulated. They are read once for a sequence of cases with the same bodies.
struct WheelRailProfiles {
  TabulatedProfile rail, wheel;
  RailInclination rail_inclination;                    ///< that the rail's file has already
  SectionedBodies rail_bodies = {}, wheel_bodies = {}; ///< `rail` and `wheel` are their first sections
};
WheelRailProfiles read_profiles(const SceneFile& scene);
/// Both bodies of the scene with the wheelset at `position` (place()).
WheelOnRail placed_bodies(const SceneFile& scene, const WheelRailProfiles& profiles,
                          const WheelsetPosition& position);
RailInclination inclination_of_rail(const std::string& name, const ProfileCurve& rail);

/// The bodies of a `wheel_rail` scene, the wheel lowered until it just touches.
struct WheelRailGeometry {
  WheelOnRail pair;
  ContactLocus locus;            ///< of the pair as it stands
  std::vector<TouchPoint> touch; ///< the deepest first
  std::vector<RailSlice> slices; ///< the whole head of the rail
  double lowered = 0;            ///< by this much from where the height of its axle puts it, mm
  bool planar = false;      ///< rows lie in planes that touch the rail, one for each patch (GridPlan::planes)
  ReferencePoint reference; ///< centre of the contact; the deepest point where nothing touches
  double contact_radius = 0;        ///< of the wheel at that centre, mm
  RailInclination rail_inclination; ///< of the rail in its file, before position.rail_inclination
  std::optional<StructuralPlacement> structure = {}; ///< where structural motion has moved the bodies

  /// Radius of the roller at the reference point, mm; 0 on a straight rail.
  double roller_contact_radius() const { return pair.roller ? pair.roller->radius(reference.position) : 0; }
  std::vector<ContactRow> rows(const GridPlan& plan) const;
  /// Arc length of rows on the rail and on the wheel, mm.
  std::vector<double> rail_stations(const std::vector<ContactRow>& rows) const;
  std::vector<double> wheel_stations(const std::vector<ContactRow>& rows) const;
  /// Undeformed distance along n, mm; field of the plan's grid. If structural motion has moved the bodies,
  /// that motion is subtracted, because influence numbers with structural compliance add it. Numbers and
  /// approach then mean the same as on bodies that stand where the scene puts them.
  std::vector<double> gap(const GridPlan& plan, const std::vector<ContactRow>& rows) const;
};

} // namespace bem_contact
