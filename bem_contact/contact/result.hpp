#pragma once

#include "bem_contact/base/measured.hpp"
#include "bem_contact/contact/problem.hpp"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace bem_contact {

/// An element lies outside the contact, or it is in contact and sticks (adhesion) or slides (slip).
enum class ElementState : unsigned char { exterior, adhesion, slip };

/// How far a result violates the equations. It is computed from the tractions alone, by code that shares
/// nothing with the solvers. Each entry is relative; the result holds if worst() <= 1e-6. An entry that is
/// nan was not checked: so a result that nobody has checked is not certified.
///
/// Coulomb's law leaves an element in contact two states, adhesion and slip. The element counts for the one
/// that it is nearer to (`adhesion` or `slip_direction`). Scales: pressure over pmax; the approach scale is
/// the largest elastic displacement |(A p)_n| in contact; the slip scale is the largest of the rigid slip
/// w dx and of the elastic slip of one step in contact (transient and shift: also of the slip that there
/// would be without shear tractions). S is the slip of one step, mm (base/conventions.hpp). Without friction,
/// `friction_cone` is the largest |p_t| over pmax.
///
/// mu is that of the element's row. If kinetic < 1, the cone is that of adhesion, mu p_n. A slipping element
/// then carries kinetic mu p_n S/|S|, and an element that sticks may carry more. Such a solution is not
/// unique. The solvers begin with the bound mu p_n everywhere; an element that slips gets the bound kinetic
/// mu p_n and keeps it. This is repeated until no further element slips. Where outer iterations do not
/// settle, elements keep it from one to the next (coupled/settings.hpp: most_fresh_slips).
///
/// Where mu falls with slip velocity or temperature (ContactProblem::falling, heating), a slipping element
/// carries mu p_n S/|S| with the mu of its own slip and temperature, and the cone is that of no slip at this
/// temperature. Slip and temperature are computed here from the tractions.
struct Certificate {
  double pressure = unknown_error;        ///< largest -p_n, over pmax
  double penetration = unknown_error;     ///< largest -e, over the approach scale
  double complementarity = unknown_error; ///< largest p_n e, over pmax times the approach scale
  double friction_cone = unknown_error;   ///< largest |p_t| - mu p_n, over the largest mu p_n
  double adhesion = unknown_error;        ///< largest |S| where |p_t| < mu p_n, over the slip scale
  double slip_direction =
      unknown_error; ///< largest deviation of p_t from mu p_n S/|S| where it slips, over mu pmax
  /// The largest of |Fz - force| over the prescribed force, and of |Fx - force_x| and |Fs - force_s| over
  /// sum mu p_n dS, for those that are prescribed.
  double force_balance = unknown_error;
  double tolerance = 1e-6; ///< the result holds if no violation is above it
  /// What the rounding of sums may make of these violations, at most: the unit roundoff times the number of
  /// elements in contact times the largest of the terms that cancel in e and in S, over the scale of either.
  double rounding = 0;
  /// Discretisation::worst(): a relative error, not a violation; worst() leaves it out. < 0: not estimated.
  double discretisation = -1;

  /// Nothing is violated. What checks a result, or a closed form that meets the conditions by its
  /// construction, begins here and puts in what it finds.
  static Certificate without_violation();

  double worst() const; ///< largest violation; infinite if one is not a number
  /// The name of the largest violation, as the members have it.
  const char* worst_name() const;
  /// No violation is above the tolerance.
  bool holds() const { return worst() <= tolerance; }
};

/// The numbers of a whole contact, each with its stated error where one is ever stated: the error that the
/// size of the elements is estimated to cause (check/error_estimates.hpp).
///
/// Meaning of the errors: the result on elements of vanishing size lies within number +- error in about 95 of
/// 100 cases, and in the median case the stated error is two to five times the true one. Figures of each
/// number are in tools/BENCHMARKS.md, section 9.
struct ContactTotals {
  /// These are the forces on the rail, N, in the frame of the rows: the track frame of a wheel on a rail, a
  /// patch's own frame (profile/contact_row.hpp).
  Measured Fx, Fy, Fz;
  /// About the z axis of that frame, not about the contact, N mm. Its error depends on the axis:
  /// Discretisation::moment_error().
  double Mz = 0;
  Measured Fs;                     ///< sum p_s cos(delta - reference_delta) dS, N
  Measured approach;               ///< q, mm
  Measured creepage_x, creepage_s; ///< found for force_x, force_s (shift: mm); part of the slip
  /// Derivatives of creepage_x by force_x and of creepage_s by force_s, while the pressure does not change:
  /// 1/N (shift: mm/N). nan if the force is not prescribed, or if no Newton step computed them.
  double compliance_x = unknown_error, compliance_s = unknown_error;
  Measured pmax;           ///< largest pressure, MPa
  Measured area;           ///< in contact, mm^2
  Measured adhesion_share; ///< elements in adhesion over those in contact; 0 without contact
  Measured T_gamma;        ///< power of friction: sum of friction_work_density() dS, N (shift: N mm)
  /// Highest of SurfaceTemperatures, degrees C; nan: the problem has no `heating`.
  Measured Tmax_rail{unknown_error}, Tmax_wheel{unknown_error};
};

