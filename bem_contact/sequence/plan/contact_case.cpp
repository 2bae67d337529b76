#include "bem_contact/sequence/plan/contact_case.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/influence/requirements.hpp"
#include "bem_contact/sequence/models.hpp"
#include "bem_contact/sequence/plan/model_choice.hpp"
#include "bem_contact/sequence/plan/plan_grid.hpp"
#include "bem_contact/sequence/plan/settings.hpp"

#include <cmath>
#include <fmt/format.h>

namespace bem_contact {

namespace {

/// 1. Share of the wheel radius by which that of an influence file may differ.
constexpr double radius_tolerance = 0.01;

void require_radius(const InfluenceStrip& wheel, double wheel_radius) {
  if (wheel.invariance == Invariance::revolution &&
      std::abs(wheel.reference_radius - wheel_radius) > radius_tolerance * wheel_radius)
    throw InputError(fmt::format("The influence functions of '{}' do not belong to this wheel", wheel.body),
                     fmt::format("they are for a nominal radius of {:g} mm, position.wheel_radius is {:g} mm",
                                 wheel.reference_radius, wheel_radius),
                     "Compute influence functions of this wheel, or correct the radius.");
}

/// Throws InputError where the influence files are of other bodies than those that are placed.
void require_bodies(const PairFiles& files, const WheelOnRail& pair, bool own_shape) {
  if (files.rail && own_shape)
    require_profile(files.rail->strip(), pair.rail.name(), pair.rail.digest());
  if (files.wheel && own_shape)
    require_profile(files.wheel->strip(), pair.wheel.name(), pair.wheel.digest());
  if (files.wheel)
    require_radius(files.wheel->strip(), pair.wheel_radius);
}

/// Throws InputError where more elements are asked for than the model serves.
void require_elements(const SceneFile& scene) {
  const std::optional<Model> model = scene.solver.model;
  if (depends_on_both_rows(model) && scene.grid.elements.value_or(0) > most_elements_full)
    throw InputError(
        fmt::format("grid.elements = {} is too large for the model {}", *scene.grid.elements, name_of(model)),
        fmt::format("at most {} elements in contact are allowed, since its influence numbers {} on "
                    "both rows",
                    int(most_elements_full), model ? "depend" : "may depend"),
        "Give fewer elements, or solver.model = \"halfspace\".");
}

/// The size of elements that are chosen must be one that the influence files of the chosen model have
/// numbers for.
bool foresees_fem(const ContactCase& asked) {
  const SceneFile& scene = asked.scene;
  return !scene.solver.model && asked.estimate && (scene.grid.elements || scene.grid.accuracy) &&
         choose_model(traits_of(asked, *asked.estimate), request_of(asked)).model == model_of_files();
}

/// Files cannot leave these lists empty; a program can.
void require_quantities(const char* key, std::size_t named) {
  if (named == 0)
    throw InputError(fmt::format("{} is empty", key), "an accuracy is of something",
                     "Name one quantity or more, for instance forces.");
}

} // namespace

ContactCase prepare_case(const SceneFile& scene, SequenceFiles& files, PrepareOptions options) {
  require_quantities("grid.accuracy_of", scene.grid.accuracy_of.size());
  require_quantities("solver.model_tolerance_of", scene.solver.model_tolerance_of.size());
  if (scene.wheelset.force)
    throw InputError("This scene is one of both wheels of a wheelset", "wheelset.force is given",
                     "Solve it with bem_contact wheelset (Python: wheelset), or give load.force instead.");
  require_elements(scene);
  const bool patch = scene.kind == SceneKind::patch;
  ContactCase out{scene,
                  patch ? set_up_patch(scene) : set_up_contact(scene, files.profiles(scene)),
                  {},
                  nullptr,
                  options.own_shape,
                  options.lateral_force};
  if (!patch)
    out.estimate =
        std::make_shared<const ContactEstimate>(estimate_contact(out.setup, options.foresee_shear));
  if (options.read_influence || (scene.solver.model && has_files(*scene.solver.model)) || foresees_fem(out))
    return with_influence(std::move(out), files);
  return out;
}

ContactCase with_influence(ContactCase asked, SequenceFiles& files) {
  if (asked.files.rail || asked.files.wheel) // read and checked before
    return asked;
  asked.files = files.influence(asked.setup.rail, asked.setup.wheel);
  if (const WheelRailGeometry* placed = asked.setup.wheel_rail())
    require_bodies(asked.files, placed->pair, asked.own_shape);
  return asked;
}

std::pair<int, int> rows_on_strips(const ContactCase& contact, const GridPlan& plan) {
  const RowsOnBodies rows = contact.setup.rows_on(plan);
  return covered_rows(contact.files, plan.ds, rows.rail_s, rows.wheel_s);
}

void require_strips(const ContactCase& contact, const GridPlan& plan) {
  const RowsOnBodies rows = contact.setup.rows_on(plan);
  require_strips(contact.files, plan.ds, rows.rail_s, rows.wheel_s);
}

GridPlan first_plan(const ContactCase& contact, const SceneFile::Grid& asked, bool on_strips) {
  GridPlan plan;
  if (const PatchGeometry* patch = contact.setup.patch()) {
    plan = patch->plan();
  } else {
    const auto& rail = contact.files.rail;
    plan = plan_grid(*contact.estimate, asked, rail ? rail->strip().stations.front().s : 0.5 * asked.ds);
    // The estimate is generous: give up rows off the strips, as long as the contact does not need them.
    if (on_strips && !asked.rows && !asked.ms) {
      const auto [first, last] = rows_on_strips(contact, plan);
      const double deepest_s = contact.setup.wheel_rail()->touch.front().rail_s;
      const int deepest = static_cast<int>(std::lround((deepest_s - plan.s(0)) / plan.ds));
      if (first <= deepest && deepest <= last) {
        plan.first += first;
        plan.rows = last - first + 1;
      }
    }
  }
  if (on_strips)
    require_strips(contact, plan);
  return plan;
}

} // namespace bem_contact
