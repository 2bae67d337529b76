#pragma once

#include "bem_contact/h5/table.hpp"
#include "bem_contact/scene/sweep_file.hpp"
#include "bem_contact/sequence/scene_record.hpp"

#include <map>
#include <set>
#include <string>

namespace bem_contact {

/// The files that the cases read, each once.
std::set<std::string> input_paths(const SweepFile& sweep);

/// These and the sweep's own file: no output may be one of them.
std::vector<std::filesystem::path> files_read(const std::filesystem::path& file, const SweepFile& sweep);

/// The sweep's text, with the scene of its first case and all inputs: those of that case, and those that the
/// lists name, with the key "rail.profile[1]" for the second of a list.
GivenScene given_sweep(const SweepFile& sweep, const std::string& model);

/// All files that a scene names, one or many cases of it, whether they are there or not: those of the lists
/// of [sweep] and [table], and of the tables of commands that are there, too.
std::set<std::string> named_inputs(const SceneText& scene);

/// Everything that the results depend on: name -> what tells one from another. Names are "program" (version
/// and commit), "options" of the command (model, strictness), "scene" and those of the files that it reads,
/// seen from its folder. Influence files count by their seals: a fleet has gigabytes of them, and each task
/// asks.
using Origins = std::map<std::string, std::string>;
Origins origins_of(const SweepFile& sweep, const std::string& options);
/// SHA-256 of all that tells them apart. The names of files do not count.
std::string digest_of(const Origins& origins);
std::string digest_of(const SweepFile& sweep, const std::string& options);

/// As a file keeps them, in the group "made_from".
void add_origins(H5Table& table, const Origins& origins);
/// Why a command does not continue the work that it finds in a file: it was begun with other input, as its
/// digest shows.
inline constexpr const char* digest_changed =
    "the scene, a file that it names, an option or this program (version or commit) has changed since";
/// What differs in a file from what is asked now, by name, as the reason of an error; digest_changed where
/// the file does not say.
std::string what_changed(const H5Reader& file, const Origins& now);

} // namespace bem_contact
