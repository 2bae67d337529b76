#pragma once

#include "bem_contact/contact/friction_law.hpp"
#include "bem_contact/influence/influence_numbers.hpp"
#include "bem_contact/profile/contact_row.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace bem_contact {

/// Regular grid of the potential contact: mx columns along x and ms rows along s. Element (ix, is) has its
/// centre at x = x0 + ix dx on row number `is`. Its place in every field below is `is * mx + ix` ("field":
/// [ms][mx], row-major, x fastest).
struct ContactGrid {
  int mx = 0, ms = 0;    ///< columns, rows
  double dx = 0, ds = 0; ///< mm
  double x0 = 0;         ///< centre of the first column, mm

  int size() const { return mx * ms; }                ///< elements
  bool is_line() const { return mx == 1 || ms == 1; } ///< one column or one row
  double x(int ix) const { return x0 + ix * dx; }     ///< middle of a column, mm
  std::vector<double> columns() const {               ///< x of each, mm
    std::vector<double> all(mx);
    for (int ix = 0; ix < mx; ++ix)
      all[ix] = x(ix);
    return all;
  }
};

/// What is prescribed, and presses the bodies together.
enum class LoadKind { approach, force };

/// How the surfaces move over each other. slip_step.hpp has the slip of each kind.
///   steady     rolling that no longer changes; the grid moves with the contact
///   transient  one rolling step by dx from `previous`; the grid moves with the contact, one column a step;
///              each field of `previous` is on the grid where it stood then
///   shift      one load step from `previous` on a grid that lies still: Cattaneo's shift, or rolling over a
///              fixed grid with an undeformed distance that moves. The rigid slip is given in mm
enum class MotionKind { steady, transient, shift };

/// Tractions on the rail by the wheel, MPa; fields.
struct Tractions {
  std::vector<double> px, ps, pn;   ///< along x and s, pressure
  std::vector<double> plastic = {}; ///< plastic slip that they left in a layer that yields, mm; empty: none
};

/// What is asked of a contact problem, however fine its elements are. Signs: base/conventions.hpp.
struct ContactConditions {
  LoadKind load = LoadKind::force; ///< whether approach or force below counts
  double approach = 0;             ///< q along z, mm (load == approach)
  double force = 0;                ///< Fz, N (load == force); per mm of length in plane strain
  bool tangential = true;          ///< false: frictionless
  /// H, MPa: what the softer body bears at the most, p_n <= H. Where the pressure is H the bodies may
  /// overlap: they are indented for good. Empty: they are elastic.
  std::optional<double> limit_pressure;
  double friction = 0.3; ///< Coulomb's mu of adhesion (static friction)
  double kinetic = 1;    ///< mu of slip over mu of adhesion, in (0, 1]
  /// Of a layer between the surfaces, in each of its elements; empty: it bears whatever friction does. The
  /// layer's compliance stands in the influence numbers (layer.hpp). Hardening excludes friction that varies,
  /// yield excludes kinetic < 1. A limit that depends on temperature needs `heating`.
  std::optional<YieldLimit> yield;
  /// Prescribed shear forces on the rail, N: sum p_x dS and sum p_s cos(delta - reference_delta) dS. For each
  /// of them solve() finds a creepage (shift: mm) and adds it to the rigid slip: ContactResult::creepage_x to
  /// w_x, creepage_s cos(delta - reference_delta) to w_s.
  std::optional<double> force_x, force_s;
  double reference_delta = 0; ///< rad
  /// Of a rail that rises or falls along x, tan of its pitch, below 0 where it rises: `force` is the sum of
  /// (p_n cos(delta) + p_s sin(delta) + rise p_x) dS, what bears along the vertical over cos of the pitch.
  double rise = 0;
  MotionKind motion = MotionKind::steady; ///< what the rigid slip is a motion of
};

