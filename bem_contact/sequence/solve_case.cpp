#include "bem_contact/sequence/solve_case.hpp"

#include "bem_contact/base/stopwatch.hpp"
#include "bem_contact/sequence/grow_grid.hpp"
#include "bem_contact/sequence/hertz_model.hpp"
#include "bem_contact/sequence/record.hpp"
#include "bem_contact/sequence/structural_motion.hpp"

namespace bem_contact {

namespace {

/// The contact on its first grid, with the seconds that this took.
struct FirstContact {
  ContactOnGrid contact;
  double seconds = 0;
};
FirstContact first_contact(const ContactCase& asked, const SceneFile::Grid& grid, bool on_strips) {
  const Stopwatch clock;
  ContactOnGrid contact = asked.setup.on(first_plan(asked, grid, on_strips));
  return {std::move(contact), clock.seconds()};
}

/// The cheapest model that serves, and the contact on the grid that the look at it ended with.
struct ChosenModel {
  ModelChoice choice;
  ContactOnGrid contact;
  PhaseSeconds seconds;
};
ChosenModel choose(const ContactCase& asked, ContactOnGrid contact, const SolveResources& resources) {
  const double tolerance = asked.scene.solver.model_tolerance;
  if (const auto hertz = hertz_of(asked.setup, contact.problem)) {
    ModelChoice choice = choose_hertz(*hertz, tolerance);
    if (choice.enough)
      return {std::move(choice), std::move(contact), {}};
  }
  GridSolution normal =
      solve_on_growing_grid(asked, std::move(contact), {Model::halfspace, true}, resources, false);
  const bool equal = asked.setup.rail.material == asked.setup.wheel.material;
  ModelChoice choice =
      choose_model(normal.contact.problem, normal.result, equal, asked.files.complete(), tolerance);
  return {std::move(choice), std::move(normal.contact), normal.seconds};
}

SceneResult solved_with(const ContactCase& asked, const SceneFile::Grid& grid, ContactOnGrid contact,
                        const ModelChoice& choice, const SolveResources& resources) {
  PlacedSolution placed = solve_on_placed_bodies(asked, grid, std::move(contact), {choice.model}, resources);
  SceneResult out = record_of(placed.asked, std::move(placed.solved), choice);
  out.structure = std::move(placed.structure);
  return out;
}

} // namespace

SceneResult solve_case(const ContactCase& asked, const SceneFile::Grid& grid,
                       const SolveResources& resources) {
  const Stopwatch clock;
  const std::optional<Model> model = asked.scene.solver.model;
  FirstContact first = first_contact(asked, grid, model == Model::fem);
  PhaseSeconds before{.geometry = first.seconds};
  ModelChoice choice{model.value_or(Model::halfspace), "asked for"};
  if (!model) {
    ChosenModel chosen = choose(asked, std::move(first.contact), resources);
    before += chosen.seconds;
    choice = std::move(chosen.choice);
    first.contact = std::move(chosen.contact);
    if (choice.model == Model::fem) {
      first = first_contact(asked, grid, true);
      before.geometry += first.seconds;
    }
  }
  SceneResult out = solved_with(asked, grid, std::move(first.contact), choice, resources);
  out.seconds += before;
  out.seconds.total = clock.seconds();
  return out;
}

} // namespace bem_contact
