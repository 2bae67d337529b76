#include "bem_contact/app/wear/wear_state.hpp"
#include "bem_contact/app/output/output_names.hpp"

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

constexpr const char *table_file = "wear.csv", *state_file = "wear.h5";

} // namespace

record::Record record_of(const WearState& state, const std::string& digest) {
  record::Record out = headed(wear_format);
  out.add("digest", digest);
  record::Table history = record::table_of("step", wear::wear_columns(), state.history);
  for (record::Column& column : history.columns)
    out.add(column.name, record::field(std::move(column.values), column.unit, column.meaning));
  const auto body = [&](const std::string& name, const wear::WornBody& worn) {
    std::vector<double> points;
    for (const Point2& p : worn.points)
      points.insert(points.end(), {p.y, p.z});
    out.add(name, record::Record{{"profile", record::field(std::move(points), "mm",
                                                           "worn profile (y, z), own frame, z down",
                                                           {worn.points.size(), 2})},
                                 {"depth", record::field(worn.depth, "mm", "taken off along the normals")}});
  };
  body("rail", state.pair.rail);
  body("wheel", state.pair.wheel);
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

void write_wear(OutputFolder& folder, const std::string& digest, const WearState& state) {
  for (const auto& [body, points] :
       {std::pair{"rail", &state.pair.rail.points}, {"wheel", &state.pair.wheel.points}}) {
    const std::string name = step_file(body, state.step(), "txt");
    wear::write_profile(folder.take(name), *points);
    folder.done(name);
  }
  folder.write(table_file, [&](std::ostream& out) {
    record::write_csv(out, record::table_of("step", wear::wear_columns(), state.history));
  });
  record::write_hdf5(folder.take(state_file), record_of(state, digest));
  folder.done(state_file);
}

std::optional<WearState> read_wear(const OutputFolder& folder, const std::string& digest) {
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
  state.pair = {body_of(stored, "rail", file, last.rail_area),
                body_of(stored, "wheel", file, last.wheel_area), last.revolutions, last.smoothing,
                last.smoothed_off};
  return state;
}

} // namespace bem_contact::app
