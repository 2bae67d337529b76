#pragma once

#include "bem_contact/scene/sweep_file.hpp"

#include <set>
#include <string>

namespace bem_contact::app {

/// Parses the scene of every value of every list, and all cases of a zip, so that wrong input is found before
/// anything is computed. Throws InputError.
void check_values(const SweepFile& sweep);

/// The files that the cases read, each once.
std::set<std::string> inputs_of(const SweepFile& sweep);

/// Digest (SHA-256) of everything that the results depend on: version, options of the command
/// (model, strictness), scene and the files it reads.
std::string digest_of(const SweepFile& sweep, const std::string& options);

} // namespace bem_contact::app
