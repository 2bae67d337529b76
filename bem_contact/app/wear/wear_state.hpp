#pragma once

#include "bem_contact/uses/wear/evolution.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace bem_contact::app {

/// What `bem_contact wear` keeps between two steps, and after the last.
struct WearState {
  wear::WornPair pair;
  std::vector<wear::WearRow> history; ///< one row a step, 0 included

  int step() const { return static_cast<int>(history.size()) - 1; } ///< the last one; -1: none
};

/// Is in the folder while a run writes there (base/file_lock.hpp).
inline constexpr std::string_view lock_file_name = "wear.lock";

/// The name of a body's file of a step: rail_0001.txt. `extension`: txt, h5 or toml.
std::string step_file(std::string_view body, int step, std::string_view extension);

/// Writes profiles of this step (rail_0001.txt), wear.csv, and last the state (wear.h5), each whole or not
/// at all: a kill at any moment leaves the state of a finished step.
void write_wear(const std::filesystem::path& folder, const std::string& digest, const WearState& state);

/// The state of a folder; nothing if the folder is empty, or holds only what a wear left that was stopped
/// before its first state was written. Throws InputError if the state is of another scene
/// or damaged, and if there are only other files: writing would overwrite those of the same name.
std::optional<WearState> read_wear(const std::filesystem::path& folder, const std::string& digest);

} // namespace bem_contact::app