/// What a stated error is the weighted sum of, in the unit of the number. The weights are those of
/// contact::ErrorShares, whose members have the same names (check/error_shares.hpp).
struct ErrorParts {
  double change = 0, local = 0, peak = 0, adhesion = 0; ///< as there
  double fixed = 0;                                     ///< what no share weighs
};

/// The parts of the errors of ContactTotals: tools/benchmarks/estimates fits the shares to them.
struct PartsOfTotals {
  ErrorParts Fx, Fs, Fy;                           ///< of the forces on the rail
  ErrorParts approach, pmax, area, adhesion_share; ///< of the normal contact, and its part in adhesion
  ErrorParts T_gamma;                              ///< of the power of friction
  ErrorParts creepage_x, creepage_s;               ///< of those that are found
  ErrorParts Tmax_rail, Tmax_wheel;                ///< of the highest temperatures
  ErrorParts moment; ///< Discretisation::moment_error(); `change` is by 1 N mm of the moment's change
};

/// Estimate of the error that the size of the elements causes, from the same problem on elements twice as
/// large in x and s (the companion; same load). There is no estimate where the contact touches the border of
/// the grid, without contact, for a transient rolling step, where the companion has fewer than 40 elements in
/// contact (7 in a single row or column), and where one of the two did not converge. If the grid has an odd
/// number of rows or columns, the companion leaves out an exterior one.
///
/// `extrapolated` is fine + (fine - coarse) / 3, for errors of second order; prescribed values stay. The
/// fields (tractions, pmax) are not extrapolated.
///
/// Each estimate is a relative error. For `approach` and `normal` it is this third, |fine - coarse| / 3: 0.4
/// to 2 times the true error on Hertz contacts. For `tangential` and `moment` it is the whole difference.
/// Whole elements cover an area beyond the patch, up to 1.2 % of its area with 40 elements across.
/// That area does not shrink in step with their size, and the area of adhesion behaves likewise.
struct Discretisation {
  int contact = 0;                    ///< elements of the companion in contact
  ContactTotals coarse, extrapolated; ///< of the companion; and as above
  Tractions tractions;                ///< of the companion
  double approach = 0;   ///< error of q, over the largest PatchSummary::overlap; 0 if q is prescribed
  double normal = 0;     ///< error of the force of p_n as a vector in (y, z), over sum p_n dS
  double tangential = 0; ///< error of the vector (sum p_x dS, sum p_s dS), over sum mu p_n dS
  /// Error of the moment of p_t about the centre of pressure, over sum mu p_n r dS, r the distance from it.
  double moment = 0;

  /// False: the pressure depends on the elements so much that its error cannot be told, and is nan. A peak is
  /// narrower than three elements, or a profile has noise or a kink.
  bool converges = true;
  /// Where it does not: the undeformed distance itself is rough, so that smaller elements hardly help and no
  /// error at all is told.
  bool rough = false;
  double moment_change = unknown_error; ///< share of a change of the moment that counts in moment_error(), 1
  double local_moment = unknown_error;  ///< the local part of moment_error() (error_estimates.hpp), N mm
  PartsOfTotals parts;                  ///< of the stated errors; all 0 where there are none

  /// Absolute error of the moment about the vertical axis through x and y (mm, frame of the rows), N mm.
  /// `totals`: those of the result that this estimate is of.
  double moment_error(const ContactTotals& totals, double x, double y) const;

  /// The largest of the four relative errors.
  double worst() const { return std::max({approach, normal, tangential, moment}); }
};

/// A patch: connected elements in contact. Errors are as those of ContactTotals. They are nan too where the
/// coarser elements have other patches.
struct PatchSummary {
  /// N. Sums over the patch of p_n dS, p_x dS and p_s dS, as numbers: the directions n and s may turn from
  /// row to row.
  Measured fn, fx, fs;
  Measured overlap;                        ///< largest q cos(delta) - h in the patch, mm
  Measured pmax;                           ///< MPa
  Measured area;                           ///< mm^2
  int contact = 0, adhesion = 0, slip = 0; ///< element counts
  double x = 0, s = 0;                     ///< centre of pressure: x of the grid, arc length of the rows, mm
  Point2 position;                         ///< of that centre on the rows, frame of the rows, mm
  double delta = 0;                        ///< inclination there, rad
  Measured fy, fz;                         ///< on the rail, N, frame of the rows
  /// These are the moments on the rail about that centre, N mm: about x, and about the directions s and n
  /// there.
  double moment_x = 0, moment_s = 0;
  Measured moment_n; ///< see there
  Measured T_gamma;  ///< as ContactTotals::T_gamma, N (shift: N mm)
  /// Semi-axes of the ellipse whose Hertzian pressure has the second moments of this pressure, mm: `a` of the
  /// axis nearest to x, turned from x towards s by `axis_angle` (-pi/4 .. pi/4), rad. Plane strain: b is half
  /// the width of such a strip, and a is nan.
  double semi_axis_a = 0, semi_axis_b = 0, axis_angle = 0;
};

