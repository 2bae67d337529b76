#pragma once

#include "bem_contact/influence/influence_function.hpp"
#include "bem_contact/scene/contact_centre.hpp"
#include "bem_contact/scene/contact_layer.hpp"
#include "bem_contact/scene/motion.hpp"
#include "bem_contact/scene/patch_geometry.hpp"
#include "bem_contact/scene/wheel_rail_geometry.hpp"

#include <filesystem>
#include <memory>
#include <optional>
#include <variant>
#include <vector>

namespace bem_contact {

/// Which of the influence functions of neighbouring sections of a rail count: all, by where the contact lies
/// between them, or those of one of the two alone.
enum class SectionEnd { blended, before, after };

/// One of the two bodies.
struct Body {
  Material material;
  std::filesystem::path influence; ///< file of its influence functions; empty: none
  StructuralCompliance structural = StructuralCompliance::removed;
  std::optional<double> limit_pressure = {};   ///< that its surface bears, MPa; empty: it is elastic
  std::vector<SectionInfluence> sections = {}; ///< instead of `influence`, of a rail of sections
  SectionEnd section_end = SectionEnd::blended;

  bool has_influence() const { return !influence.empty() || !sections.empty(); }
  bool operator==(const Body&) const = default;
};

/// Rows of a grid, and where they lie on the two bodies (arc length, mm).
struct RowsOnBodies {
  std::vector<ContactRow> rows;
  std::vector<double> rail_s, wheel_s;
};

/// The contact on the elements of one plan.
struct ContactOnGrid {
  GridPlan plan;
  ContactProblem problem;              ///< complete but for the values of the influence numbers
  std::vector<double> rail_s, wheel_s; ///< arc length of each row on the lower and the upper body, mm
  double contact_radius = 0;           ///< of a wheel, at the contact, mm; 0: none
  double roller_contact_radius = 0;    ///< of a roller, there, mm; 0: the lower body is straight along x
  SurfaceLayer layer;                  ///< between the bodies; not in any influence numbers yet
};

/// What a scene asks: who the bodies are, what presses them together, how they move, and how far apart they
/// are. Both kinds of scene become one; it is complete when it is made. Cheap to copy: copies share geometry.
struct ContactSetup {
  Body rail, wheel; ///< the lower and the upper body
  ContactLoad load; ///< along z of the frame in which a rail of sections is looked at (WheelOnRail)
  Motion motion;
  std::shared_ptr<const std::variant<WheelRailGeometry, PatchGeometry>> geometry;
  ContactLayer layer;

  const WheelRailGeometry* wheel_rail() const { return std::get_if<WheelRailGeometry>(geometry.get()); }
  const PatchGeometry* patch() const { return std::get_if<PatchGeometry>(geometry.get()); }
  /// Where creepages and moments refer to; of a patch: the middle of the grid.
  ReferencePoint reference() const { return wheel_rail() ? wheel_rail()->reference : ReferencePoint{}; }
  /// Returns the distance from the load, mm, at which displacements vanish in plane strain, where they are
  /// only known up to a constant. It is the radius of a curved strip, else plane_strain_distance.
  double reference_distance() const;

  /// The lower limit of the pressure of both bodies, MPa; nothing where neither has one.
  std::optional<double> limit_pressure() const;

  RowsOnBodies rows_on(const GridPlan& plan) const;
  /// The problem on these elements, with what the scene prescribes for its first step. Throws InputError
  /// where rows leave the rail.
  ContactOnGrid on(const GridPlan& plan) const;
  /// Load, rigid slip and shear forces of one step of a history.
  void prescribe(const MotionStep& step, ContactProblem& problem) const;
  /// Rigid slip of elements of a wheel on a rail, or of a patch on its own grid.
  RigidSlip rigid_slip(const MotionStep& step, const std::vector<ContactRow>& rows,
                       const std::vector<double>& x) const;
};

/// A `wheel_rail` scene. With position.vertical the approach is how far the wheelset stands below the height
/// at which it first touches. Throws InputError for a scene whose bodies do not meet, or tables that cannot
/// be used.
ContactSetup set_up_contact(const SceneFile& scene, const WheelRailProfiles& profiles);
/// The same scene with the bodies of `setup` moved by their structures' motion, and the wheel lowered until
/// it touches again: contact search, reference point and rigid slip follow. A prescribed approach is counted
/// from there: without what the wheel was lowered by. Throws InputError where the bodies no longer meet.
ContactSetup moved(const SceneFile& scene, const ContactSetup& setup, StructuralPlacement by);
/// The same bodies where they stand, with the motion, the friction and the layer of `scene`: a scene that
/// differs in nothing else. The bodies touch.
ContactSetup with_motion_of(const SceneFile& scene, const ContactSetup& setup);
/// A `patch` scene. Throws InputError for tables that cannot be used, and for a load that the grid cannot
/// bear.
ContactSetup set_up_patch(const SceneFile& scene);

} // namespace bem_contact
