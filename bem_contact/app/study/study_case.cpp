#include "bem_contact/app/study/study_case.hpp"

#include "bem_contact/app/study/study_parts.hpp"
#include "bem_contact/base/error.hpp"
#include "bem_contact/base/schema.hpp"
#include "bem_contact/base/toml.hpp"
#include "bem_contact/scene/absolute_names.hpp"
#include "bem_contact/scene/command_tables.hpp"
#include "bem_contact/scene/derivative_inputs.hpp"
#include "bem_contact/scene/surface_states.hpp"
#include "bem_contact/scene/sweep_file.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fmt/format.h>
#include <sstream>

namespace bem_contact::app {

namespace {

/// Keys whose values matter to every answer, and which a user may not know to have left open.
constexpr const char* keys_that_matter[] = {"solver.model",
                                            "track.network",
                                            "rail.profile",
                                            "wheel.profile",
                                            "position.wheel_radius",
                                            "position.rail_inclination",
                                            "position.gauge",
                                            "position.gauge_height",
                                            "position.back_to_back",
                                            "track.curve_radius",
                                            "motion.speed",
                                            "motion.friction",
                                            "grid.accuracy",
                                            "grid.dx",
                                            "grid.ds"};

/// Of these 0 says that there is none.
constexpr std::string_view zero_is_none[] = {"track.curve_radius", "motion.speed", "grid.accuracy"};

toml::table parsed(const std::string& text, const std::string& source) {
  try {
    return parse_toml(text, source);
  } catch (const toml::parse_error& error) {
    throw InputError(fmt::format("{}:{}: {}", source, error.source().begin.line, error.description()),
                     "the file is not valid TOML", "Correct the line.");
  }
}

Schema schema_of(StudyCase& study) {
  Schema out("scene for a study");
  out.share(""); // the scene's own keys
  SchemaTable uncertainty(out, "uncertainty"), influence(out, "influence");
  Uncertainty& u = study.uncertainty;
  const auto deviation = [&](const char* key, double& value, const char* of, const char* unit) {
    uncertainty.add(key, value, fmt::format("Standard deviation of {}", of), {.unit = unit, .at_least = 0});
  };
  deviation("friction", u.friction, "motion.friction", "");
  deviation("load", u.load, "load.force or wheelset.force", "N");
  deviation("lateral", u.lateral, "position.lateral", "mm");
  deviation("profile_noise", u.profile_noise, "the points of both profiles", "mm");
  constexpr int most_draws = 10000; // a typing error
  uncertainty.add("draws", u.draws, "How often the inputs are drawn", {.at_least = 2, .at_most = most_draws});
  uncertainty.add("seed", u.seed, "Other seeds give other draws", {.at_least = 0});
  std::vector<std::string> states, parts;
  for (const SurfaceState& state : surface_states())
    states.emplace_back(state.name);
  for (const Part& part : all_parts())
    parts.emplace_back(part.name);
  out.add("uncertainty.states", u.states, states, "none",
          "States of the surfaces (layer.state) that the study is answered for, too");
  out.add("uncertainty.parts", u.parts, parts, "all", "Parts of the study that are drawn or have states");
  influence.add("program", study.influence.program,
                "Program that is called with a body file and the influence file to write, if --influence "
                "names it, too");
  influence.add("rail", study.influence.rail, "Body file of rail.influence");
  influence.add("wheel", study.influence.wheel, "Body file of wheel.influence");
  return out;
}

/// Sets "table.key", whether the table is there or not.
void set(toml::table& root, const std::string& path, const SchemaValue& value) {
  toml::table* table = &root;
  std::size_t at = 0;
  for (std::size_t dot; (dot = path.find('.', at)) != std::string::npos; at = dot + 1) {
    const std::string name = path.substr(at, dot - at);
    if (!(*table)[name].is_table())
      table->insert_or_assign(name, toml::table());
    table = (*table)[name].as_table();
  }
  std::visit(
      [&]<class T>(const T& plain) {
        if constexpr (!std::is_same_v<T, std::vector<double>>)
          table->insert_or_assign(path.substr(at), plain);
      },
      value);
}

std::string text_of(const toml::table& root) {
  std::ostringstream out;
  out << root << '\n';
  return out.str();
}

} // namespace

bool StudyCase::has(std::string_view table) const {
  return std::ranges::find(tables, table) != tables.end();
}

std::string StudyCase::model_of(std::string_view table) const {
  return parsed(text.toml, text.source)[table]["model"].value_or(std::string());
}

StudyCase study_case(SceneText text) {
  StudyCase out{std::move(text), {}};
  require_text(out.text.toml, out.text.source, "scene");
  for (const auto& [name, node] : parsed(out.text.toml, out.text.source))
    out.tables.emplace_back(name == "passage" ? "sweep" : name.str()); // which solves the cases of both
  schema_of(out).read(out.text.toml, out.text.source);
  if (out.has("derivatives"))
    refuse_derivatives("a study");
  return out;
}

std::string changed_text(const SceneText& scene, std::span<const SceneChange> changes,
                         std::span<const std::string_view> dropped) {
  toml::table root = parsed(scene.toml, scene.source);
  for (const std::string_view table : dropped)
    root.erase(table);
  for (const SceneChange& change : changes)
    set(root, change.key, change.value);
  return with_absolute_names({text_of(root), scene.source, scene.folder});
}

WheelOfStudy wheel_of(const record::Record& found) {
  const auto number = [&](const std::string& path) { return record::number_at(found, path).value(); };
  const WheelSide side = number("wheelset/lateral") < 0 ? WheelSide::left : WheelSide::right;
  const std::string result = fmt::format("{}/result/", name_of(side));
  return {.side = side,
          .model = std::string(record::text_at(found, result + "model").value()),
          .dx = number(result + "quantities/dx"),
          .ds = number(result + "quantities/ds")};
}

std::string wheel_text(const SceneText& scene, const record::Record& found) {
  const auto number = [&](const std::string& path) { return record::number_at(found, path).value(); };
  const auto [side, model, dx, ds] = wheel_of(found);
  SceneFile one = with_elements(with_model(one_wheel(parse_scene_file(scene), side), model), dx, ds);
  one.position.lateral = number("wheelset/lateral");
  one.position.roll = number("wheelset/roll");
  one.track.superelevation = 0; // of an axle
  one.load = {.force = number(fmt::format("{}/track/Fz", name_of(side)))};
  const std::optional<double> radius = record::number_at(found, "wheelset/rolling_radius");
  if (radius && std::isfinite(*radius) && !one.motion.pitch_rate)
    one.motion.rolling_radius = radius;
  toml::table root = parsed(scene_with_defaults(one), "scene");
  toml::table given = parsed(scene.toml, scene.source);
  for (const std::string_view name : command_tables)
    if (toml::table* table = given[name].as_table())
      root.insert_or_assign(name, std::move(*table));
  if (toml::table* wear = given["wear"].as_table())
    root.insert_or_assign("wear", std::move(*wear));
  return with_absolute_names({text_of(root), scene.source, scene.folder});
}

std::vector<TakenValue> taken_values(const SceneText& scene) {
  const toml::table given = parsed(scene.toml, scene.source);
  toml::table all;
  try {
    const SceneFile first =
        has_sweep(scene) ? parse_sweep_file(scene).first_scene() : parse_scene_file(scene);
    all = parsed(scene_with_defaults(first), "scene");
  } catch (const InputError&) { // the parts say what is wrong
    all = given;
  }
  std::vector<TakenValue> out;
  for (const char* key : keys_that_matter) {
    const auto node = all.at_path(key);
    const std::string_view name = key;
    const bool given_here = static_cast<bool>(given.at_path(key));
    const bool found = name.starts_with("grid.d") && all.at_path("grid.accuracy").value_or(0.0) > 0;
    const bool none = !given_here && node.value_or(1.0) == 0 && std::ranges::count(zero_is_none, name) > 0;
    if (!node || found || none)
      continue;
    std::string value;
    if (given.at_path(fmt::format("sweep.{}", key))) {
      out.push_back({key, "as [sweep] lists it", "", true});
      continue;
    }
    if (const auto text = node.value<std::string>())
      value = *text;
    else if (const auto number = node.value<double>())
      value = fmt::format("{:.9g}", *number);
    out.push_back({key, value, unit_of_key(key), given_here});
  }
  return out;
}

} // namespace bem_contact::app
