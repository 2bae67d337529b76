#pragma once

#include "bem_contact/scene/sweep_file.hpp"
#include "bem_contact/sequence/scene_record.hpp"

#include <set>
#include <string>

namespace bem_contact::app {

/// The files that the cases read, each once.
std::set<std::string> input_paths(const SweepFile& sweep);

/// These and the sweep's own file: no output may be one of them.
std::vector<std::filesystem::path> files_read(const std::filesystem::path& file, const SweepFile& sweep);

/// The sweep's text, with the scene of its first case and all inputs: those of that case, and those that the
/// lists name, with the key "rail.profile[1]" for the second of a list.
GivenScene given_sweep(const SweepFile& sweep, const std::string& model);

/// Digest (SHA-256) of everything that the results depend on: version and commit, options of the command
/// (model, strictness), scene and the files it reads. Influence files count by their seals: a fleet has
/// gigabytes of them, and each task asks.
std::string digest_of(const SweepFile& sweep, const std::string& options);

} // namespace bem_contact::app
