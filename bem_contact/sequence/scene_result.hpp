#pragma once

#include "bem_contact/base/material.hpp"
#include "bem_contact/contact/history.hpp"
#include "bem_contact/contact/layer.hpp"
#include "bem_contact/geometry/conformity.hpp"
#include "bem_contact/geometry/rail_frame.hpp"
#include "bem_contact/geometry/rigid_slip.hpp"
#include "bem_contact/geometry/sectioned_rail.hpp"
#include "bem_contact/scene/choices.hpp"
#include "bem_contact/scene/warning.hpp"
#include "bem_contact/sequence/derivatives.hpp"
#include "bem_contact/sequence/patch_place.hpp"
#include "bem_contact/sequence/stresses.hpp"
#include "bem_contact/sequence/structural_result.hpp"

#include <algorithm>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace bem_contact {

/// Wall-clock seconds by phase.
struct PhaseSeconds {
  double geometry = 0;     ///< files, profiles, contact search, undeformed distance
  double numbers = 0;      ///< influence numbers
  double solve = 0;        ///< pressures and shear tractions
  double check = 0;        ///< certificate and displacements
  double estimate = 0;     ///< the same on elements twice as large, for the stated errors
  double free_rolling = 0; ///< all that finds free rolling
  double search = 0;       ///< all that finds the lateral displacement for load.force_y
  double total = 0;        ///< all of the call

  /// Adds the seconds of another call.
  PhaseSeconds& operator+=(const PhaseSeconds& other) {
    geometry += other.geometry;
    numbers += other.numbers;
    solve += other.solve;
    check += other.check;
    estimate += other.estimate;
    free_rolling += other.free_rolling;
    search += other.search;
    total += other.total;
    return *this;
  }
};

/// Steady rolling in which the wheel transmits no longitudinal force (Fx = 0); everything else is as
/// prescribed.
struct FreeRolling {
  Measured xi;               ///< its creepage, counted as SceneMotion::xi is
  double rolling_radius = 0; ///< forward over angular speed of the wheel, mm
  double contact_radius = 0; ///< SceneMotion::contact_radius, mm
  double zero_radius = 0;    ///< the rolling radius from which xi is counted, mm

  /// The rolling radius with its error, mm.
  Measured radius() const { return {rolling_radius, rolling_radius * xi.error / (1 - xi)}; }
};

/// Says where the wheelset stands so that the lateral force is load.force_y.
struct LateralPosition {
  Measured lateral; ///< position.lateral, mm: as far away as its error Fy is the same within its own
  double slope = 0; ///< dFy/dy there, N/mm
  std::vector<double> others; ///< others with the same force, to some tenths of a millimetre, mm; looked for
                              ///< where the start is none
  int solutions = 0, rough = 0; ///< of the model, and rough ones of half-spaces, that it took
};

/// The model that a scene is solved with, and why: two short sentences at most.
struct ModelChoice {
  Model model = Model::halfspace; ///< the one
  std::string why_this_model;     ///< in words
  bool enough = true;   ///< false: fem would be needed, and it cannot be taken; `why_this_model` says why
  bool by_turn = false; ///< chosen by how far the normal turns within the patch, among models with numbers
};

