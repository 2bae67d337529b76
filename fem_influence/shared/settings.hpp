#pragma once

#include "bem_contact/base/tuned.hpp"

/// The tuned numbers of fem_influence: what both methods use, then the harmonic method, then the solid
/// method. "Benchmark" below means tools/benchmarks/influence_error, whose table is fem_influence/ERRORS.md.
namespace bem_contact::fem::settings {

// --- MUMPS ---

/// 1. Right-hand sides that are solved at once. Blocks of 64 to 128 made a solve eight times cheaper than one
/// at a time (138 000 unknowns: 0.019 s instead of 0.15 s); larger blocks only cost memory.
BEM_CONTACT_TUNED(int, solve_block, 128);

// --- The mesh against the profile and the strip ---

/// mm. A vertex this near to the profile lies on it. gmsh writes 16 digits, so a vertex on the profile is
/// off by round-off alone; edges are far longer.
BEM_CONTACT_TUNED(double, on_profile, 1e-6);

/// 1, of the edge's length. The middle of an edge along the profile is no farther from it. The sagitta of an
/// edge that turns by 15 degrees is 0.033 of its length; an edge of another body or in another frame is
/// farther.
BEM_CONTACT_TUNED(double, edge_off_profile, 0.1);

/// 1. Shapes of nodes that are not on a face or edge vanish there, up to round-off.
BEM_CONTACT_TUNED(double, vanishing_shape, 1e-12);

// --- harmonic: the remote section (THEORY.md, 6) ---

/// mm. Default distance of the remote section from the strip: far enough to be out of the contact's own
/// field, near enough to move with the material under the strip when web, foot or disc bend. Doubling a
/// block's size changes the numbers without its motion by less than 0.2 % of self then (test_run.cpp).
BEM_CONTACT_TUNED(double, remote_distance, 20.0);

// --- harmonic: wavenumbers (THEORY.md, 7) ---

/// 1. Harmonics n pi / L that are taken exactly, n = 1, 2, ... k g(k) is smooth in log k above them.
BEM_CONTACT_TUNED(int, exact_harmonics, 8);

// --- harmonic: stresses of the inside (THEORY.md, 10) ---

/// MPa per MPa. Columns of a stress matrix, that of one wavenumber and depth for all places and stations, are
/// left out as long as its Frobenius norm changes by less. At five times as much stresses below a Hertz
/// contact were off by 2 % of the largest.
BEM_CONTACT_TUNED(double, stress_tolerance, 1e-2);
/// MPa per MPa. The same of the difference to one degree less, which tells how wrong stresses are.
BEM_CONTACT_TUNED(double, stress_error_tolerance, 5e-2);
/// 1 (of harmonic.samples_per_decade). Wavenumbers of stresses: they need not be as exact as the kernel.
BEM_CONTACT_TUNED(double, stress_samples, 0.75);
/// 1. The difference to one degree less hardly depends on the wavenumber: it is computed at every fourth.
BEM_CONTACT_TUNED(int, stress_error_every, 4);

// --- solid: the mesh (THEORY.md, 9) ---

/// 1. A cell is halved when it is larger than asked for by this factor, so that a cell of exactly the size
/// asked for stays as it is. Not measured.
BEM_CONTACT_TUNED(double, size_excess, 1.05);

// --- solid: patches on faces ---

/// 1, of the element's area. The faces of the group 'contact' must cover it within this: see
/// edge_beyond_station.
BEM_CONTACT_TUNED(double, uncovered, 1e-4);

} // namespace bem_contact::fem::settings
