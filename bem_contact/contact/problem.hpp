#pragma once

#include "bem_contact/influence/influence_numbers.hpp"
#include "bem_contact/profile/contact_row.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
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

/// How the surfaces move over each other. slip_step.hpp has the slip of each kind.
///   steady     rolling that no longer changes; the grid moves with the contact
///   transient  one rolling step by dx from `previous`; the grid moves with the contact, by dx
///   shift      one load step from `previous` on a grid that lies still: Cattaneo's shift, or rolling over a
///              fixed grid with an undeformed distance that moves. The rigid slip is given in mm
enum class MotionKind { steady, transient, shift };

/// Tractions on the rail by the wheel, MPa; fields.
struct Tractions {
  std::vector<double> px, ps, pn;
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
  /// Prescribed forces, N on the rail: sum p_x dS and sum p_s cos(delta - reference_delta) dS. For each of
  /// them a creepage is unknown: (1, 0) or (0, cos(delta - reference_delta)) times it is added to w.
  std::optional<double> force_x, force_s;
  double reference_delta = 0; ///< rad
  MotionKind motion = MotionKind::steady;
  /// Transient: one and two rolling steps ago; shift: one load step ago. If there are fewer, the bodies start
  /// from rest, without tractions.
  std::vector<Tractions> previous;

  /// One element that is infinitely long along x: mx = 1, influence numbers with one offset and dx = 0, no
  /// friction. Forces are per mm.
  bool plane_strain() const { return numbers.dx == 0; }
  double element_area() const { return plane_strain() ? grid.ds : grid.dx * grid.ds; } ///< mm^2
  double friction_of(int row) const { return friction_rows.empty() ? friction : friction_rows[row]; }
  double largest_friction() const {
    return friction_rows.empty() ? friction : *std::max_element(friction_rows.begin(), friction_rows.end());
  }
  bool has_friction() const { return tangential && largest_friction() > 0; }
  /// The slip along s on a row under a unit creepage along s: cos(delta - reference_delta).
  double lateral_share(int row) const { return std::cos(rows[row].delta - reference_delta); }
};

/// Throws InputError unless sizes agree and all values are finite and in range.
void validate(const ContactProblem& problem);

} // namespace bem_contact
