#pragma once

#include "bem_contact/sequence/compare_quantities.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace bem_contact::app {

/// Whether a file begins as HDF5 does.
bool is_hdf5(const std::filesystem::path& file);

/// What a result file says of its case, and what this program says now.
struct Repetition {
  std::string program, commit;                 ///< that made the file
  std::string model;                           ///< of the file
  std::vector<QuantityDifference> differences; ///< beyond what two certified solutions may differ by
  std::vector<std::string> others;             ///< other differences, in sentences
  Warnings warnings;                           ///< inputs that are other files today
  SceneResult result;                          ///< now

  bool same() const { return differences.empty() && others.empty(); }
};

/// Solves the scene of a result file again, with the inputs that the file keeps. Influence files (and body
/// files that name other files) are not kept: they must be where the scene's paths lead from `folder`, or, if
/// that is empty, from the folder that the file remembers relative to itself. Throws InputError for a file
/// that is no result, for an input that is missing or has another digest, and what Sequence::solve() throws.
Repetition repeat_result(const std::filesystem::path& file, const std::filesystem::path& folder);

/// Says in words what was repeated, and what differs.
std::string to_text(const Repetition& repetition);

/// The scene of a result, a comparison or a sweep: as it was given, or with all defaults. Throws InputError
/// for a file that has none.
std::string stored_scene(const std::filesystem::path& file, bool with_defaults);

} // namespace bem_contact::app
