#pragma once

#include "bem_contact/base/tuned.hpp"

#include <cstddef>

/// The tuned numbers of this room (base/tuned.hpp).
namespace bem_contact::app {

// Profiles in words.

/// mm. Step of the points that `profile --csv` writes. It is the step of the contact search.
BEM_CONTACT_TUNED(double, profile_csv_step, 0.1);

// Sweeps in child processes.

/// Units of work (contact/work.hpp), about a minute. What one process solves before it writes its part. A
/// kill loses at most so much work of each process; a start and the digest of all inputs take less than a
/// hundredth of it. Chosen.
BEM_CONTACT_TUNED(double, part_work, 2e9);
/// Units of work, about a second. The least work of a part where there is so much: to write, read and join
/// one takes some 0.05 s.
BEM_CONTACT_TUNED(double, least_part_work, 3e7);
/// 1. A sweep is cut into at least so many parts for each process, so that those that have no more wait for
/// an eighth of the time at most, and for a sixteenth on average. Chosen.
BEM_CONTACT_TUNED(std::size_t, parts_of_a_process, 8);

} // namespace bem_contact::app
