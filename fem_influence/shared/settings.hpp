#pragma once

#include "bem_contact/base/tuned.hpp"

/// The tuned numbers of fem_influence: what both methods use, then the harmonic method, then the solid
/// method. "Benchmark" below means tools/benchmarks/influence_error, whose table is fem_influence/ERRORS.md.
namespace bem_contact::fem::settings {

// --- MUMPS ---

/// 1. Right-hand sides that are solved at once. Blocks of 64 to 128 made a solve eight times cheaper than one
/// at a time (138 000 unknowns: .019 s instead of .15 s); larger blocks only cost memory.
BEM_CONTACT_TUNED(int, solve_block, 128);

/// %. Work space that MUMPS gets on top of its own estimate, ICNTL(14). Not measured: a moderate start, for
/// a factorization that runs out of it is repeated with more.
BEM_CONTACT_TUNED(int, work_space_margin, 30);

/// 1. Factor by which the margin grows for each repetition, and how often the factorization is tried. Not
/// measured: three attempts reach 270 %.
BEM_CONTACT_TUNED(int, work_space_growth, 3);
BEM_CONTACT_TUNED(int, work_space_attempts, 3);

// --- The mesh against the profile and the strip ---

/// mm. A vertex this near to the profile lies on it. gmsh writes 16 digits, so a vertex on the profile is
/// off by round-off alone; edges are far longer.
BEM_CONTACT_TUNED(double, on_profile, 1e-6);

/// 1, of the edge's length. The middle of an edge along the profile is no farther from it. The sagitta of an
/// edge that turns by 15 degrees is .033 of its length; an edge of another body or in another frame is
/// farther.
BEM_CONTACT_TUNED(double, edge_off_profile, 0.1);

/// 1, of the edge's length. Two vertices that are nearer are one (the ends of an arc that mesh_body names).
BEM_CONTACT_TUNED(double, same_vertex, 1e-6);

/// 1. Shapes of nodes that are not on a face or edge vanish there, up to round-off.
BEM_CONTACT_TUNED(double, vanishing_shape, 1e-12);

// --- harmonic: the section's mesh ---

/// 1, of a station's width. A vertex of the mesh that is nearer to the border of two stations lies on it. It
/// must be far below the size of an element after all halvings (1/16 of a station by default).
BEM_CONTACT_TUNED(double, at_border, 1e-3);

/// 1, of a station's width. Edges must end where stations do: an edge that reaches farther into the next
/// station would shift the load by as much, which is a tenth of the error asked for by default.
BEM_CONTACT_TUNED(double, edge_beyond_station, 1e-4);

// --- harmonic: the remote section (THEORY.md, 6) ---

/// mm. Default distance of the remote section from the strip: far enough to be out of the contact's own
/// field, near enough to move with the material under the strip when web, foot or disc bend. Doubling a
/// block's size changes the numbers without its motion by less than .2 % of self then (test_run.cpp).
BEM_CONTACT_TUNED(double, remote_distance, 20.0);

/// 1, of the root of the section's mean square distance from the strip. Upper limit of that default in small
/// bodies. An area mean is the same on every mesh; the farthest node is not, and moved far numbers of a disc.
BEM_CONTACT_TUNED(double, remote_part_of_small_body, 0.8);

// --- harmonic: wavenumbers (THEORY.md, 7) ---

/// 1. Harmonics n pi / L that are taken exactly, n = 1, 2, ... k g(k) is smooth in log k above them.
BEM_CONTACT_TUNED(int, exact_harmonics, 8);

/// 1. The largest wavenumber times the shortest element length dx. Half of it is k_max a with the half length
/// a = dx / 2: k_max a of 5 leaves no error to see, 2.4 costs .45 % and 1.2 costs 2 % of the self number.
BEM_CONTACT_TUNED(double, largest_wavenumber_times_dx, 10.0);

// --- harmonic: the error estimate (THEORY.md, 8) ---

/// mm. Numbers farther away are not compared. Contact patches are smaller, and what is left beyond is the
/// body's motion as a whole.
BEM_CONTACT_TUNED(double, compared_distance, 16.0);

/// 1. Equal steps along the strip between stations that are compared: with the neighbours of three of them at
/// most 64 stations, so that a companion costs a sixth of the run.
BEM_CONTACT_TUNED(int, compared_steps, 24);

/// 1. The mesh's error is stated larger by this factor. The true error was .9 to 1.2 of what the ratio of two
/// meshes says (block, disc, rail, wheel), and 1.8 on meshes that are far too coarse.
BEM_CONTACT_TUNED(double, mesh_error_margin, 1.8);

/// 1. How much larger the error of degree 1 is taken than that of degree 2. The limit would be 2^4, but
/// degree 1 is far from the limit (block, disc, rail, wheel).
BEM_CONTACT_TUNED(double, degree_1_over_2, 5.0);

/// Leaving out every second wavenumber makes the error larger by `sampling_ratio` at `sampling_ratio_at`
/// samples a decade, growing with the third power and limited to `sampling_ratio_most`; 2^6 in the limit of
/// many samples. Benchmark: at 7 and fewer samples 24 or more where numbers are large, 12 at 16 mm on a disc
/// of radius 10; at 10 samples 31 to 57.
BEM_CONTACT_TUNED(double, sampling_ratio, 10.0);
BEM_CONTACT_TUNED(double, sampling_ratio_at, 7.0);
BEM_CONTACT_TUNED(double, sampling_ratio_most, 30.0);

/// 1. The smallest eigenvalue is only printed: inverse iterations at most, and the relative change that ends
/// them.
BEM_CONTACT_TUNED(int, eigenvalue_iterations, 100);
BEM_CONTACT_TUNED(double, eigenvalue_change, 1e-3);

// --- harmonic: processes ---

/// 1. One of so many processes begins with the companion, so that the others never mesh it. The companion is
/// a sixth of the work.
BEM_CONTACT_TUNED(int, processes_per_companion, 5);

/// 1. Shared memory of a machine must have room for this many times what is needed. The rest is for others: a
/// page too few ends all processes without a message.
BEM_CONTACT_TUNED(double, shared_memory_reserve, 1.125);

// --- solid: the mesh (THEORY.md, 9) ---

/// 1, of the face's diameter. A vertex of the group 'contact' must not lie farther off the profile: other
/// programs may write meshes with a few digits. Not measured.
BEM_CONTACT_TUNED(double, vertex_off_profile, 1e-3);

/// 1, of the face's diameter. Vertices of one mirror plane have the same x, up to the digits of the file.
BEM_CONTACT_TUNED(double, same_plane, 1e-6);

/// 1. A cell is halved when it is larger than asked for by this factor, so that a cell of exactly the size
/// asked for stays as it is. Not measured.
BEM_CONTACT_TUNED(double, size_excess, 1.05);

/// mm. Samples lie within about this distance of the load. Farther away only the body's motion as a whole
/// counts, and elements may grow faster.
BEM_CONTACT_TUNED(double, accurate_distance, 20.0);

// --- solid: patches on faces ---

/// 1, of the element's area. Parts of an element on a face that are smaller are round-off and left out.
BEM_CONTACT_TUNED(double, smallest_part, 1e-14);

/// 1. Newton steps at most for the place on a face, and the change that ends them. Faces are nearly
/// rectangles, where one step is exact.
BEM_CONTACT_TUNED(int, face_steps, 20);
BEM_CONTACT_TUNED(double, face_change, 1e-13);

/// 1, of the element's area. The faces of the group 'contact' must cover it within this: see
/// edge_beyond_station.
BEM_CONTACT_TUNED(double, uncovered, 1e-4);

// --- solid: comparison of two methods ---

/// mm. Ends of the bands of distance in which differences are reported (about 3, 9 and 32 elements of .5 mm).
BEM_CONTACT_TUNED(double, near_band, 1.6);
BEM_CONTACT_TUNED(double, middle_band, 4.5);
BEM_CONTACT_TUNED(double, far_band, 16.0);

} // namespace bem_contact::fem::settings