/// Holds the temperatures of the surfaces of rail and wheel, degrees C; fields.
struct SurfaceTemperatures {
  std::vector<double> rail, wheel; ///< of each surface

  double mean(std::size_t i) const { return 0.5 * (rail[i] + wheel[i]); } ///< of both, at an element
};

/// Displacement differences u = u_wheel - u_rail = -A p of every element, mm; fields.
struct Displacements {
  std::vector<double> ux, us, un; ///< along x, s and n
};

/// The solution itself. Fields: [ms][mx], as ContactGrid has its elements.
struct ContactFields {
  std::vector<double> px, ps, pn; ///< tractions on the rail, MPa; fields
  /// Slip per unit of rolled distance (shift: mm), with all parts: rigid, found creepage, elastic; fields.
  std::vector<double> slip_x, slip_s;
  std::vector<double> deformed_distance; ///< e, mm; field
  std::vector<double> plastic;           ///< plastic slip of a layer that yields, mm; field; empty: none
  std::vector<double> dissipated;        ///< friction_work_density(); empty: p_t S is all of it; field
  std::vector<ElementState> state;       ///< field
  Displacements displacements;           ///< empty unless SolverOptions::displacements
  std::optional<SurfaceTemperatures> temperatures; ///< where the problem has `heating`
};

/// Whether a result is a solution, how near it is to that of vanishing elements, and what else speaks against
/// it.
struct Trust {
  Certificate certificate;                      ///< look at it first
  std::optional<Discretisation> discretisation; ///< nothing: not estimated
  std::string why_no_errors;   ///< why there is no `discretisation`, and what to do; "" where there is one
  bool touches_border = false; ///< contact at an edge of the grid: the potential contact is too small
  bool ended_early = false;    ///< a rough solution, as SolverOptions::early_end wants it; not certified
  std::string solver_note;     ///< why a solver of the chain gave up, or ""
};

/// What a solution took, and which solvers made it.
struct Effort {
  std::string normal_solver, tangential_solver;                               ///< those that finished
  int outer_iterations = 0, normal_iterations = 0, tangential_iterations = 0; ///< in all
  int creepage_iterations = 0; ///< tangential problems solved to find the creepages of prescribed forces
  double work = 0;             ///< of the case so far, companion included: work.hpp
  double check_seconds = 0;    ///< wall clock, of the certificate and the displacements
  double estimate_seconds = 0; ///< of the companion
  /// Mean factor by which an outer iteration changed the residual; 0: there was only one outer iteration.
  double outer_rate = 0;
};

/// The answer to one contact problem: the fields of its solution, what they add up to, why to trust it, and
/// what it took.
struct ContactResult : ContactFields {
  ContactTotals totals;              ///< what the fields add up to
  std::vector<PatchSummary> patches; ///< largest force first
  Trust trust;                       ///< certificate, estimate of the errors, remarks
  Effort effort;                     ///< solvers, iterations, seconds

  bool certified() const { return trust.certificate.holds(); } ///< it is a solution
};

/// The tractions of a result, as those of a former rolling step or load step.
Tractions tractions_of(const ContactResult& result);

/// The power that friction dissipates on each element per area and unit of rolled distance (shift: the work
/// of the load step per area), MPa (shift: MPa mm); field. It is p_x slip_x + p_s slip_s, and in steady
/// rolling what waves of the tractions lose on elements besides (contact/dissipation.hpp).
std::vector<double> friction_work_density(const ContactResult& result);

/// Force along x, y, z and moment about them, at a point of the plane x = 0, of the tractions on these rows;
/// N, N mm. `side_x`, `side`: signs of those along x and of the others.
std::array<double, 6> force_and_moment(const ContactProblem& problem, const ContactResult& result,
                                       const std::vector<ContactRow>& rows, Point2 about, double side_x = 1,
                                       double side = 1);

/// The largest shear traction that element i may have, mu p_n or what a layer bears after its plastic slip,
/// MPa.
double shear_bound(const ContactProblem& problem, const ContactResult& result, int i);

/// Sum of mu p_n dS, or of what a layer bears, N: no shear force is larger. 0 without friction.
double friction_bound(const ContactProblem& problem, const ContactResult& result);

/// The elements of each patch (8 neighbours), in the order of ContactResult::patches.
std::vector<std::vector<int>> patch_elements(const ContactProblem& problem, const ContactResult& result);

/// Elements of all patches. Each one in contact either adheres or slips.
struct ElementCounts {
  int contact = 0, adhesion = 0, slip = 0; ///< contact = adhesion + slip
};
/// Counts them.
ElementCounts count_elements(const ContactResult& result);

} // namespace bem_contact
