#pragma once

#include "bem_contact/uses/table/refine.hpp"

namespace bem_contact::table {

/// A table of the creep forces of an elliptic contact between half-spaces of equal material: what Kalker
/// tabulated (1996, "Book of tables for the Hertzian creep-force law"; program USETAB).
///
/// Such a contact depends on four numbers and on Poisson's ratio. With a along x, c = sqrt(a b), R^2 = (a^2 +
/// b^2)/2, G the shear modulus and mu N the friction bound, they are a/b and the scaled creepages
///     xi' = G c^2 C11 xi / (3 mu N),  eta' = G c^2 C22 eta / (3 mu N),
///     phi' = G c^2 sqrt(C11 C22) R phi / (3 mu N),
/// where C11 and C22 are Kalker's coefficients of linear theory (CreepScale). Without spin, slip is full near
/// xi' = 1. The columns are Fx/(mu N), Fy/(mu N) and Mz/(mu N R), on the rail.
///
/// Kalker scales spin by C23. Our phi' is the creepage that spin makes at the distance R, so that the forces
/// change over about the same angles between xi' and phi' whatever a/b is.
///
/// Kalker takes 1/xi' where xi' > 1, so that his table has no end. Here the axes are
///     log10(a/b),
///     t = w / (1 + w), where w is the length of (xi', eta', phi'): 0 .. 1, and 1 is full slip,
///     alpha, from the axis of xi' to the plane of eta' and phi', 0 .. pi/2,
///     beta, in that plane, from eta' to phi', -pi/2 .. pi/2.
/// They are nested (contact_table.hpp): forces change much only where slip becomes full while the pole of the
/// motion lies near the leading edge.
/// Creepages of the other signs follow by symmetry: the sign of xi turns that of Fx alone, and the signs of
/// eta and phi together turn those of Fy and Mz alone.
struct CreepTableOptions {
  double poisson = 0.28;     ///< of both bodies
  double from = 0.5, to = 2; ///< a/b; within 0.1 to 10, where the coefficients are known
  int elements = 16;         ///< across each axis of the ellipse
  double tolerance = 0.02;   ///< relative, of the slopes at zero by interpolation
};

/// The axes with their first points, the columns without values. Throws InputError for options out of range.
ContactTable creep_table(const CreepTableOptions& options);

/// Solves points of such a table; each call makes one that has a Sequence of its own.
PointSolver creep_point_solver(const CreepScale& scale, int elements);

/// A contact whose forces are asked for.
struct CreepContact {
  double a = 0, b = 0;      ///< semi-axes along x and s, mm
  double shear_modulus = 0; ///< MPa
  double bound = 0;         ///< mu N, N
};

/// Forces and moment on the rail, and the errors of each that the table states (Column::error()).
struct TabulatedForces {
  double Fx = 0, Fy = 0, Mz = 0;                   ///< N, N, N mm
  double Fx_error = 0, Fy_error = 0, Mz_error = 0; ///< the same
};

/// Looks up forces for xi (1), eta (1) and phi (1/mm); together Fx and Fy are never larger than mu N. Throws
/// InputError if a/b is outside the table (creepages never are), for a contact that is none, and for a table
/// of a scene.
TabulatedForces creep_forces(const ContactTable& table, const CreepContact& contact, double xi, double eta,
                             double phi);

} // namespace bem_contact::table
