#include "bem_contact/scene/friction_laws.hpp"
#include "bem_contact/scene/scene_keys.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <functional>
#include <utility>
#include <vector>

namespace bem_contact {

namespace {

/// tau_0 over temperature.
void check_yield_by_heat(const SceneFile& f, const Schema& s) {
  const std::vector<double>&at = f.layer.yield_temperatures, &shears = f.layer.yield_shears;
  if (at.empty() && shears.empty())
    return;
  if (at.size() != shears.size())
    s.refuse(shears.empty() ? "layer.yield_temperatures" : "layer.yield_shears",
             fmt::format("there are {} temperatures and {} limits", at.size(), shears.size()),
             "Give layer.yield_temperatures and yield_shears, one limit for each temperature.");
  if (f.layer.yield_shear)
    s.refuse("layer.yield_shears", "layer.yield_shear is given too", "Give one of the two.");
  if (!std::ranges::is_sorted(at, std::less_equal<>()))
    s.refuse("layer.yield_temperatures", "they do not rise", "Give the coldest first, each once.");
  if (!std::ranges::is_sorted(shears, std::greater<>()))
    s.refuse(
        "layer.yield_shears",
        "a layer that bears more the hotter it is heats itself further, so that there may be more than one "
        "solution",
        "Give limits that do not rise with temperature.");
  if (!f.temperature.flash && !f.motion.frictionless)
    s.refuse("layer.yield_shears", "temperatures are not asked for",
             "Set temperature.flash = true, or give layer.yield_shear.");
}

} // namespace

void check_layer(const SceneFile& f, const Schema& s) {
  const SceneFile::Layer& layer = f.layer;
  if (layer.shear_modulus.has_value() != layer.thickness.has_value())
    s.refuse(layer.shear_modulus ? "layer.shear_modulus" : "layer.thickness",
             fmt::format("layer.{} is not given", layer.shear_modulus ? "thickness" : "shear_modulus"),
             "Give both: the compliance is thickness / shear_modulus.");
  const char* first = nullptr;
  for (const auto& [key, given] : {std::pair{"layer.compliance", layer.compliance.has_value()},
                                   {"layer.shear_modulus", layer.shear_modulus.has_value()},
                                   {"layer.table", !layer.table.empty()},
                                   {"layer.slope", layer.slope.has_value()}}) {
    if (given && first)
      s.refuse(key, fmt::format("{} is given too", first), "Give one of the two.");
    if (given)
      first = key;
  }
  if (layer.slope && f.motion.frictionless)
    s.refuse("layer.slope", "without friction there is no shear force", "Leave it out.");
  if (layer.slope && f.motion.kind != MotionKind::steady)
    s.refuse("layer.slope", "it is the slope of steady rolling",
             "Choose motion.kind = \"steady\", or give layer.compliance.");
  check_yield_by_heat(f, s);
  if (layer.hardening != 0 && !layer.yields())
    s.refuse("layer.hardening", "layer.yield_shear is not given",
             "Give the traction at which the layer yields.");
  if (layer.yields() && f.motion.kinetic_friction)
    s.refuse(layer.yield_shear ? "layer.yield_shear" : "layer.yield_shears",
             "motion.kinetic_friction is another law of what slips", "Give one of the two.");
  const bool falls = asked_law(f.motion) || f.temperature.hot_friction;
  if (layer.hardening != 0 && falls)
    s.refuse("layer.hardening", "friction falls with slip velocity or temperature",
             "Give a layer that does not harden, or constant friction.");
  if (layer.normal_compliance > 0 && f.solver.model == Model::hertz)
    s.refuse("layer.normal_compliance", "Hertz's closed form has no layer between the bodies",
             "Choose another solver.model.");
}

} // namespace bem_contact
