#include "bem_contact/app/wear_state.hpp"

#include "bem_contact/app/csv_name.hpp"
#include "bem_contact/app/scene_record.hpp"
#include "bem_contact/base/error.hpp"
#include "bem_contact/base/input_file.hpp"
#include "bem_contact/base/output_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <ostream>
#include <sstream>

namespace bem_contact::app {

namespace {

constexpr const char* state_format = "bem_contact wear 1";

std::vector<double> values_of(const wear::WearRow& row) {
  std::vector<double> out;
  for (const wear::WearColumn& column : wear::wear_columns)
    out.push_back(row.*column.member);
  return out;
}

void write_body(std::ostream& out, const wear::WornBody& body) {
  out << fmt::format("{} {}\n", body.points.size(), body.area);
  for (std::size_t i = 0; i < body.points.size(); ++i)
    out << fmt::format("{} {} {}\n", body.points[i].y, body.points[i].z, body.depth[i]);
}

void read_body(std::istream& in, wear::WornBody& body) {
  std::size_t points = 0;
  in >> points >> body.area;
  for (std::size_t i = 0; i < points && in; ++i) {
    Point2 p;
    double depth = 0;
    in >> p.y >> p.z >> depth;
    body.points.push_back(p);
    body.depth.push_back(depth);
  }
}

} // namespace

std::string step_file(std::string_view body, int step, std::string_view extension) {
  return fmt::format("{}_{:04}.{}", body, step, extension);
}

void write_wear(const std::filesystem::path& folder, const std::string& digest, const WearState& state) {
  wear::write_profile(folder / step_file("rail", state.step, "txt"), state.pair.rail.points);
  wear::write_profile(folder / step_file("wheel", state.step, "txt"), state.pair.wheel.points);
  write_whole(folder / "wear.csv", [&](std::ostream& out) {
    std::vector<std::string> names;
    for (const wear::WearColumn& column : wear::wear_columns)
      names.push_back(csv_name(column.name, column.unit));
    out << fmt::format("{}\n", fmt::join(names, ","));
    for (const wear::WearRow& row : state.history)
      out << fmt::format("{:.9g}\n", fmt::join(values_of(row), ","));
  });
  write_whole(folder / "state.txt", [&](std::ostream& out) {
    out << state_format << '\n' << digest << '\n';
    out << fmt::format("{} {} {}\n", state.step, state.pair.revolutions, state.history.size());
    for (const wear::WearRow& row : state.history)
      out << fmt::format("{}\n", fmt::join(values_of(row), " "));
    write_body(out, state.pair.rail);
    write_body(out, state.pair.wheel);
    out << "end\n";
  });
}

std::optional<WearState> read_wear(const std::filesystem::path& folder, const std::string& digest) {
  const std::filesystem::path file = folder / "state.txt";
  if (!file_exists(file)) {
    if (!std::filesystem::is_empty(folder))
      throw InputError(fmt::format("The output '{}' exists and is not of this wear", folder.string()),
                       "it is not empty, and there is no state.txt in it: its files might be overwritten",
                       "Give a new folder, or an empty one.");
    return std::nullopt;
  }
  std::istringstream in(read_text_file(file.string(), "state of wear"));
  std::string format, known, end;
  std::getline(in, format);
  std::getline(in, known);
  if (format != state_format || known != digest)
    throw InputError(fmt::format("The output '{}' exists and is not of this wear", folder.string()),
                     digest_changed, "Give another folder, or remove it.");
  WearState state;
  std::size_t rows = 0;
  in >> state.step >> state.pair.revolutions >> rows;
  for (std::size_t i = 0; i < rows && in; ++i) {
    wear::WearRow& row = state.history.emplace_back();
    for (const wear::WearColumn& column : wear::wear_columns)
      in >> row.*column.member;
  }
  read_body(in, state.pair.rail);
  read_body(in, state.pair.wheel);
  in >> end;
  if (end != "end")
    throw InputError(fmt::format("'{}' is damaged", file.string()), "its end is missing",
                     "Remove the folder and begin again.");
  return state;
}

} // namespace bem_contact::app
