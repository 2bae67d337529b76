#include "bem_contact/app/wear_state.hpp"

#include "bem_contact/app/csv_name.hpp"
#include "bem_contact/app/datasets.hpp"
#include "bem_contact/app/scene_record.hpp"
#include "bem_contact/base/error.hpp"
#include "bem_contact/base/input_file.hpp"
#include "bem_contact/base/output_file.hpp"
#include "bem_contact/influence/h5_table.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <ostream>
#include <ranges>

namespace bem_contact::app {

namespace {

constexpr const char *state_file = "wear.h5", *wear_format = "bem_contact wear";

/// All of the state: the last row of the history has what WearState holds beside it.
H5Table table_of(const WearState& state, const std::string& digest) {
  H5Table table;
  for (const wear::WearColumn& column : wear::wear_columns) {
    std::vector<double> values;
    for (const wear::WearRow& row : state.history)
      values.push_back(row.*column.member);
    table.datasets[column.name] = line(std::move(values), column.unit, "by step");
  }
  const auto body = [&](const std::string& name, const wear::WornBody& worn) {
    table.datasets[name + "/profile"] = points(worn.points, "worn profile (y, z), own frame, z down");
    table.datasets[name + "/depth"] = line(worn.depth, "mm", "taken off along the normals");
  };
  body("rail", state.pair.rail);
  body("wheel", state.pair.wheel);
  table.attributes["format"] = std::string(wear_format);
  table.attributes["digest"] = digest;
  return table;
}

/// A dataset of `count` numbers.
const std::vector<double>& values_of(const H5Table& table, const std::string& name, std::size_t count) {
  const auto found = table.datasets.find(name);
  if (found == table.datasets.end() || found->second.values.size() != count)
    throw InputError(fmt::format("The state {} of this wear is damaged", state_file),
                     fmt::format("'{}' is not {} numbers", name, count),
                     "Remove the folder and begin again.");
  return found->second.values;
}

std::size_t size_of(const H5Table& table, const std::string& name) {
  const auto found = table.datasets.find(name);
  return found == table.datasets.end() ? 0 : found->second.values.size();
}

wear::WornBody body_of(const H5Table& table, const std::string& name, double area) {
  const std::size_t count =
      std::max<std::size_t>(size_of(table, name + "/depth"), 3); // of a profile's points
  wear::WornBody out{.points = {}, .depth = values_of(table, name + "/depth", count), .area = area};
  const std::vector<double>& points = values_of(table, name + "/profile", 2 * count);
  for (std::size_t i = 0; i < points.size(); i += 2)
    out.points.push_back({points[i], points[i + 1]});
  return out;
}

} // namespace

std::string step_file(std::string_view body, int step, std::string_view extension) {
  return fmt::format("{}_{:04}.{}", body, step, extension);
}

void write_wear(const std::filesystem::path& folder, const std::string& digest, const WearState& state) {
  wear::write_profile(folder / step_file("rail", state.step, "txt"), state.pair.rail.points);
  wear::write_profile(folder / step_file("wheel", state.step, "txt"), state.pair.wheel.points);
  write_whole(folder / "wear.csv", [&](std::ostream& out) {
    const auto each = [](const auto& of) { return wear::wear_columns | std::views::transform(of); };
    const auto name = [](const auto& column) { return csv_name(column.name, column.unit); };
    out << fmt::format("{}\n", fmt::join(each(name), ","));
    for (const wear::WearRow& row : state.history)
      out << fmt::format("{:.9g}\n",
                         fmt::join(each([&](const auto& column) { return row.*column.member; }), ","));
  });
  write_h5(folder / state_file, table_of(state, digest));
}

std::optional<WearState> read_wear(const std::filesystem::path& folder, const std::string& digest) {
  const auto refuse = [&](const std::string& why, const char* what_to_do) {
    throw InputError(fmt::format("The output '{}' exists and is not of this wear", folder.string()), why,
                     what_to_do);
  };
  if (!file_exists(folder / state_file)) {
    if (!std::filesystem::is_empty(folder))
      refuse(fmt::format("it is not empty, and there is no {} in it: its files might be overwritten",
                         state_file),
             "Give a new folder, or an empty one.");
    return std::nullopt;
  }
  const H5Table table = read_h5(folder / state_file);
  if (text_attribute(table, "format") != wear_format || text_attribute(table, "digest") != digest)
    refuse(digest_changed, "Give another folder, or remove it.");
  WearState state;
  state.history.resize(std::max<std::size_t>(size_of(table, "step"), 1));
  for (const wear::WearColumn& column : wear::wear_columns) {
    const std::vector<double>& values = values_of(table, column.name, state.history.size());
    for (std::size_t i = 0; i < state.history.size(); ++i)
      state.history[i].*column.member = values[i];
  }
  const wear::WearRow& last = state.history.back();
  state.step = static_cast<int>(last.step);
  state.pair = {body_of(table, "rail", last.rail_area), body_of(table, "wheel", last.wheel_area),
                last.revolutions};
  return state;
}

} // namespace bem_contact::app
