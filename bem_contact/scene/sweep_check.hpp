#pragma once

#include "bem_contact/scene/sweep_file.hpp"

namespace bem_contact {

/// Parses a scene of every value that these cases have, and all of them of a zip, so that wrong input is
/// found before anything is computed; of a range that of its first two values and its last. Says how many
/// they are where that takes long. Throws InputError.
void check_values(const SweepFile& sweep, CaseRange cases);
inline void check_values(const SweepFile& sweep) {
  check_values(sweep, sweep.all());
}

/// The same for who records a case that is refused and goes on: a line of a table may be no scene. Says in a
/// message how many are. Throws InputError where no case of the sweep is a scene, or a list of the scene file
/// holds a wrong value.
void check_cases(const SweepFile& sweep, CaseRange cases);

} // namespace bem_contact
