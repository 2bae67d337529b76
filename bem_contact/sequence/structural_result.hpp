#pragma once

#include "bem_contact/influence/structure.hpp"

#include <optional>

namespace bem_contact {

/// How one body gave way as a whole, about a point that is fixed in it. Track frame; of a left wheel
/// counted to the left (placement.hpp). Motions are small: mm along x, y, z; rad about them.
struct BodyMotion {
  Point2 before, after; ///< the point, where the scene puts it and where it goes, mm (y, z)
  SixNumbers force{};   ///< of the contact on the body, about `after`, N and N mm
  SixNumbers motion{};  ///< compliance times force
  /// This is the same motion as the influence numbers contain it, in the section's axes. Their forces act
  /// along the normals of the body's own profile, which differ a little from the rail's where the surfaces
  /// are not parallel.
  SixNumbers motion_in_numbers{};
  SixBySix compliance{};             ///< mm and rad under N and N mm
  std::optional<SixBySix> stiffness; ///< compliance^-1; nothing where the body does not give way
};

/// The motion of a solution that moves its geometry: of the bodies whose structural compliance is included,
/// and of the surfaces in contact.
struct StructuralResult {
  std::optional<BodyMotion> rail, wheel; ///< nothing: its compliance is not included
  /// Says whether the bodies stand where this motion takes them (StructuralMotion::placed); else the geometry
  /// is that of the undeformed position.
  bool placed = false;
  /// How far along y the wheel is moved so that it slides along the rail as the surfaces in contact do, mm;
  /// nothing where the geometry does not follow them.
  std::optional<double> shift_y;
  int solutions = 1;  ///< until the bodies stood still
  double change = 0;  ///< by how much the last solution still moved the contact, mm
  double lowered = 0; ///< of the approach: what brings the moved bodies together again, mm
};

} // namespace bem_contact
