#include "bem_contact/sequence/solution/derivatives_of.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/scene/derivative_inputs.hpp"
#include "bem_contact/sequence/models.hpp"
#include "bem_contact/sequence/quantities.hpp"
#include "bem_contact/sequence/solution/numbers_of_grid.hpp"
#include "bem_contact/sequence/solution/profile_changes.hpp"
#include "bem_contact/sequence/solution/structural_motion.hpp"

#include <fmt/format.h>

#include <utility>

namespace bem_contact {

namespace {

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

/// A point of a profile, as a number.
SceneNumber number_of_point() {
  return {"point", "profile", "mm", nullptr, InputReach::bodies, 0};
}

/// The tangents of one solution, from input to input: numbers of the scene, then points of profiles.
class DerivativesOfGrid {
public:
  DerivativesOfGrid(const ContactCase& asked, const GridSolution& solved, const SolveResources& resources)
      : asked_(asked), solved_(solved), resources_(resources), scene_(asked.scene),
        inputs_(derivative_inputs(scene_)), numbers_(inputs_.size()), profiles_(asked, solved) {
    inputs_.resize(numbers_ + profiles_.size(), number_of_point());
  }

  ResultDerivatives with(InfluenceNumbers& numbers);

private:
  ChangedContact changed(std::size_t k) const {
    return k < numbers_ ? changed_contact(asked_, solved_.contact, int(k)) : profiles_.changed(k - numbers_);
  }
  ResultDerivatives sorted(std::vector<InputDerivatives> all) const {
    std::vector<InputDerivatives> by_point;
    for (std::size_t k = numbers_; k < all.size(); ++k)
      by_point.push_back(std::move(all[k]));
    all.resize(numbers_);
    return {std::move(all), profiles_.sorted(std::move(by_point))};
  }

  const ContactCase& asked_;
  const GridSolution& solved_;
  const SolveResources& resources_;
  SceneFile scene_;
  std::vector<SceneNumber> inputs_;
  std::size_t numbers_; ///< of these
  ProfileChanges profiles_;
};

ResultDerivatives DerivativesOfGrid::with(InfluenceNumbers& numbers) {
  std::vector<ChangedContact> sides;
  const auto input = [&](int k) -> TangentInput {
    ChangedContact& changed = sides.emplace_back(this->changed(std::size_t(k)));
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
  return sorted(std::move(out));
}

[[noreturn]] void refuse(const std::string& why, const std::string& what_to_do) {
  throw InputError("This scene has no derivatives", why, what_to_do);
}

} // namespace

void require_derivatives(const SceneFile& scene) {
  if (scene.derivatives.empty())
    return;
  SceneFile looked_at = scene;
  const std::vector<std::string> profiles = profile_inputs(scene);
  if (derivative_inputs(looked_at).empty() && profiles.empty())
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
  if (scene.wheel.has_sections())
    refuse("the wheel changes round its circumference, and its results are turned into the track's frame",
           "Leave out derivatives, or give one section of the wheel.");
  if (is_placed_by_contact(scene))
    refuse("solver.contact_motion = \"placed\" moves the bodies with the solution",
           "Choose solver.contact_motion = \"linear\", or leave out derivatives.");
  if (scene.solver.model && has_files(*scene.solver.model) && !profiles.empty())
    refuse("influence files are of the profiles as they are", "Choose solver.model = \"halfspace\".");
  if (scene.solver.model && is_closed_form(*scene.solver.model))
    refuse(fmt::format("the model {} is a closed form", name_of(scene.solver.model)),
           "Choose solver.model = \"halfspace\", or leave out derivatives.");
}

ResultDerivatives derivatives_of(const ContactCase& asked, GridSolution& solved,
                                 const SolveResources& resources) {
  if (has_files(solved.model) && !profile_inputs(asked.scene).empty())
    refuse(
        "influence files are of the profiles as they are",
        "Choose solver.model = \"halfspace\" or \"tangent_plane\" for derivatives with respect to profiles.");
  if (is_closed_form(solved.model))
    refuse(fmt::format("the model {} is a closed form, and was chosen", name_of(solved.model)),
           "Choose solver.model = \"halfspace\", or leave out derivatives.");
  if (const WheelRailGeometry* placed = asked.setup.wheel_rail(); placed && placed->structure)
    refuse("structural motion has moved the bodies with the solution",
           "Choose solver.structural_motion = \"linear\", or leave out derivatives.");
  NumbersOfGrid pair(asked, solved.model, solved.contact, resources);
  InfluenceNumbers numbers = pair.take(solved.numbers);
  ResultDerivatives out = DerivativesOfGrid(asked, solved, resources).with(numbers);
  pair.keep(std::move(numbers), solved.numbers);
  return out;
}

} // namespace bem_contact
