#include "bem_contact/sequence/solve_case.hpp"

#include "bem_contact/base/stopwatch.hpp"
#include "bem_contact/scene/contact_centre.hpp"
#include "bem_contact/sequence/grow_grid.hpp"
#include "bem_contact/sequence/hertz_model.hpp"
#include "bem_contact/sequence/record.hpp"
#include "bem_contact/sequence/structural_motion.hpp"

namespace bem_contact {

namespace {

/// A case with the influence files that its model needs, on its first grid.
struct FirstContact {
  ContactCase asked;
  ContactOnGrid contact;
};
FirstContact first_contact(const ContactCase& asked, Model model, const SceneFile::Grid& grid,
                           const SolveResources& resources) {
  const bool on_strips = model == Model::fem;
  ContactCase known = on_strips && resources.files ? with_influence(asked, *resources.files) : asked;
  ContactOnGrid contact = known.setup.on(first_plan(known, grid, on_strips));
  return {std::move(known), std::move(contact)};
}

/// By the estimate; in plane strain, which has none, by the normal problem with half-space numbers.
ContactTraits foreseen_traits(const ContactCase& asked, const ContactOnGrid& contact,
                              const SolveResources& resources) {
  const double compliance = contact_compliance(asked.setup.rail.material, asked.setup.wheel.material);
  if (const auto estimate = asked.estimate ? asked.estimate : estimate_contact(contact.problem, compliance))
    return traits_of(asked, *estimate);
  const GridSolution normal =
      solve_on_growing_grid(asked, contact, {Model::halfspace, true}, resources, false);
  return traits_of(asked, {}, normal.contact.problem, normal.result);
}

ModelChoice choose(const ContactCase& asked, const ContactOnGrid& contact, const ContactTraits& traits) {
  const ModelRequest request = request_of(asked);
  if (const auto hertz = hertz_of(asked.setup, contact.problem))
    if (ModelChoice choice = choose_hertz(*hertz, traits, request); choice.enough)
      return choice;
  return choose_model(traits, request);
}

/// What the solution itself says of the choice: a costlier model, or the same with what is known now.
ModelChoice checked(const ContactCase& asked, ModelChoice taken, const ContactTraits& foreseen,
                    const GridSolution& solved) {
  if (taken.model == Model::hertz || taken.model == Model::fem || !solved.result.converged ||
      solved.result.patches.empty())
    return taken;
  ModelChoice known =
      choose_model(traits_of(asked, foreseen, solved.contact.problem, solved.result), request_of(asked));
  return known.model < taken.model ? taken : known;
}

SceneResult recorded(PlacedSolution placed, const ModelChoice& choice) {
  SceneResult out = record_of(placed.asked, std::move(placed.solved), choice);
  out.structure = std::move(placed.structure);
  return out;
}

SceneResult solve_by_choice(const ContactCase& asked, const SceneFile::Grid& grid,
                            const SolveResources& resources) {
  const Stopwatch looking;
  FirstContact first = first_contact(asked, Model::halfspace, grid, resources);
  const ContactTraits foreseen = foreseen_traits(asked, first.contact, resources);
  ModelChoice choice = choose(asked, first.contact, foreseen);
  PhaseSeconds spent{.geometry = looking.seconds()};
  for (;;) {
    if (choice.model == Model::fem) {
      const Stopwatch reading;
      first = first_contact(asked, Model::fem, grid, resources);
      spent.geometry += reading.seconds();
    }
    PlacedSolution placed =
        solve_on_placed_bodies(first.asked, grid, first.contact, {choice.model}, resources);
    spent += placed.solved.seconds;
    const Model taken = choice.model;
    choice = checked(asked, std::move(choice), foreseen, placed.solved);
    if (choice.model == taken) {
      placed.solved.seconds = spent;
      return recorded(std::move(placed), choice);
    }
  }
}

SceneResult solve_as_asked(const ContactCase& asked, Model model, const SceneFile::Grid& grid,
                           const SolveResources& resources) {
  const Stopwatch looking;
  FirstContact first = first_contact(asked, model, grid, resources);
  const double geometry = looking.seconds();
  PlacedSolution placed =
      solve_on_placed_bodies(first.asked, grid, std::move(first.contact), {model}, resources);
  placed.solved.seconds.geometry += geometry;
  return recorded(std::move(placed), {model, "asked for"});
}

} // namespace

SceneResult solve_case(const ContactCase& asked, const SceneFile::Grid& grid,
                       const SolveResources& resources) {
  const Stopwatch clock;
  const std::optional<Model> model = asked.scene.solver.model;
  SceneResult out =
      model ? solve_as_asked(asked, *model, grid, resources) : solve_by_choice(asked, grid, resources);
  out.seconds.total = clock.seconds();
  return out;
}

} // namespace bem_contact
