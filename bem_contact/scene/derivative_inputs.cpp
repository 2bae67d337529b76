#include "bem_contact/scene/derivative_inputs.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/scene/scene_file.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <iterator>
#include <string_view>

namespace bem_contact {

namespace {

constexpr std::string_view every_usual = "all";

/// A step is so large, and at least such a share of the number.
///
/// What a scene says of its elements is smooth in every number, so that a difference over both sides misses
/// by the square of the step. The step is large beside rounding: the search for the first touch knows places
/// to some 1e-11 mm.
struct Step {
  double least; ///< in the unit
  double share = 0;
};
constexpr Step length_step{1e-5};      // mm
constexpr Step angle_step{1e-7};       // rad: at a lever of 750 mm less than 0.0001 mm
constexpr Step creepage_step{1e-6};    // 1
constexpr Step spin_step{1e-7};        // 1/mm
constexpr Step curvature_step{1e-9};   // 1/mm, of a gap
constexpr Step coefficient_step{1e-5}; // 1, of friction
constexpr Step rate_step{1e-3, 1e-5};  // mm/s, rad/s
constexpr Step own_size{0, 1e-5};      // what has no scale but its own

/// One number. `value`: null where the scene does not give it.
struct Known {
  const char *name, *key, *unit;
  InputReach reach;
  Step step;
  bool usual; ///< of "all"
  double* (*value)(SceneFile&);
};

double* given(std::optional<double>& number) {
  return number ? &*number : nullptr;
}
double* above_zero(double& number) {
  return number > 0 ? &number : nullptr;
}
template <auto member> double* of_position(SceneFile& f) {
  return f.kind == SceneKind::wheel_rail ? &(f.position.*member) : nullptr;
}
template <auto member> double* of_wheel(SceneFile& f) {
  return f.kind == SceneKind::wheel_rail ? &(f.position.deviation.*member) : nullptr;
}
template <auto member> double* of_motion(SceneFile& f) {
  return f.motion.frictionless || !f.motion.slip_table.empty() ? nullptr : &(f.motion.*member);
}
/// A rate of the wheelset.
template <auto member> double* of_rates(SceneFile& f) {
  return f.motion.speed && f.kind == SceneKind::wheel_rail ? of_motion<member>(f) : nullptr;
}
double* friction_of(SceneFile& f) {
  return f.motion.frictionless || !f.motion.friction_table.empty() ? nullptr : &f.motion.friction;
}
template <auto member> double* of_gap(SceneFile& f) {
  return f.kind == SceneKind::patch && f.gap.table.empty() ? &(f.gap.*member) : nullptr;
}

using enum InputReach;
using Position = SceneFile::Position;
using Scene = SceneFile;
constexpr Known known_numbers[] = {
    {"load", "load.force", "N", bodies, own_size, true, [](Scene& f) { return given(f.load.force); }},
    {"load", "load.approach", "mm", bodies, length_step, true,
     [](Scene& f) { return given(f.load.approach); }},
    {"load", "position.vertical", "mm", bodies, length_step, true,
     [](Scene& f) { return given(f.position.vertical); }},
    {"lateral", "position.lateral", "mm", bodies, length_step, true, of_position<&Position::lateral>},
    {"roll", "position.roll", "rad", bodies, angle_step, true, of_position<&Position::roll>},
    {"yaw", "position.yaw", "rad", bodies, angle_step, true, of_position<&Position::yaw>},
    {"curve_radius", "track.curve_radius", "mm", motion, own_size, true,
     [](Scene& f) { return f.motion.speed ? given(f.track.curve_radius) : nullptr; }},
    {"xi", "motion.xi", "1", motion, creepage_step, true, of_motion<&Scene::Motion::xi>},
    {"eta", "motion.eta", "1", motion, creepage_step, true, of_motion<&Scene::Motion::eta>},
    {"phi", "motion.phi", "1/mm", motion, spin_step, true, of_motion<&Scene::Motion::phi>},
    {"friction", "motion.friction", "1", motion, coefficient_step, true, friction_of},
    {"force_x", "load.force_x", "N", motion, rate_step, true, [](Scene& f) { return given(f.load.force_x); }},
    {"force_s", "load.force_s", "N", motion, rate_step, true, [](Scene& f) { return given(f.load.force_s); }},
    {"compliance", "layer.compliance", "mm3/N", layer, own_size, true,
     [](Scene& f) { return given(f.layer.compliance); }},
    {"normal_compliance", "layer.normal_compliance", "mm3/N", layer, own_size, false,
     [](Scene& f) { return above_zero(f.layer.normal_compliance); }},
    {"yield_shear", "layer.yield_shear", "MPa", motion, own_size, false,
     [](Scene& f) { return given(f.layer.yield_shear); }},
    {"rail_inclination", "position.rail_inclination", "rad", bodies, angle_step, false,
     of_position<&Position::rail_inclination>},
    {"rail_lateral", "position.rail_lateral", "mm", bodies, length_step, false,
     of_position<&Position::rail_lateral>},
    {"rail_vertical", "position.rail_vertical", "mm", bodies, length_step, false,
     of_position<&Position::rail_vertical>},
    {"rail_roll", "position.rail_roll", "rad", bodies, angle_step, false, of_position<&Position::rail_roll>},
    {"wheel_lateral", "position.wheel_lateral", "mm", bodies, length_step, false,
     of_wheel<&WheelDeviation::lateral>},
    {"wheel_vertical", "position.wheel_vertical", "mm", bodies, length_step, false,
     of_wheel<&WheelDeviation::vertical>},
    {"wheel_roll", "position.wheel_roll", "rad", bodies, angle_step, false, of_wheel<&WheelDeviation::roll>},
    {"wheel_yaw", "position.wheel_yaw", "rad", bodies, angle_step, false, of_wheel<&WheelDeviation::yaw>},
    {"wheel_radius", "position.wheel_radius", "mm", bodies, length_step, false,
     of_position<&Position::wheel_radius>},
    {"gauge", "position.gauge", "mm", bodies, length_step, false, of_position<&Position::gauge>},
    {"back_to_back", "position.back_to_back", "mm", bodies, length_step, false,
     of_position<&Position::back_to_back>},
    {"rolling_radius", "motion.rolling_radius", "mm", motion, length_step, false,
     [](Scene& f) { return given(f.motion.rolling_radius); }},
    {"speed", "motion.speed", "mm/s", motion, own_size, false,
     [](Scene& f) { return given(f.motion.speed); }},
    {"pitch_rate", "motion.pitch_rate", "rad/s", motion, own_size, false,
     [](Scene& f) { return given(f.motion.pitch_rate); }},
    {"lateral_velocity", "motion.lateral_velocity", "mm/s", motion, rate_step, false,
     of_rates<&Scene::Motion::lateral_velocity>},
    {"vertical_velocity", "motion.vertical_velocity", "mm/s", motion, rate_step, false,
     of_rates<&Scene::Motion::vertical_velocity>},
    {"roll_rate", "motion.roll_rate", "rad/s", motion, rate_step, false, of_rates<&Scene::Motion::roll_rate>},
    {"yaw_rate", "motion.yaw_rate", "rad/s", motion, rate_step, false, of_rates<&Scene::Motion::yaw_rate>},
    {"gap_a", "gap.a", "1/mm", bodies, curvature_step, false, of_gap<&Scene::Gap::a>},
    {"gap_b", "gap.b", "1/mm", bodies, curvature_step, false, of_gap<&Scene::Gap::b>},
    {"gap_c", "gap.c", "1/mm", bodies, curvature_step, false, of_gap<&Scene::Gap::c>},
};

SceneNumber number_of(const Known& one, double* value) {
  return {one.name, one.key,   one.unit,
          value,    one.reach, std::max(one.step.least, one.step.share * std::abs(*value))};
}

} // namespace

std::vector<std::string> derivative_names() {
  std::vector<std::string> names{std::string(every_usual)};
  for (const Known& one : known_numbers)
    if (names.back() != one.name)
      names.emplace_back(one.name);
  names.insert(names.end(), {std::string(rail_profile_input), std::string(wheel_profile_input)});
  return names;
}

std::string derivative_name_of(std::string_view key) {
  const auto found = std::ranges::find(known_numbers, key, &Known::key);
  return found == std::end(known_numbers) ? "" : found->name;
}

void refuse_derivatives(const SceneFile& scene, std::string_view what) {
  if (!scene.derivatives.empty())
    refuse_derivatives(what);
}

void refuse_derivatives(std::string_view what) {
  throw InputError("There are no derivatives here", fmt::format("{} does not show them", what),
                   "Leave out derivatives, or ask bem_contact solve or sweep for them.");
}

std::vector<std::string> profile_inputs(const SceneFile& scene) {
  std::vector<std::string> out;
  for (const std::string_view name : {rail_profile_input, wheel_profile_input})
    if (std::ranges::find(scene.derivatives, name) != scene.derivatives.end())
      out.emplace_back(name);
  if (!out.empty() && scene.kind == SceneKind::patch)
    throw InputError(fmt::format("There are no derivatives with respect to '{}'", out.front()),
                     "a patch has no profiles", "Leave it out of derivatives.");
  return out;
}

std::vector<SceneNumber> derivative_inputs(SceneFile& scene) {
  const auto asks = [&](std::string_view name) {
    return std::ranges::find(scene.derivatives, name) != scene.derivatives.end();
  };
  std::vector<SceneNumber> out;
  std::vector<std::string> missing;
  for (const Known& one : known_numbers) {
    double* value = one.value(scene);
    if (value && (asks(one.name) || (one.usual && asks(every_usual))))
      out.push_back(number_of(one, value));
    else if (!value && asks(one.name))
      missing.emplace_back(one.name);
  }
  for (const std::string& name : missing)
    if (std::ranges::find(out, name, &SceneNumber::name) == out.end())
      throw InputError(fmt::format("There are no derivatives with respect to '{}'", name),
                       "the scene does not give this number, or it has no effect there",
                       "Give it, or leave it out of derivatives.");
  return out;
}

} // namespace bem_contact