/// One contact problem: the question, and what belongs to the elements.
struct ContactProblem : ContactConditions {
  ContactGrid grid;             ///< the potential contact
  std::vector<ContactRow> rows; ///< ms of them
  InfluenceNumbers numbers;     ///< of the pair, at least grid.mx + 2 offsets (plane strain: 1), grid.ms rows
  std::vector<double> gap;      ///< undeformed distance along n at approach 0, mm; field
  std::vector<double> friction_rows; ///< mu of each row instead; empty: `friction` everywhere
  /// How mu falls with the slip velocity: one law for each row, or one for all rows; empty: it does not fall.
  /// `friction` is then mu without slip. Laws exclude motion == shift and kinetic < 1.
  std::vector<FallingFriction> falling;
  std::optional<FrictionMemory> memory; ///< friction follows `falling` not at once; steady rolling
  double speed = 0;                     ///< of rolling, mm/s; above 0 with `falling` or `heating`
  std::optional<Heating> heating;       ///< flash temperatures are asked for; steady rolling
  std::vector<double> slip_x, slip_s;   ///< rigid slip w, per unit of rolled distance (shift: mm); fields
  /// Tractions of former steps, the latest first. Transient: one and two rolling steps ago, as slip_step.hpp
  /// weights both. Shift: one load step ago. If there are fewer, the bodies were at rest before, unloaded.
  std::vector<Tractions> previous;

  /// Each row is one element that is infinitely long along x: mx = 1, influence numbers with one offset and
  /// dx = 0, no friction. Forces are per mm of length.
  bool plane_strain() const { return numbers.dx == 0; }
  double element_area() const { return plane_strain() ? grid.ds : grid.dx * grid.ds; } ///< mm^2
  /// Coulomb's mu of a row, without slip.
  double friction_of(int row) const { return friction_rows.empty() ? friction : friction_rows[row]; }
  /// The largest mu of all rows.
  double largest_friction() const {
    return friction_rows.empty() ? friction : *std::max_element(friction_rows.begin(), friction_rows.end());
  }
  /// mu of a row at a slip velocity (mm/s), divided by mu of the same row without slip.
  double falling_factor(int row, double slip_velocity) const {
    return falling.empty() ? 1 : falling[falling.size() == 1 ? 0 : row].factor(slip_velocity);
  }
  /// Says whether mu depends on the slip velocity.
  bool friction_falls() const {
    return std::any_of(falling.begin(), falling.end(), [](const auto& law) { return law.ratio != 1; });
  }
  /// Says whether mu depends on the temperature of the surfaces.
  bool friction_falls_with_heat() const {
    return heating && heating->friction && heating->friction->ratio != 1;
  }
  /// Says whether what the layer bears depends on the temperature of the surfaces.
  bool layer_softens_by_heat() const { return heating && yield && yield->softens_by_heat(); }
  /// Says whether the tractions depend on the temperature of the surfaces.
  bool heat_acts() const { return friction_falls_with_heat() || layer_softens_by_heat(); }
  /// Says whether what the layer bears depends on its plastic slip.
  bool hardens() const { return yield && yield->hardening != 0; }
  /// Says whether mu depends on slip velocity or temperature.
  bool friction_varies() const { return friction_falls() || friction_falls_with_heat(); }
  /// Says whether what bounds shear depends on slip velocity or temperature.
  bool bounds_vary() const { return friction_varies() || layer_softens_by_heat(); }
  /// Coulomb's law with one mu for adhesion and slip, and no layer that yields.
  bool is_coulomb() const { return kinetic == 1 && !friction_varies() && !yield; }
  /// Says whether there is a tangential problem at all.
  bool has_friction() const { return tangential && largest_friction() > 0; }
  /// The slip along s on a row under a unit creepage along s: cos(delta - reference_delta).
  double lateral_share(int row) const { return std::cos(rows[row].delta - reference_delta); }
};

/// The place of an arc length (mm) among the rows, counted from 0: 1.5 is half way between the second row and
/// the third. Beyond the ends it is the first or the last row.
double row_index(const ContactProblem& problem, double s);
/// Position and inclination there, linear between the rows.
ContactRow row_at(const ContactProblem& problem, double s);

/// Throws InputError unless sizes agree and all values are finite and in range.
void validate(const ContactProblem& problem);

} // namespace bem_contact
