#pragma once

#include "bem_contact/base/tuned.hpp"

#include <array>

/// The tuned numbers of this room (base/tuned.hpp).
namespace bem_contact {

/// Threads. No case may ask for more: it would spend them waiting. Chosen.
BEM_CONTACT_TUNED(int, most_threads, 64);

// Solutions of one case.

/// 1. How often one case may be solved for an accuracy.
BEM_CONTACT_TUNED(int, most_solves, 4);
/// 1. A solution counts as rough from where an outer iteration changes it by less than this share of the
/// accuracy asked for: its estimated errors are then those of the precise one but for a few percent.
BEM_CONTACT_TUNED(double, rough_share, 0.1);

// Work that is foreseen (foreseen_work.hpp).

/// 1. Products with influence numbers that a solution takes, or what costs as much, over the elements of its
/// plan: 100 to 300 in the scenes of tools/benchmarks/speed.
BEM_CONTACT_TUNED(double, products_of_case, 200);
/// Units of work. What a case takes however few elements it has: bodies are placed, and a result is made.
BEM_CONTACT_TUNED(double, least_work_of_case, 2e5);
/// 1. Solutions until a wheel bears a lateral force, and until both wheels of a wheelset are in equilibrium:
/// typical numbers.
BEM_CONTACT_TUNED(double, solutions_of_lateral_force, 6);
BEM_CONTACT_TUNED(double, solutions_of_wheelset, 20);

// Comparison of models.

/// 1. Creepages beyond free rolling at which longitudinal forces are compared: a driven wheel's on a good
/// track, the same doubled, and a start of full slip.
inline constexpr std::array<double, 3> compared_creepages{5e-4, 1e-3, 2e-3};

// What is kept from the case before.

/// 1. From this number of elements on, a former case is no start if its elements were longer or wider by more
/// than coarse_former: what the solver itself finds on elements twice as large is nearer.
BEM_CONTACT_TUNED(int, many_elements, 2000);

// Warnings and stresses.

/// 1. Elements of a patch below which they are said to be few: an error is off by its own size there
/// (tools/BENCHMARKS.md).
BEM_CONTACT_TUNED(int, least_elements_of_patch, 40);

// Repeated results.

/// mm. A length near zero is compared as if it were this long: a thousandth of a millimetre is what profiles
/// are measured to.
BEM_CONTACT_TUNED(double, least_length, 1e-3);
/// 1. The same for creepages: at a thousandth a wheel has left the range where force and creepage are
/// proportional.
BEM_CONTACT_TUNED(double, least_creepage, 1e-3);

} // namespace bem_contact
