#pragma once

#include "bem_contact/base/tuned.hpp"

#include <array>

/// The tuned numbers of this room (base/tuned.hpp).
namespace bem_contact {

/// Threads. No case may ask for more: it would spend them waiting. Chosen.
BEM_CONTACT_TUNED(int, most_threads, 64);

// What bem_contact check says.

/// mm. Touch points that are nearer than this are described by bem_contact check.
BEM_CONTACT_TUNED(double, described_distance, 1.0);
/// mm. Room that a strip gets on either side beyond the rows of the frictionless contact. Chosen.
BEM_CONTACT_TUNED(double, strip_reserve, 1.0);
/// mm. The station width of the body files of data/bodies.
BEM_CONTACT_TUNED(double, usual_station_width, 0.25);

// Solutions of one case.

/// 1. How often one case may be solved for an accuracy.
BEM_CONTACT_TUNED(int, most_solves, 4);
/// 1. A solution counts as rough from where an outer iteration changes it by less than this share of the
/// accuracy asked for: its estimated errors are then those of the precise one but for a few percent.
BEM_CONTACT_TUNED(double, rough_share, 0.1);
/// 1. Elements in contact of the rough half-space solutions that a search for a lateral force begins with.
/// Chosen: they only tell which branches there are.
BEM_CONTACT_TUNED(int, lateral_map_elements, 60);

// Comparison of models.

/// 1. Creepages beyond free rolling at which longitudinal forces are compared: a driven wheel's on a good
/// track, the same doubled, and a start of full slip.
inline constexpr std::array<double, 3> compared_creepages{5e-4, 1e-3, 2e-3};
/// 1. A model whose lateral force at the reference's position is as near to the reference's as this, over the
/// resultant of Fy and Fz, is compared there. On a tread Fy hardly depends on the position: at cant 1:40 the
/// half-space's is within .0003. The place where it is exactly the same lies .28 mm off, where pmax is 12 %
/// off.
BEM_CONTACT_TUNED(double, same_lateral_force, 0.005);

// What is kept from the case before.

/// 1. From this number of elements on, a former case is no start if its elements were longer or wider by more
/// than coarse_former: what the solver itself finds on elements twice as large is nearer.
BEM_CONTACT_TUNED(int, many_elements, 2000);
BEM_CONTACT_TUNED(double, coarse_former, 1.5); ///< 1. Length and width over the wanted ones.
BEM_CONTACT_TUNED(int, operators_kept, 3);     ///< 1. Grids whose operators are kept: they take more.

// Warnings and stresses.

/// 1. Elements of a patch below which they are said to be few: an error is off by its own size there
/// (tools/BENCHMARKS.md).
BEM_CONTACT_TUNED(int, few_elements, 40);
/// 1. Elements across a patch below which they are said to be too large: each is a fifth of it.
BEM_CONTACT_TUNED(int, fewest_across, 5);
/// 1. A patch that bears less than this share of the largest one's force has no such warning.
BEM_CONTACT_TUNED(double, minor_patch, 0.05);
/// MPa. Least yield strength of wheels of grade ER7 (EN 13262); rails of grade R260 have about the same.
BEM_CONTACT_TUNED(double, yield_strength, 520.0);
/// 1. The mean pressure of a fully plastic contact is about so many times the yield strength (Tabor 1951).
BEM_CONTACT_TUNED(double, yield_factor, 3.0);
/// MPa. A body with a smaller Young's modulus is not of steel, and its strength is not known.
BEM_CONTACT_TUNED(double, least_steel_modulus, 1.5e5);
/// 1. A larger creepage is probably a mistake: a wheel that slides or spins as a whole.
BEM_CONTACT_TUNED(double, largest_creepage, 0.1);
/// mm. Contact lower than this below the top of the rail is beyond its head: gauge is measured 14 mm below
/// the top, and worn flanges touch little lower.
BEM_CONTACT_TUNED(double, head_depth, 18.0);
/// 1. Most points at which stresses are computed: some minutes.
BEM_CONTACT_TUNED(double, most_stress_points, 1e6);
BEM_CONTACT_TUNED(double, most_stress_sums, 1e9); ///< 1. Most products of points and elements: some minutes.
/// 1 (widths). Half length of a plane-strain element where stresses are summed.
BEM_CONTACT_TUNED(double, endless_element, 1e6);

// Repeated results.

/// mm. A length near zero is compared as if it were this long: a thousandth of a millimetre is what profiles
/// are measured to.
BEM_CONTACT_TUNED(double, least_length, 1e-3);
/// 1. The same for creepages: at a thousandth a wheel has left the range where force and creepage are
/// proportional.
BEM_CONTACT_TUNED(double, least_creepage, 1e-3);

} // namespace bem_contact
