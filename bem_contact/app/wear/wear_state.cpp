#include "bem_contact/app/wear/wear_state.hpp"

#include "bem_contact/app/output/output_names.hpp"
#include "bem_contact/app/wear/worn_scene.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/base/input_file.hpp"
#include "bem_contact/base/output_file.hpp"
#include "bem_contact/record/csv.hpp"
#include "bem_contact/record/file_kinds.hpp"
#include "bem_contact/record/hdf5.hpp"
#include "bem_contact/sequence/scene_record.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <ostream>
#include <utility>

namespace bem_contact::app {

namespace {

constexpr const char *table_file = "wear.csv", *stretch_file = "stretch.csv", *state_file = "wear.h5";

record::Record record_of(const wear::WornBody& worn) {
  std::vector<double> points;
  for (const Point2& p : worn.points)
    points.insert(points.end(), {p.y, p.z});
  return {{"profile", record::field(std::move(points), "mm", "worn profile (y, z), own frame, z down",
                                    {worn.points.size(), 2})},
          {"depth", record::field(worn.depth, "mm", "taken off along the normals")}};
}

std::string section_name(std::size_t index) {
  return fmt::format("{:03}", index + 1);
}

record::Table stretch_of(const wear::WornPair& pair) {
  return record::table_of("section", wear::section_columns(), wear::section_rows(pair.sections));
}

/// The files of a step, and what is in them.
std::vector<std::pair<std::string, const std::vector<Point2>*>> profiles_of(const WearState& state) {
  std::vector<std::pair<std::string, const std::vector<Point2>*>> out;
  const wear::WornPair& pair = state.pair;
  if (pair.sections.empty())
    out.emplace_back(step_file("rail", state.step(), "txt"), &pair.rail.points);
  for (std::size_t i = 0; i < pair.sections.size(); ++i)
    out.emplace_back(section_file(i, state.step()), &pair.sections[i].worn.points);
  out.emplace_back(step_file("wheel", state.step(), "txt"), &pair.wheel.points);
  return out;
}

} // namespace

record::Record record_of(const WearState& state, const std::string& digest) {
  record::Record out = headed(wear_format);
  out.add("digest", digest);
  record::Table history = record::table_of("step", wear::wear_columns(), state.history);
  for (record::Column& column : history.columns)
    out.add(column.name, record::field(std::move(column.values), column.unit, column.meaning));
  const wear::WornPair& pair = state.pair;
  if (pair.sections.empty())
    out.add("rail", record_of(pair.rail));
  out.add("wheel", record_of(pair.wheel));
  if (pair.sections.empty())
    return out;
  out.add("stretch", stretch_of(pair));
  record::Record sections;
  for (std::size_t i = 0; i < pair.sections.size(); ++i)
    sections.add(section_name(i), record_of(pair.sections[i].worn));
  out.add("sections", std::move(sections));
  return out;
}

namespace {

/// The numbers there. Throws InputError unless there are `count` (no count: one or more).
std::span<const double> stored_values(const record::Record& stored, const std::string& name,
                                      const std::filesystem::path& file,
                                      std::optional<std::size_t> count = {}) {
  const std::span<const double> values = record::values_at(stored, name);
  if (!std::ranges::all_of(values, [](double value) { return std::isfinite(value); }))
    throw InputError(fmt::format("The file '{}' is damaged", file.string()),
                     fmt::format("its dataset '{}' has a number that is none", name),
                     "Copy it again from where it was whole, or make it again.");
  if (values.empty() || values.size() != count.value_or(values.size()))
    throw InputError(
        fmt::format("The file '{}' is damaged", file.string()),
        values.empty() ? fmt::format("it has no dataset '{}'", name)
                       : fmt::format("its dataset '{}' has {} numbers, not {}", name, values.size(), *count),
        "Copy it again from where it was whole, or make it again.");
  return values;
}

wear::WornBody body_of(const record::Record& stored, const std::string& name,
                       const std::filesystem::path& file, double area) {
  const std::span<const double> depth = stored_values(stored, name + "/depth", file);
  wear::WornBody out{.points = {}, .depth = {depth.begin(), depth.end()}, .area = area};
  const std::span<const double> points = stored_values(stored, name + "/profile", file, 2 * out.depth.size());
  for (std::size_t i = 0; i < points.size(); i += 2)
    out.points.push_back({points[i], points[i + 1]});
  return out;
}

} // namespace

std::string step_file(std::string_view body, int step, std::string_view extension) {
  return fmt::format("{}_{:04}.{}", body, step, extension);
}

std::string section_file(std::size_t index, int step) {
  return fmt::format("rail_{:04}_{}.txt", step, section_name(index));
}

void write_wear(OutputFolder& folder, const std::string& digest, const SceneText& scene,
                const WearState& state) {
  for (const auto& [name, points] : profiles_of(state)) {
    wear::write_profile(folder.take(name), *points);
    folder.done(name);
  }
  if (!state.pair.sections.empty()) {
    folder.write(step_file("scene", state.step(), "toml"),
                 [&](std::ostream& out) { out << worn_scene(scene, state); });
    folder.write(stretch_file, [&](std::ostream& out) { record::write_csv(out, stretch_of(state.pair)); });
  }
  folder.write(table_file, [&](std::ostream& out) {
    record::write_csv(out, record::table_of("step", wear::wear_columns(), state.history));
  });
  record::write_hdf5(folder.take(state_file), record_of(state, digest));
  folder.done(state_file);
}

std::optional<WearState> read_wear(const OutputFolder& folder, const std::string& digest,
                                   const wear::WornPair& unworn) {
  folder.require_unchanged();
  if (!file_exists(folder / state_file))
    return std::nullopt;
  folder.require(state_file);
  const std::filesystem::path file = folder / state_file;
  const record::Record stored = record::read_hdf5(file);
  if (kind_of(record::text_at(stored, "format").value_or("")) != kind_of(wear_format) ||
      record::text_at(stored, "digest") != digest)
    throw InputError(fmt::format("The output '{}' exists and is not of this wear", folder.path().string()),
                     digest_changed, "Give another folder, or remove it.");
  WearState state;
  const std::size_t steps = stored_values(stored, "step", file).size();
  for (std::size_t i = 0; i < steps; ++i) {
    std::vector<double> values;
    for (const auto& column : wear::wear_columns())
      values.push_back(stored_values(stored, column.name, file, steps)[i]);
    state.history.push_back(wear::wear_row(values));
  }
  const wear::WearRow& last = state.history.back();
  state.pair = {{},
                body_of(stored, "wheel", file, last.wheel_area),
                last.revolutions,
                last.smoothing,
                last.smoothed_off,
                unworn.sections};
  if (state.pair.sections.empty()) {
    state.pair.rail = body_of(stored, "rail", file, last.rail_area);
    return state;
  }
  state.pair.rail.area = last.rail_area;
  const std::span<const double> areas =
      stored_values(stored, "stretch/area", file, state.pair.sections.size());
  for (std::size_t i = 0; i < areas.size(); ++i) {
    wear::WornBody& worn = state.pair.sections[i].worn;
    const std::size_t points = worn.points.size();
    worn = body_of(stored, "sections/" + section_name(i), file, areas[i]);
    stored_values(stored, fmt::format("sections/{}/depth", section_name(i)), file, points);
  }
  return state;
}

} // namespace bem_contact::app
