#include "bem_contact/scene/surface_states.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/scene/friction_laws.hpp"
#include "bem_contact/scene/scene_keys.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <string>
#include <vector>

namespace bem_contact {

namespace {

constexpr std::string_view powders =
    "Hou, Kalousek, Magel (1997), piecewise linear as in example plastic_3bl of CONTACT";
constexpr std::string_view pressed = "powder sheared under 900 MPa";
constexpr std::optional<double> none;
constexpr SurfaceState all_states[] = {
    {"clean", 0, none, none, none, none, none, "Jayasree Krishnan, Yang, Li (2025), Lubricants 13, 287",
     "rig V-Track, dry steel without contamination, below 16 km/h: agrees with elastic theory"},
    {"rig", 3.28e-5, none, none, none, none, none, "Yokose (1973)",
     "rig of scale 1/5: 0.61 of Kalker's slope"},
    {"locomotive", 1.52e-4, none, none, 0.33, 0.14, 1250,
     "Engel, Beck, Alders (1998), fitted by Vollebregt (2014)",
     "Eurosprinter on dry track, 106.7 kN a wheel, 10 m/s, creepages above 0.5 %"},
    {"oxide", 1.13e-4, 560, 0, none, none, none, powders, pressed},
    {"sand", 1.13e-4, 400, -195, none, none, none, powders, pressed},
    {"clay", 1.88e-4, 200, 435, none, none, none, powders, pressed},
    {"MoS2", 9.88e-4, 20, 20.4, none, none, none, powders, pressed},
};

} // namespace

std::span<const SurfaceState> surface_states() {
  return all_states;
}

const SurfaceState* find_state(std::string_view name) {
  const auto at = std::ranges::find(all_states, name, &SurfaceState::name);
  return at == std::end(all_states) ? nullptr : &*at;
}

void apply_state(SceneFile& scene, const Schema& schema) {
  if (scene.layer.state.empty())
    return;
  const SurfaceState* state = find_state(scene.layer.state);
  if (!state) {
    std::vector<std::string_view> names;
    for (const SurfaceState& one : all_states)
      names.push_back(one.name);
    schema.refuse("layer.state", fmt::format("these are known: {}", fmt::join(names, ", ")),
                  "Name one of them, or give the layer's own keys.");
  }
  const auto has_any = [&](std::initializer_list<const char*> keys) {
    return std::ranges::any_of(keys, [&](const char* key) { return schema.has(key); });
  };
  if (state->compliance > 0 &&
      !has_any({"layer.compliance", "layer.shear_modulus", "layer.thickness", "layer.table", "layer.slope"}))
    scene.layer.compliance = state->compliance;
  if (state->yield_shear && !has_any({"layer.yield_shear", "layer.yield_shears"}))
    scene.layer.yield_shear = state->yield_shear;
  if (state->hardening && !schema.has("layer.hardening") && scene.layer.yields())
    scene.layer.hardening = *state->hardening;
  SceneFile::Motion& motion = scene.motion;
  if (!state->friction || has_any({"motion.friction", "motion.friction_table"}))
    return;
  motion.friction = *state->friction;
  const bool has_law = std::ranges::any_of(
      friction_laws(), [&](const AskedLaw& law) { return schema.has(law.numbers[0].key); });
  if (motion.speed && !has_law && !schema.has("motion.kinetic_friction")) {
    motion.falling_friction = state->falling;
    motion.half_slip_velocity = state->half_slip_velocity;
  }
}

} // namespace bem_contact
