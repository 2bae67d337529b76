#include "bem_contact/app/wear/wear_state.hpp"

#include "bem_contact/app/output/csv.hpp"
#include "bem_contact/app/output/scene_record.hpp"
#include "bem_contact/base/error.hpp"
#include "bem_contact/base/input_file.hpp"
#include "bem_contact/base/output_file.hpp"
#include "bem_contact/influence/file_kinds.hpp"
#include "bem_contact/influence/h5_table.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <ostream>
#include <set>

namespace bem_contact::app {

namespace {

constexpr const char *table_file = "wear.csv", *state_file = "wear.h5";

/// All of the state: the last row of the history has what WearState holds beside it.
H5Table table_of(const WearState& state, const std::string& digest) {
  H5Table table;
  for (const wear::WearColumn& column : wear::wear_columns())
    table.datasets[column.name] =
        H5Dataset::line(column.values(state.history), column.unit, column.description);
  const auto body = [&](const std::string& name, const wear::WornBody& worn) {
    table.datasets[name + "/profile"] =
        H5Dataset::points(worn.points, "worn profile (y, z), own frame, z down");
    table.datasets[name + "/depth"] = H5Dataset::line(worn.depth, "mm", "taken off along the normals");
  };
  body("rail", state.pair.rail);
  body("wheel", state.pair.wheel);
  table.attributes["format"] = std::string(wear_format);
  table.attributes["digest"] = digest;
  return table;
}

wear::WornBody body_of(const H5Table& table, const std::string& name, const std::filesystem::path& file,
                       double area) {
  wear::WornBody out{.points = {}, .depth = dataset_of(table, name + "/depth", file).values, .area = area};
  const std::vector<double>& points = dataset_of(table, name + "/profile", file, 2 * out.depth.size()).values;
  for (std::size_t i = 0; i < points.size(); i += 2)
    out.points.push_back({points[i], points[i + 1]});
  return out;
}

/// Whether a folder without a state is empty but for what a wear leaves that was stopped while it wrote its
/// first step: the files of write_wear() from the first on, whole or under their temporary names.
bool may_begin_in(const std::filesystem::path& folder) {
  std::set<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (const std::string name = entry.path().filename().string(); name != lock_file_name)
      names.insert(name);
  for (const std::string& own : {step_file("rail", 0, "txt"), step_file("wheel", 0, "txt"),
                                 std::string(table_file), std::string(state_file)}) {
    std::erase_if(names, [&](const std::string& name) { return name.starts_with(own + ".tmp"); });
    if (names.erase(own) == 0)
      break;
  }
  return names.empty();
}

} // namespace

std::string step_file(std::string_view body, int step, std::string_view extension) {
  return fmt::format("{}_{:04}.{}", body, step, extension);
}

void write_wear(const std::filesystem::path& folder, const std::string& digest, const WearState& state) {
  wear::write_profile(folder / step_file("rail", state.step(), "txt"), state.pair.rail.points);
  wear::write_profile(folder / step_file("wheel", state.step(), "txt"), state.pair.wheel.points);
  write_whole(folder / table_file,
              [&](std::ostream& out) { write_csv(out, wear::wear_columns(), state.history); });
  write_h5(folder / state_file, table_of(state, digest));
}

std::optional<WearState> read_wear(const std::filesystem::path& folder, const std::string& digest) {
  const auto refuse = [&](const std::string& why, const char* what_to_do) {
    throw InputError(fmt::format("The output '{}' exists and is not of this wear", folder.string()), why,
                     what_to_do);
  };
  if (!file_exists(folder / state_file)) {
    if (!may_begin_in(folder))
      refuse(fmt::format("it is not empty, and there is no {} in it: its files might be overwritten",
                         state_file),
             "Give a new folder, or an empty one.");
    return std::nullopt;
  }
  const std::filesystem::path file = folder / state_file;
  const H5Table table = read_h5(file);
  if (text_attribute(table, "format") != wear_format || text_attribute(table, "digest") != digest)
    refuse(digest_changed, "Give another folder, or remove it.");
  WearState state;
  state.history.resize(dataset_of(table, "step", file).values.size());
  for (const wear::WearColumn& column : wear::wear_columns()) {
    const std::vector<double>& values = dataset_of(table, column.name, file, state.history.size()).values;
    for (std::size_t i = 0; i < state.history.size(); ++i)
      state.history[i].*column.member = values[i];
  }
  const wear::WearRow& last = state.history.back();
  state.pair = {body_of(table, "rail", file, last.rail_area), body_of(table, "wheel", file, last.wheel_area),
                last.revolutions, last.smoothing, last.smoothed_off};
  return state;
}

} // namespace bem_contact::app
