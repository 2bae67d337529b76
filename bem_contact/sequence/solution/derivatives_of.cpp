#include "bem_contact/sequence/solution/derivatives_of.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/scene/derivative_inputs.hpp"
#include "bem_contact/sequence/models.hpp"
#include "bem_contact/sequence/quantities.hpp"
#include "bem_contact/sequence/solution/numbers_of_grid.hpp"
#include "bem_contact/sequence/solution/structural_motion.hpp"

#include <fmt/format.h>

#include <utility>

namespace bem_contact {

namespace {

/// The bodies of a scene that differs from that of `asked` in one number.
ContactSetup changed_setup(const ContactCase& asked, const SceneFile& scene, InputReach reach) {
  if (reach != InputReach::bodies)
    return with_motion_of(scene, asked.setup);
  if (asked.setup.patch())
    return set_up_patch(scene);
  const WheelRailGeometry& placed = *asked.setup.wheel_rail();
  return set_up_contact(scene, {placed.pair.rail, placed.pair.wheel, placed.rail_inclination});
}

ContactOnGrid contact_of(const ContactSetup& setup, const ContactOnGrid& before, InputReach reach) {
  if (reach == InputReach::bodies)
    return setup.on(before.plan);
  ContactOnGrid out = before;
  out.problem.friction_rows.clear();
  apply_motion(setup.motion, setup.reference().delta, out.problem);
  if (out.problem.tangential) {
    out.problem.yield = setup.layer.yield;
    setup.prescribe({}, out.problem);
  }
  if (reach == InputReach::layer)
    out.layer = setup.layer.on(out.problem.rows);
  return out;
}

/// What a side has as a result, without fields that no quantity looks at.
SceneResult side_of(const ContactSetup& setup, ContactProblem problem, ContactResult continued) {
  SceneResult out;
  out.problem = std::move(problem);
  out.result = std::move(continued);
  out.motion.reference = setup.reference();
  if (const WheelRailGeometry* placed = setup.wheel_rail())
    out.motion.lowered = placed->lowered;
  out.moment = moment_about(out.motion.reference, out.result);
  return out;
}

InputDerivatives difference(const SceneNumber& number, const Tangent& tangent, const SceneResult& lower,
                            const SceneResult& upper, double step) {
  InputDerivatives out{number.name,   number.key,       number.unit,     {}, {}, tangent.below,
                       tangent.above, tangent.at_below, tangent.at_above};
  for (const std::string_view name : derived_totals()) {
    const Quantity& q = quantity(name);
    out.totals.push_back((q.value(upper) - q.value(lower)) / (2 * step));
  }
  for (std::size_t patch = 0; patch < lower.result.patches.size(); ++patch) {
    std::vector<double>& of_patch = out.patches.emplace_back();
    for (const std::string_view name : derived_patch_numbers()) {
      const PatchQuantity& q = named(patch_quantities(), name);
      of_patch.push_back((q.value(upper, patch) - q.value(lower, patch)) / (2 * step));
    }
  }
  return out;
}

/// Whether influence numbers change with the input.
bool moves_numbers(Model model, const ChangedContact& changed, InputReach reach) {
  if (reach == InputReach::layer)
    return true;
  if (!depends_on_both_rows(model))
    return false;
  const auto inclinations_differ = [&] {
    for (std::size_t row = 0; row < changed.lower.problem.rows.size(); ++row)
      if (changed.lower.problem.rows[row].delta != changed.upper.problem.rows[row].delta)
        return true;
    return false;
  };
  return !(numbers_source(model, changed.lower_case.setup, changed.lower) ==
           numbers_source(model, changed.upper_case.setup, changed.upper)) ||
         (turns_with_rows(model) && inclinations_differ());
}

/// The tangents of one solution, from input to input.
class DerivativesOfGrid {
public:
  DerivativesOfGrid(const ContactCase& asked, const GridSolution& solved, const SolveResources& resources)
      : asked_(asked), solved_(solved), resources_(resources), scene_(asked.scene),
        inputs_(derivative_inputs(scene_)) {}

