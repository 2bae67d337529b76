#pragma once

#include "bem_contact/wear/evolution.hpp"

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace bem_contact::app {

/// What has become of both bodies after a step.
struct WearRow {
  double step = 0, revolutions = 0, mileage = 0; ///< 1, 1, km
  double rail_depth = 0, wheel_depth = 0;        ///< largest depth of each body, mm
  double rail_area = 0, wheel_area = 0;          ///< gone from each section, mm^2
};

/// A column of wear.csv and a dataset of wear.h5.
struct WearColumn {
  const char *name, *unit;
  double WearRow::*member;
};
inline constexpr std::array<WearColumn, 7> wear_columns{{{"step", "1", &WearRow::step},
                                                         {"revolutions", "1", &WearRow::revolutions},
                                                         {"mileage", "km", &WearRow::mileage},
                                                         {"rail_depth", "mm", &WearRow::rail_depth},
                                                         {"wheel_depth", "mm", &WearRow::wheel_depth},
                                                         {"rail_area", "mm^2", &WearRow::rail_area},
                                                         {"wheel_area", "mm^2", &WearRow::wheel_area}}};

/// What `bem_contact wear` keeps between two steps, and after the last.
struct WearState {
  int step = 0;
  wear::WornPair pair;
  std::vector<WearRow> history; ///< one row a step, 0 included
};

/// The row of the history of a state; the mileage is that of a wheel of this radius, mm.
WearRow history_row(int step, const wear::WornPair& pair, double wheel_radius);

/// The name of a body's file of a step: rail_0001.txt. `extension`: txt, h5 or toml.
std::string step_file(std::string_view body, int step, std::string_view extension);

/// Writes profiles of this step (rail_0001.txt), wear.csv, and last the state (state.txt), each whole or not
/// at all: a kill at any moment leaves the state of a finished step.
void write_wear(const std::filesystem::path& folder, const std::string& digest, const WearState& state);

/// The state of a folder; nothing if the folder is empty. Throws InputError if the state is of another scene
/// or damaged, and if there are only other files: writing would overwrite those of the same name.
std::optional<WearState> read_wear(const std::filesystem::path& folder, const std::string& digest);

} // namespace bem_contact::app
