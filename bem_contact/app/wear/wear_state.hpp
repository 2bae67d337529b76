#pragma once

#include "bem_contact/uses/wear/evolution.hpp"

#include "bem_contact/base/output_folder.hpp"

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

/// All of the state: the last row of the history has what WearState holds beside it. `digest`: of the scene.
record::Record record_of(const WearState& state, const std::string& digest);

/// The name under which wear lists what it has written (base/output_folder.hpp).
inline constexpr const char* wear_maker = "wear";

/// Is in the folder while a run writes there (base/file_lock.hpp).
inline constexpr std::string_view lock_file_name = "wear.lock";

/// The name of a body's file of a step: rail_0001.txt. `extension`: txt, h5 or toml.
std::string step_file(std::string_view body, int step, std::string_view extension);

/// The same of a section of the rail, from 0: rail_0001_001.txt.
std::string section_file(std::size_t index, int step);

/// Writes profiles of this step (rail_0001.txt), wear.csv, and last the state (wear.h5), each whole or not
/// at all: a kill at any moment leaves the state of a finished step. Of a rail of sections a profile each,
/// what is gone from them by place (stretch.csv), and `scene` with these profiles (scene_0001.toml).
void write_wear(OutputFolder& folder, const std::string& digest, const SceneText& scene,
                const WearState& state);

/// The state of a folder; nothing where no first state was written. Throws InputError if it is of another
/// scene or damaged, and if a file that wear has written there was changed since. `unworn`: of the scene.
std::optional<WearState> read_wear(const OutputFolder& folder, const std::string& digest,
                                   const wear::WornPair& unworn);

} // namespace bem_contact::app
