#include "bem_contact/uses/table/scene_table.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/scene/derivative_inputs.hpp"
#include "bem_contact/scene/scene_reader.hpp"
#include "bem_contact/scene/sweep_file.hpp"
#include "bem_contact/sequence/quantities.hpp"
#include "bem_contact/sequence/sequence.hpp"
#include "bem_contact/sequence/uncertified.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <limits>
#include <numbers>
#include <utility>

namespace bem_contact::table {

namespace {

/// mm. Errors of positions and rolling radii are relative to their range in the table, or to this.
constexpr double shortest_range = 1.0;
/// rad. The same of angles.
constexpr double smallest_turn = 0.1;

/// What errors of a column are relative to.
enum class ScaleBy { force, moment, length_range, angle_range, largest };

/// A column: one of quantities(), or of patch_quantities() for the patch with the largest force.
struct ColumnSource {
  const char* name; ///< in the table
  const char* of;   ///< quantity
  ScaleBy scale = ScaleBy::largest;
  bool usual = false; ///< held unless the scene says otherwise
  bool patch = false;
};

constexpr ColumnSource sources[] = {
    {"Fx", "Fx", ScaleBy::force, true},
    {"Fy", "Fy", ScaleBy::force, true},
    {"Fz", "Fz", ScaleBy::force, true},
    {"Mz", "Mz", ScaleBy::moment, true},
    {"approach", "approach", ScaleBy::largest, true},
    {"pmax", "pmax", ScaleBy::largest, true},
    {"area", "area", ScaleBy::largest, true},
    {"free_rolling_radius", "free_rolling_radius", ScaleBy::length_range, true},
    {"reference_y", "reference_y", ScaleBy::length_range},
    {"reference_z", "reference_z", ScaleBy::length_range},
    {"reference_delta", "reference_delta", ScaleBy::angle_range},
    {"adhesion_share", "adhesion_share"},
    {"T_gamma", "T_gamma"},
    {"patch_count", "patch_count"},
    {"patch_semi_axis_a", "semi_axis_a", ScaleBy::largest, false, true},
    {"patch_semi_axis_b", "semi_axis_b", ScaleBy::largest, false, true},
    {"patch_y", "y", ScaleBy::length_range, false, true},
    {"patch_z", "z", ScaleBy::length_range, false, true},
    {"patch_delta", "delta", ScaleBy::angle_range, false, true},
    {"patch_rail_y", "rail_y", ScaleBy::length_range, false, true},
    {"patch_wheel_y", "wheel_y", ScaleBy::length_range, false, true},
};

Column column_of(const ColumnSource& source) {
  if (!source.patch) {
    const Quantity& q = quantity(source.of);
    return {.name = source.name, .unit = q.unit.rolling, .description = q.meaning};
  }
  const PatchQuantity& q = named(patch_quantities(), source.of);
  return {.name = source.name,
          .unit = q.unit.rolling,
          .description = fmt::format("of the patch with the largest force: {}", q.meaning)};
}

PointValues values_of(const SceneResult& r) {
  PointValues out;
  for (const ColumnSource& source : sources) {
    const auto add = [&](const auto& q, auto... patch) {
      const Measured number = q.measured(r, patch...);
      out.values.push_back(number);
      out.element_errors.push_back(number.error);
    };
    if (!source.patch)
      add(quantity(source.of));
    else if (!r.result.patches.empty())
      add(named(patch_quantities(), source.of), std::size_t{0});
    else
      out.values.push_back(unknown_error), out.element_errors.push_back(unknown_error);
  }
  return out;
}

std::string text_of(const SceneTable& described, const Point& point) {
  std::vector<std::string> parts;
  for (std::size_t a = 0; a < point.size(); ++a)
    parts.push_back(fmt::format("{} = {:.9g}", described.axes[a].key, point[a]));
  return fmt::format("{}", fmt::join(parts, ", "));
}

SceneFile scene_at(const SceneTable& described, SceneReader& reader, const Point& point) {
  for (std::size_t a = 0; a < point.size(); ++a)
    reader.set_number(described.axes[a].key, point[a]);
  return with_model(reader.scene(), described.model);
}

/// Names that hold may have, and those that it has by itself.
void mark_held(ContactTable& table, const SceneTable& described, const SceneFile& scene) {
  for (const std::string& name : described.hold)
    table.column(name);
  const bool rolls_freely = scene.kind == SceneKind::wheel_rail && scene.motion.kind == MotionKind::steady &&
                            !scene.motion.frictionless && scene.motion.free_rolling;
  for (std::size_t c = 0; c < table.columns.size(); ++c) {
    Column& column = table.columns[c];
    column.held = described.hold.empty()
                      ? sources[c].usual && (rolls_freely || column.name != "free_rolling_radius")
                      : std::ranges::find(described.hold, column.name) != described.hold.end();
  }
}

} // namespace

SceneTable parse_scene_table(SceneText given) {
  const SweepFile lists = parse_sweep_file(std::move(given), "table");
  SceneTable out{lists.text};
  for (const SweepFile::Axis& axis : lists.axes) {
    SceneTable::KeyAxis numbers{axis.key, {}};
    for (const SchemaValue& value : axis.values) {
      const auto* real = std::get_if<double>(&value);
      const auto* whole = std::get_if<std::int64_t>(&value);
      const auto* text = std::get_if<std::string>(&value);
      if (real || whole)
        numbers.points.push_back(real ? *real : static_cast<double>(*whole));
      else if (text && axis.key == "hold")
        out.hold.push_back(*text);
      else
        throw InputError(fmt::format("{}:{}: table.{} is no axis", out.text.source, axis.line, axis.key),
                         "its list holds something that is no number",
                         "Give a list of numbers; make a table for each profile or model.");
    }
    if (axis.key != "hold")
      out.axes.push_back(std::move(numbers));
  }
  return out;
}

ContactTable table_of(const SceneTable& described) {
  ContactTable table;
  for (const SceneTable::KeyAxis& axis : described.axes) {
    const std::vector<double>& points = axis.points;
    if (points.size() < 2 || std::ranges::adjacent_find(points, std::greater_equal()) != points.end() ||
        !std::ranges::all_of(points, [](double p) { return std::isfinite(p); }))
      throw InputError(fmt::format("table.{} is no axis", axis.key),
                       "its values do not grow, or there is only one",
                       "Give two or more in growing order; a single value belongs into the scene.");
    const std::string unit = unit_of_key(axis.key);
    table.axes.push_back({axis.key, unit.empty() ? "1" : unit, "key of the scene", points});
  }
  if (table.axes.empty())
    throw InputError("The table has no axis", "no list of numbers is given",
                     "Give lists for keys of the scene, such as position.lateral and load.force.");
  for (const ColumnSource& source : sources)
    table.columns.push_back(column_of(source));
  SceneReader reader(described.text);
  Point last;
  for (const Axis& axis : table.axes)
    last.push_back(axis.points.back());
  scene_at(described, reader, last);
  const SceneFile first = first_scene(described);
  refuse_derivatives(first, "a table");
  mark_held(table, described, first);
  return table;
}

SceneFile first_scene(const SceneTable& described) {
  SceneReader reader(described.text);
  Point first;
  for (const SceneTable::KeyAxis& axis : described.axes)
    first.push_back(axis.points.at(0));
  return scene_at(described, reader, first);
}

PointSolver scene_point_solver(const SceneTable& described) {
  struct Solver {
    explicit Solver(const SceneText& text) : reader(text) {}

    SceneReader reader;
    Sequence sequence{{.displacements = false}};
  };
  return [described, solver = std::make_shared<Solver>(described.text)](const Point& point) {
    const auto named = [&](const Error& error) {
      return fmt::format("The table has no value at {}: {}", text_of(described, point), error.what());
    };
    try {
      const SceneResult result = solver->sequence.solve(scene_at(described, solver->reader, point));
      require_certified(result);
      return values_of(result);
    } catch (const InputError& error) {
      throw InputError(named(error));
    } catch (const ConvergenceError& error) {
      throw ConvergenceError(named(error));
    }
  };
}

void rescale(ContactTable& table) {
  const auto largest = [&](std::string_view name) {
    double out = 0;
    for (const double value : table.column(name).values)
      out = std::fmax(out, std::abs(value)); // leaves nan out
    return out;
  };
  const double force = largest("Fz"), radius = std::sqrt(largest("area") / std::numbers::pi);
  for (std::size_t c = 0; c < table.columns.size(); ++c) {
    Column& column = table.columns[c];
    const auto range = [&](double shortest) {
      double low = std::numeric_limits<double>::infinity(), high = -low;
      for (const double value : column.values)
        low = std::fmin(low, value), high = std::fmax(high, value);
      return std::max(high - low, shortest);
    };
    const ScaleBy by = sources[c].scale;
    column.scale = by == ScaleBy::force          ? force
                   : by == ScaleBy::moment       ? force * radius
                   : by == ScaleBy::length_range ? range(shortest_range)
                   : by == ScaleBy::angle_range  ? range(smallest_turn)
                                                 : largest(column.name);
    if (!(column.scale > 0))
      column.scale = 1; // all of it is zero
  }
}

} // namespace bem_contact::table
