#pragma once

#include "bem_contact/scene/contact_setup.hpp"
#include "bem_contact/scene/settings.hpp"

#include <optional>
#include <vector>

namespace bem_contact {

/// How a pair of bodies yields to pressure.
struct PairCompliance {
  double elastic = 0; ///< contact_compliance() of the materials, 1/MPa
  double layer = 0;   ///< of a layer between them, mm^3/N

  PairCompliance(double of_bodies, double of_layer = 0) : elastic(of_bodies), layer(of_layer) {}
};
PairCompliance pair_compliance(const ContactSetup& setup);

/// A Hertz-like estimate of where and how far the bodies touch. Semi-Hertzian method of Kik and Piotrowski
/// (1996): the contact is where they would overlap at 0.55 of the approach. A layer that yields to pressure
/// is in series with them: alone, as a foundation (Winkler), it touches wherever the bodies would overlap.
/// The share of the approach is between the two as the approach is.
struct ContactEstimate {
  std::vector<RailSlice> slices; ///< the whole head of the rail
  /// There is one value for each slice: the vertical force of pressure and shear together, divided by that of
  /// the pressure.
  std::vector<double> lift;
  double approach = 0;                    ///< mm
  double force = 0;                       ///< vertical, N
  double penetration = penetration_share; ///< 1: the contact is where bodies overlap at this of the approach
};

/// Estimates a contact without shear.
ContactEstimate estimate_contact(std::vector<RailSlice> slices, const PairCompliance& compliance,
                                 const ContactLoad& load);

/// Estimates the contact of a `wheel_rail` scene. `foresee_shear`: shear bears its part of a prescribed
/// force, as if all slipped, less where creepages are small. On a flange the pressure may be many times what
/// it is without friction. Throws InputError where the bodies approach by more than elasticity allows.
ContactEstimate estimate_contact(const ContactSetup& setup, bool foresee_shear);

/// What the estimate says of the area that bears most.
struct EstimatedContact {
  double normal = 0;            ///< normal force, of all areas, N
  double lateral = 0;           ///< force of the pressure along y on the rail, of all areas, N
  double pressure = 0;          ///< largest, MPa
  double turn = 0;              ///< of the normal, rad
  double length = 0, width = 0; ///< along x and s, mm
  double x = 0;                 ///< its deepest slice: along the rail, mm
  double s = 0;                 ///< arc length, mm
  double delta = 0;             ///< inclination, rad
  Point2 position;              ///< on the rail
};
/// Estimates the contact under the vertical force of the estimate, with the wheel `shift_y` mm further along
/// y. Its distance from the rail then changes by the part of that shift along the normal.
EstimatedContact estimated_contact(const ContactEstimate& estimate, const PairCompliance& compliance,
                                   double shift_y = 0);

/// One area of the estimate.
struct EstimatedArea {
  double normal = 0;          ///< force, N
  double x = 0, s = 0;        ///< middle: of the deepest slice along x, of the overlap along s, mm
  double delta = 0;           ///< inclination there, rad
  double half = 0, depth = 0; ///< of the deepest slice: half the curvature along x, 1/mm; overlap, mm
  double overlap = 0; ///< area where the bodies would overlap at the estimate's share of the approach, mm^2
};
/// All areas that touch, along s.
std::vector<EstimatedArea> estimated_areas(const ContactEstimate& estimate, const PairCompliance& compliance);

/// Uses the same method on the rows of a problem, whose undeformed distance is known. Returns nothing in
/// plane strain, and on fewer than three columns.
std::optional<ContactEstimate> estimate_contact(const ContactProblem& problem,
                                                const PairCompliance& compliance);

} // namespace bem_contact
