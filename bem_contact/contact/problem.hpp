#pragma once

#include "bem_contact/influence/influence_numbers.hpp"
#include "bem_contact/profile/contact_row.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

namespace bem_contact {

/// Regular grid of the potential contact: element (ix, is) has its centre at (x0 + ix dx, row is), is
/// element is * mx + ix of every field below ("field": [ms][mx], row-major, x fastest).
struct ContactGrid {
  int mx = 0, ms = 0;
  double dx = 0, ds = 0; ///< mm
  double x0 = 0;         ///< centre of the first column, mm

  int size() const { return mx * ms; }
  double x(int ix) const { return x0 + ix * dx; }
  std::vector<double> columns() const { ///< x of each, mm
    std::vector<double> all(mx);
    for (int ix = 0; ix < mx; ++ix)
      all[ix] = x(ix);
    return all;
  }
};

enum class LoadKind { approach, force };

/// How the surfaces move over each other. Slip S, one step of each: slip_step.hpp.
///   steady     rolling that no longer changes; grid moves with the contact
///   transient  one step of rolling by dx from `previous`; grid moves with the contact, by dx
///   shift      one step from `previous` on a grid that lies still: Cattaneo's shift, or rolling on a fixed
///              grid, the undeformed distance moving over it. The rigid slip is given in mm
enum class MotionKind { steady, transient, shift };

/// Of a former step, on the same grid; fields.
struct Tractions {
  std::vector<double> px, ps, pn; ///< MPa
};

/// One contact problem. Signs: base/conventions.hpp.
struct ContactProblem {
  ContactGrid grid;
  std::vector<ContactRow> rows; ///< ms of them
  InfluenceNumbers numbers;     ///< of the pair, grid.mx + 2 offsets, grid.ms rows
  std::vector<double> gap;      ///< undeformed distance along n at approach 0, mm; field
  LoadKind load = LoadKind::force;
  double approach = 0;                ///< q along z, mm (load == approach)
  double force = 0;                   ///< Fz, N (load == force); per mm of length in plane strain
  bool tangential = true;             ///< false: frictionless
  double friction = 0.3;              ///< Coulomb's mu, of adhesion
  std::vector<double> friction_rows;  ///< mu of each row instead; empty: the same everywhere
  double kinetic = 1;                 ///< mu of slip over mu of adhesion, in (0, 1]
  std::vector<double> slip_x, slip_s; ///< rigid slip w, per unit of rolled distance (shift: mm); fields
  /// Forces prescribed, N on the rail: sum p_x dS and sum p_s cos(delta - reference_delta) dS. A rigid slip
  /// that goes with each, (1, 0) or (0, cos(delta - reference_delta)) times an unknown creepage, is added to
  /// w.
  std::optional<double> force_x, force_s;
  double reference_delta = 0; ///< rad
  MotionKind motion = MotionKind::steady;
  /// Transient: of one and of two steps ago; shift: of one step ago. Fewer: from rest, without tractions.
  std::vector<Tractions> previous;

  /// One element, infinitely long along x: mx = 1, numbers of one offset and dx = 0, no friction; forces per
  /// mm.
  bool plane_strain() const { return numbers.dx == 0; }
  double element_area() const { return plane_strain() ? grid.ds : grid.dx * grid.ds; } ///< mm^2
  double friction_of(int row) const { return friction_rows.empty() ? friction : friction_rows[row]; }
  double largest_friction() const {
    return friction_rows.empty() ? friction : *std::max_element(friction_rows.begin(), friction_rows.end());
  }
  bool has_friction() const { return tangential && largest_friction() > 0; }
  /// What a creepage along s is on a row: cos(delta - reference_delta).
  double lateral_share(int row) const { return std::cos(rows[row].delta - reference_delta); }
};

enum class ElementState : unsigned char { exterior, adhesion, slip };

/// Violations computed from the tractions alone, by a path that shares nothing with the solver; each is
/// relative and the result holds when worst() <= 1e-6. Coulomb's law leaves an element in contact two states;
/// it counts under the one it is nearer to (`adhesion` or `slip_direction`). Scales: pmax; the approach scale
/// is the largest elastic displacement |(A p)_n| in contact; the slip scale is the largest of the rigid slip
/// w dx and of the elastic slip over one step in contact (transient and shift: also of the slip there would
/// be without shear tractions). Without friction the cone is |p_t| over pmax.
///
/// mu is that of the element's row. Where kinetic < 1 the cone is that of adhesion, mu p_n, and a slipping
/// element has kinetic mu p_n S/|S|: whatever sticks may carry more than what slips. Such a solution is not
/// the only one: ours has the elements stick that, all others sticking too, would not have begun to slip.
struct Certificate {
  double pressure = 0;        ///< largest -p_n, over pmax
  double penetration = 0;     ///< largest -e, over the approach scale
  double complementarity = 0; ///< largest p_n e, over pmax times the approach scale
  double friction_cone = 0;   ///< largest |p_t| - mu p_n, over mu pmax
  double adhesion = 0;        ///< largest |S| where |p_t| < mu p_n, over the slip scale
  double slip_direction = 0;  ///< largest deviation of p_t from mu p_n S/|S| where it slips, over mu pmax
  double force_balance = 0;   ///< |Fz - prescribed| over prescribed; of Fx, Fs over sum mu p_n dS
  double tolerance = 1e-6;
  double discretisation = -1; ///< Discretisation::worst(), a share and no violation; < 0: not estimated

