#pragma once

#include "bem_contact/base/tuned.hpp"

#include <cstddef>

/// The tuned numbers of this room (base/tuned.hpp).
namespace bem_contact::app {

// Profiles in words.

/// mm. Step of the points that `profile --csv` writes. It is the step of the contact search.
BEM_CONTACT_TUNED(double, profile_csv_step, 0.1);

// Sweeps in child processes.

/// s. What one process solves before it writes its part. A kill loses at most so much work of each process;
/// a start and the digest of all inputs take less than a hundredth of it. Chosen.
BEM_CONTACT_TUNED(double, part_seconds, 60);
/// s. The least work of a part where there is so much: to write, read and join one takes some .05 s.
BEM_CONTACT_TUNED(double, least_part_seconds, 1);
/// s. Where the first case takes longer, each case is a part of its own, and starts cold. Chosen: so that a
/// chunk, four cases or more, would take minutes.
BEM_CONTACT_TUNED(double, slow_case_seconds, 30);
/// 1. A sweep is cut into at least so many parts for each process, so that those that have no more wait for
/// an eighth of the time at most, and for a sixteenth on average. Chosen.
BEM_CONTACT_TUNED(std::size_t, parts_of_a_process, 8);

} // namespace bem_contact::app