  std::vector<InputDerivatives> with(InfluenceNumbers& numbers);

private:
  const ContactCase& asked_;
  const GridSolution& solved_;
  const SolveResources& resources_;
  SceneFile scene_;
  std::vector<SceneNumber> inputs_;
};

std::vector<InputDerivatives> DerivativesOfGrid::with(InfluenceNumbers& numbers) {
  std::vector<ChangedContact> sides;
  const auto input = [&](int k) -> TangentInput {
    ChangedContact& changed = sides.emplace_back(changed_contact(asked_, solved_.contact, k));
    TangentInput out{changed.lower.problem, changed.upper.problem, changed.step};
    if (moves_numbers(solved_.model, changed, inputs_[std::size_t(k)].reach)) {
      const auto numbers_of = [&](const ContactCase& asked, const ContactOnGrid& contact) {
        InfluenceNumbers all = computed_numbers(asked, solved_.model, contact, resources_);
        if (!contact.layer.is_none())
          add_layer(contact.layer, all);
        return all;
      };
      out.lower.numbers = numbers_of(changed.lower_case, changed.lower);
      out.upper.numbers = numbers_of(changed.upper_case, changed.upper);
    }
    return out;
  };
  ContactProblem problem = solved_.contact.problem;
  problem.numbers = std::move(numbers);
  std::vector<Tangent> found;
  {
    const LayerInNumbers with_layer(solved_.contact.layer, problem.numbers);
    found = tangents(problem, solved_.result, static_cast<int>(inputs_.size()), input,
                     {.tolerance = asked_.scene.solver.tolerance, .workspace = resources_.operators},
                     resources_.work);
  }
  numbers = std::move(problem.numbers);
  std::vector<InputDerivatives> out;
  for (std::size_t k = 0; k < found.size(); ++k) {
    ChangedContact& side = sides[k];
    out.push_back(difference(
        inputs_[k], found[k],
        side_of(side.lower_case.setup, std::move(side.lower.problem), std::move(found[k].lower)),
        side_of(side.upper_case.setup, std::move(side.upper.problem), std::move(found[k].upper)), side.step));
  }
  return out;
}

[[noreturn]] void refuse(const std::string& why, const std::string& what_to_do) {
  throw InputError("This scene has no derivatives", why, what_to_do);
}

} // namespace

ChangedContact changed_contact(const ContactCase& asked, const ContactOnGrid& contact, int which) {
  SceneFile scene = asked.scene;
  const SceneNumber number = derivative_inputs(scene)[std::size_t(which)];
  const double at = *number.value, below = at - number.step, above = at + number.step;
  const auto set_up = [&](double value) {
    *number.value = value;
    ContactCase out = asked;
    out.scene = scene;
    out.setup = changed_setup(asked, scene, number.reach);
    return out;
  };
  ChangedContact out{set_up(below), set_up(above), {}, {}, 0.5 * (above - below)};
  out.lower = contact_of(out.lower_case.setup, contact, number.reach);
  out.upper = contact_of(out.upper_case.setup, contact, number.reach);
  return out;
}

void require_derivatives(const SceneFile& scene) {
  if (scene.derivatives.empty())
    return;
  SceneFile looked_at = scene;
  if (derivative_inputs(looked_at).empty())
    refuse("derivatives name nothing that it gives", "Name a number that it gives, as load.");
  if (scene.motion.kind != MotionKind::steady && !scene.motion.frictionless)
    refuse("a history has none: they would be those of every step before",
           "Choose motion.kind = \"steady\", or leave out derivatives.");
  if (scene.motion.from_free_rolling)
    refuse("motion.from_free_rolling counts xi from another solution",
           "Count xi from motion.rolling_radius, or leave out derivatives.");
  if (scene.load.force_y)
    refuse("position.lateral is found for load.force_y",
           "Give the position.lateral that was found, and leave out load.force_y.");
  if (scene.layer.slope)
    refuse("the layer is found for layer.slope",
           "Give the layer.compliance that was found (layer_compliance of the result).");
  if (scene.rail.has_sections())
    refuse("the rail changes along the track, and its results are turned into the track's frame",
           "Leave out derivatives, or give one section of the rail.");
  if (is_placed_by_contact(scene))
    refuse("solver.contact_motion = \"placed\" moves the bodies with the solution",
           "Choose solver.contact_motion = \"linear\", or leave out derivatives.");
  if (scene.solver.model && is_closed_form(*scene.solver.model))
    refuse(fmt::format("the model {} is a closed form", name_of(scene.solver.model)),
           "Choose solver.model = \"halfspace\", or leave out derivatives.");
}

std::vector<InputDerivatives> derivatives_of(const ContactCase& asked, GridSolution& solved,
                                             const SolveResources& resources) {
  if (is_closed_form(solved.model))
    refuse(fmt::format("the model {} is a closed form, and was chosen", name_of(solved.model)),
           "Choose solver.model = \"halfspace\", or leave out derivatives.");
  if (const WheelRailGeometry* placed = asked.setup.wheel_rail(); placed && placed->structure)
    refuse("structural motion has moved the bodies with the solution",
           "Choose solver.structural_motion = \"linear\", or leave out derivatives.");
  NumbersOfGrid pair(asked, solved.model, solved.contact, resources);
  InfluenceNumbers numbers = pair.take(solved.numbers);
  std::vector<InputDerivatives> out = DerivativesOfGrid(asked, solved, resources).with(numbers);
  pair.keep(std::move(numbers), solved.numbers);
  return out;
}

} // namespace bem_contact
