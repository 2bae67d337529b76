#include "bem_contact/sequence/scene_stage.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/influence/requirements.hpp"
#include "bem_contact/scene/elastic_limit.hpp"

#include <cmath>
#include <fmt/format.h>

namespace bem_contact {

namespace {

constexpr double radius_tolerance = 0.01; // of the wheel radius that an influence file was made for

void require_radius(const InfluenceFunction& wheel, double wheel_radius) {
  if (wheel.invariance == Invariance::revolution &&
      std::abs(wheel.reference_radius - wheel_radius) > radius_tolerance * wheel_radius)
    throw InputError(fmt::format("The influence functions of '{}' do not belong to this wheel", wheel.body),
                     fmt::format("they are for a nominal radius of {:g} mm, position.wheel_radius is {:g} mm",
                                 wheel.reference_radius, wheel_radius),
                     "Compute influence functions of this wheel, or correct the radius.");
}
} // namespace

Stage prepare_stage(const SceneFile& scene, bool needs_strips, const SceneAids& aids) {
  const Stopwatch watch;
  Stage stage{&scene, {}, {}, {}, {}, needs_strips, aids, false};
  if (scene.kind == SceneKind::wheel_rail) {
    stage.wheel_rail = aids.placed ? *aids.placed : place_wheel_rail(scene);
    stage.files = aids.files ? *aids.files : read_pair_files(scene);
    if (stage.files.rail)
      require_profile(*stage.files.rail, stage.wheel_rail->pair.rail.name(),
                      stage.wheel_rail->pair.rail.digest());
    if (stage.files.wheel)
      require_profile(*stage.files.wheel, stage.wheel_rail->pair.wheel.name(),
                      stage.wheel_rail->pair.wheel.digest());
    if (stage.files.wheel)
      require_radius(*stage.files.wheel, scene.position.wheel_radius);
    stage.wheel_rail->plan = plan_wheel_rail(*stage.wheel_rail, scene, stage.files);
    stage.contact = prepare_wheel_rail(*stage.wheel_rail, scene);
    // The estimate is generous: give up rows off the strips, as long as the contact does not need them.
    if (needs_strips && !scene.grid.rows && !scene.grid.ms) {
      const auto [first, last] = covered_rows(stage.files, stage.contact);
      GridPlan& plan = stage.wheel_rail->plan;
      const int deepest =
          static_cast<int>(std::lround((stage.wheel_rail->touch.front().rail_s - plan.s(0)) / plan.ds));
      if (first <= deepest && deepest <= last && (first > 0 || last + 1 < plan.rows)) {
        plan.first += first;
        plan.rows = last - first + 1;
        stage.contact = prepare_wheel_rail(*stage.wheel_rail, scene);
      }
    }
  } else {
    stage.files = read_pair_files(scene);
    stage.contact = prepare_patch(scene);
  }
  if (needs_strips)
    require_strips(stage.files, stage.contact);
  ContactProblem& problem = stage.contact.problem;
  problem.load = scene.load.force ? LoadKind::force : LoadKind::approach;
  problem.approach = scene.load.force   ? 0.0
                     : stage.wheel_rail ? stage.wheel_rail->approach
                                        : scene.load.approach.value_or(0);
  problem.force = scene.load.force.value_or(0);
  if (!stage.wheel_rail)
    require_bearable(scene, problem);
  stage.seconds.geometry = watch.seconds();
  return stage;
}

void take_load(ContactProblem& problem, const ContactProblem& from) {
  problem.load = from.load;
  problem.approach = from.approach;
  problem.force = from.force;
}

} // namespace bem_contact
