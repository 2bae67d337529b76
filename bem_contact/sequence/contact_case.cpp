#include "bem_contact/sequence/contact_case.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/influence/requirements.hpp"
#include "bem_contact/sequence/plan_grid.hpp"

#include <cmath>
#include <fmt/format.h>

namespace bem_contact {

namespace {

void require_radius(const InfluenceFunction& wheel, double wheel_radius) {
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
    require_profile(*files.rail, pair.rail.name(), pair.rail.digest());
  if (files.wheel && own_shape)
    require_profile(*files.wheel, pair.wheel.name(), pair.wheel.digest());
  if (files.wheel)
    require_radius(*files.wheel, pair.wheel_radius);
}

} // namespace

ContactCase prepare_case(const SceneFile& scene, SequenceFiles& files, PrepareOptions options) {
  if (scene.wheelset.force)
    throw InputError("This scene is one of both wheels of a wheelset", "wheelset.force is given",
                     "Solve it with bem_contact wheelset (Python: wheelset), or give load.force instead.");
  if (scene.kind == SceneKind::patch) {
    ContactSetup setup = set_up_patch(scene);
    const PairFiles& read = files.influence(setup.rail, setup.wheel);
    return {scene, std::move(setup), read, std::nullopt};
  }
  ContactSetup setup = set_up_contact(scene, files.profiles(scene));
  ContactEstimate estimate = estimate_contact(setup, options.foresee_shear);
  const PairFiles& read = files.influence(setup.rail, setup.wheel);
  require_bodies(read, setup.wheel_rail()->pair, options.own_shape);
  return {scene, std::move(setup), read, std::move(estimate)};
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
    plan = plan_grid(*contact.estimate, asked, rail ? rail->stations.front().s : 0.5 * asked.ds);
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