/// Where the wheel stands, and how it moves over the rail.
struct SceneMotion {
  ReferencePoint reference;      ///< of approach, creepages and moment
  bool left = false;             ///< left wheel: y and s are counted to the left (placement.hpp)
  std::optional<double> lateral; ///< wheel_rail: position.lateral, mm: given, or found for load.force_y
  std::optional<LateralPosition> found_lateral; ///< where load.force_y is given
  /// wheel_rail: by how much the wheelset's centre is lower where the bodies first touch than wheel_radius
  /// above the rail, mm.
  std::optional<double> lowered;
  /// The longitudinal force of the pressure on an uneven rail, N; 0 where the wheel alone
  /// is uneven. Fx is that of the shear tractions.
  std::optional<double> slope_force;
  /// A rail of sections has the fields of elements in this frame. Totals and patches are in the track's.
  std::optional<RailFrame> frame;
  /// Creepages at the reference point, with what was found for prescribed forces. wheel_rail: xi is counted
  /// from motion.rolling_radius, and phi is without the spin of the geometry. Shift: mm, mm and rad. 0
  /// without friction and where a table gives the rigid slip.
  double xi = 0, eta = 0, phi = 0;
  /// wheel_rail: forward over angular speed of the wheel at xi = 0 is motion.rolling_radius, or that of the
  /// contact's centre on the bodies as they are placed. Its radius is 0 of a patch.
  RollingSpeed rolling;
  /// wheel_rail: radius_at() of the contact, mean weighted with the pressure, mm. 0 of a patch. A slip w_x of
  /// the whole contact is that of the creepage xi = w_x rolling.radius / contact_radius.
  double contact_radius = 0;
  /// wheel_rail, steady with friction, unless the scene leaves it out.
  std::optional<FreeRolling> free_rolling;
};

/// What outputs say of the two bodies.
struct SceneBodies {
  double rail_poisson = Material{}.poisson;  ///< of the rail (patch: of the lower body), for stresses in it
  double wheel_poisson = Material{}.poisson; ///< of the other one
  /// ProfileCurve::digest() of both profiles, as influence files have it; 0 of a patch.
  std::uint64_t rail_geometry = 0, wheel_geometry = 0;
  std::vector<double> wheel_s; ///< station on the upper body of each row, mm; empty where it has none
  std::vector<double> rail_s;  ///< of a patch on influence files: that on the lower body; else empty
  std::vector<Point2> rail_profile, wheel_profile;    ///< Outlines: at approach 0, frame of the rows, mm
  std::shared_ptr<const SectionedRail> rail_sections; ///< of a rail of sections, as it is looked at
};

/// One scene solved with one model.
struct SceneResult {
  ModelChoice choice;     ///< that it was solved with
  ContactProblem problem; ///< grid, rows (wheel_rail: track frame), undeformed distance, rigid slip; without
                          ///< the values of the influence numbers
  SurfaceLayer layer;     ///< between the bodies, as given or found for layer.slope
  double layer_slope = 1; ///< estimated_slope() (solution/layer_slope.hpp)
  ContactResult result;   ///< of the last step
  std::vector<ContactResult> history;        ///< transient and shift: of every step
  std::vector<PatchPlace> patch_places;      ///< of result.patches, in their order
  SceneMotion motion;                        ///< of the wheel over the rail
  Measured moment;                           ///< Mz about the vertical through the reference point, N mm
  SceneBodies bodies;                        ///< as outputs show them
  std::optional<StressesBelow> stresses;     ///< where the scene asks for them
  std::vector<InputDerivatives> derivatives; ///< with respect to what the scene names
  std::vector<ProfileDerivatives> profile_derivatives; ///< likewise
  std::optional<Conformity> conformity;      ///< wheel_rail: of the rigid bodies at this displacement
  std::optional<StructuralResult> structure; ///< fem with structural compliance of at least one body
  /// Says in words: the approach is the relative displacement of these points of the two bodies. Approaches
  /// with different datums must not be compared.
  std::string approach_datum;
  std::string track;    ///< where wheel and rail stand (track_text()); "" of a patch
  Warnings warnings;    ///< what to know before the numbers are used
  PhaseSeconds seconds; ///< what the call took
};

/// Mz about the vertical axis through the reference point with its error, N mm.
inline Measured moment_about(const ReferencePoint& reference, const ContactResult& result) {
  const double x = reference.x, y = reference.position.y;
  const ContactTotals& totals = result.totals;
  const auto& estimate = result.trust.discretisation;
  return {totals.Mz + y * totals.Fx - x * totals.Fy,
          estimate ? estimate->moment_error(totals, x, y) : unknown_error};
}

/// Says whether every step is a solution, the last one by its certificate.
inline bool certified(const SceneResult& r) {
  return r.result.certified() && std::ranges::all_of(r.history, &ContactResult::certified);
}

} // namespace bem_contact
