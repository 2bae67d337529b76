#pragma once

#include "bem_contact/wear/evolution.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace bem_contact::app {

/// What `bem_contact wear` keeps between two steps, and after the last.
struct WearState {
  int step = 0;
  wear::WornPair pair;
  std::vector<std::vector<double>> history; ///< one row a step, 0 included; columns of wear_columns
};

inline constexpr const char* wear_columns =
    "step,revolutions,mileage_km,rail_depth_mm,wheel_depth_mm,rail_area_mm2,wheel_area_mm2";

/// Largest depths, areas gone and mileage of a state, as a row of the history.
std::vector<double> history_row(int step, const wear::WornPair& pair, double wheel_radius);

/// Writes profiles of this step (rail_0001.txt), wear.csv, and last the state (state.txt), each whole or not
/// at all: a kill at any moment leaves the state of a finished step.
void write_wear(const std::filesystem::path& folder, const std::string& digest, const WearState& state);

/// The state of a folder; nothing if the folder is empty. Throws InputError if the state is of another scene
/// or damaged, and if there are only other files: writing would overwrite those of the same name.
std::optional<WearState> read_wear(const std::filesystem::path& folder, const std::string& digest);

} // namespace bem_contact::app