  double worst() const;
  bool holds() const { return worst() <= tolerance; }
};

struct ContactTotals {
  double Fx = 0, Fy = 0, Fz = 0, Mz = 0, approach = 0; ///< as in ContactResult
  double creepage_x = 0, creepage_s = 0;
};

/// What the size of the elements costs, estimated from the same problem on elements twice as large in x and s
/// (the companion; same load). Not estimated where the contact touches the border of the grid, where there is
/// none, of a transient step, where the companion has fewer than 40 elements in contact (7 in a single row or
/// column), and where one of the two did not converge. Odd sizes leave out an exterior row or column.
///
/// `extrapolated`: fine + (fine - coarse) / 3, second order; what is prescribed stays. The estimates are this
/// third for the sums of p_n and the approach (.4 to 2 times the true error on Hertz contacts) and the whole
/// difference for the sums of p_t: what whole elements cover beyond the patch, up to 1.2 % of its area 40
/// elements across, is not in step with their size, and adhesion goes with the area. The fields (tractions,
/// pmax) are not extrapolated.
struct Discretisation {
  int contact = 0; ///< elements of the companion in contact
  ContactTotals coarse, extrapolated;
  double approach = 0;   ///< (force prescribed) of the approach, over the largest approach of a patch
  double normal = 0;     ///< of the vector sum of p_n dS, over its magnitude's sum
  double tangential = 0; ///< of the vector (sum p_x dS, sum p_s dS), over mu sum p_n dS
  double moment = 0; ///< of p_t about the centre of pressure, over sum mu p_n r dS, r the distance from it

  double worst() const { return std::max({approach, normal, tangential, moment}); }
};

struct PatchSummary {
  double fn = 0, fx = 0, fs = 0;           ///< N, sums over the patch of p dS in the local frames
  double approach = 0;                     ///< largest q cos(delta) - h in the patch, mm
  double pmax = 0;                         ///< MPa
  double area = 0;                         ///< mm^2
  int contact = 0, adhesion = 0, slip = 0; ///< element counts
  double x = 0, s = 0;                     ///< centre of pressure
};

struct ContactResult {
  std::vector<double> px, ps, pn;        ///< tractions on the rail, MPa; fields
  std::vector<double> slip_x, slip_s;    ///< slip per unit of rolled distance (shift: mm); fields
  std::vector<double> deformed_distance; ///< e, mm; field
  std::vector<ElementState> state;       ///< field
  double approach = 0;                   ///< q, mm
  double Fx = 0, Fy = 0, Fz = 0;         ///< on the rail, frame of the rows, N
  double Mz = 0;                         ///< about the origin of (x, y), N mm
  double Fs = 0;                         ///< sum p_s cos(delta - reference_delta) dS, N
  double creepage_x = 0, creepage_s = 0; ///< found for force_x, force_s: added to the rigid slip
  std::vector<PatchSummary> patches;     ///< connected areas of contact, largest force first
  Certificate certificate;
  std::optional<Discretisation> discretisation; ///< nothing: not estimated

  bool touches_border = false; ///< contact at an edge of the grid: the potential contact is too small
  bool converged = false;      ///< certificate.holds()
  std::string normal_solver;   ///< which one finished
  std::string tangential_solver;
  int outer_iterations = 0, normal_iterations = 0, tangential_iterations = 0;
  int creepage_iterations = 0; ///< tangential problems solved to find the creepages of prescribed forces
  double work = 0;             ///< of the case so far, companion included: work.hpp
  double outer_rate = 0; ///< mean factor by which an outer iteration reduced its residual; 0: there was one
  std::string remark;    ///< why a solver of the chain gave up, or ""
};

/// Throws InputError unless sizes agree and all values are finite and in range.
void validate(const ContactProblem& problem);

} // namespace bem_contact
