#include "bem_contact/sequence/foreseen_work.hpp"

#include "bem_contact/contact/work.hpp"
#include "bem_contact/sequence/models.hpp"
#include "bem_contact/sequence/numbers/sequence_files.hpp"
#include "bem_contact/sequence/plan/contact_case.hpp"
#include "bem_contact/sequence/plan/element_size.hpp"
#include "bem_contact/sequence/settings.hpp"

#include <algorithm>
#include <utility>

namespace bem_contact {

namespace {

/// The scene of one contact, and how many such solutions the asked one takes.
std::pair<SceneFile, double> one_contact(const SceneFile& scene) {
  if (!scene.wheelset.force)
    return {scene, scene.load.force_y ? solutions_of_lateral_force : 1.0};
  SceneFile wheel = one_wheel(scene, WheelSide::right);
  wheel.load.force = *scene.wheelset.force / 2;
  return {std::move(wheel), solutions_of_wheelset};
}

} // namespace

double foreseen_work(const SceneFile& scene, SequenceFiles& files) {
  const auto [contact, solutions] = one_contact(scene);
  const ContactCase asked = prepare_case(contact, files, {.read_influence = false});
  const std::optional<Model> model = asked.scene.solver.model;
  SceneFile::Grid grid = asked.scene.grid;
  if (asked.estimate) {
    ElementSize size(false);
    size.begin(asked, false);
    grid = size.grid(asked);
  }
  const GridPlan plan = first_plan(asked, grid, model && has_files(*model));
  const double elements = double(plan.columns) * plan.rows,
               product = elements * product_work(!depends_on_both_rows(model), plan.rows),
               steps = std::max<double>(1, double(asked.setup.motion.steps.size()));
  return solutions * std::max(least_work_of_case, products_of_case * product * steps);
}

} // namespace bem_contact
