#include "bem_contact/sequence/comparison.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/sequence/models.hpp"
#include "bem_contact/sequence/result_warnings.hpp"
#include "bem_contact/sequence/settings.hpp"

#include <algorithm>
#include <cmath>

namespace bem_contact {

namespace {

/// 1. A model whose lateral force at the reference's position is as near to the reference's as this, over the
/// resultant of Fy and Fz, is compared there. On a tread Fy hardly depends on the position: on a rail
/// inclined 1:40 the half-space's is within 0.0003. The place where it is exactly the same lies 0.28 mm off,
/// where pmax is 12 % off.
constexpr double same_lateral_force = 0.005;

void require_comparable(const SceneFile& scene, const std::vector<Model>& models) {
  std::vector<Model> sorted = models;
  std::ranges::sort(sorted);
  if (models.size() < 2 || std::ranges::adjacent_find(sorted) != sorted.end())
    throw InputError("These models cannot be compared", "a comparison needs two different models or more",
                     "Name them, for instance halfspace and fem.");
  if (!scene.load.force && scene.motion.kind != MotionKind::steady)
    throw InputError("The models cannot be compared over these steps", "only the approach is given",
                     "Give load.force, at which they are compared, or solve the scene with either model.");
}

/// What all models have to meet: the size of the elements, Fz and the place. What the scene leaves open is
/// taken from the reference's answer.
SceneFile same_for_all(const SceneFile& scene, Model reference, const SceneSolver& solve) {
  const bool all_given =
      !scene.grid.elements && !scene.grid.accuracy && scene.load.force && !scene.load.force_y;
  if (all_given)
    return scene;
  const SceneResult first = solve(with_model(scene, reference));
  SceneFile asked = with_elements(scene, first.problem.grid.dx, first.problem.grid.ds);
  asked = with_lateral(std::move(asked), first.motion.lateral.value_or(scene.position.lateral));
  asked.load.force = first.result.totals.Fz;
  asked.load.approach.reset();
  asked.position.vertical.reset();
  return asked;
}

std::vector<SceneResult> solve_each(const SceneFile& asked, const std::vector<Model>& models,
                                    const SceneFile::Grid& wanted, const SceneSolver& solve) {
  std::vector<SceneResult> out;
  for (const Model model : models) {
    out.push_back(solve(with_model(asked, model)));
    warn_of_accuracy(wanted, "all models have the elements of the reference", out.back());
  }
  return out;
}

/// The model of `equal` where it bears the lateral force: `given`, or else that of `there`, whose position is
/// kept where it has that force nearly.
SceneResult solve_at_force(SceneFile equal, std::optional<double> given, const SceneResult& there,
                           const SceneSolver& solve) {
  const double wanted = there.result.totals.Fy;
  if (!given) {
    SceneResult here = solve(equal);
    if (std::abs(here.result.totals.Fy - wanted) <=
        same_lateral_force * std::hypot(wanted, there.result.totals.Fz))
      return here;
  }
  equal.load.force_y = given.value_or(wanted);
  return solve(equal);
}

/// `equal`: without load.force_y.
CreepForces creep_forces(const SceneFile& equal, const std::vector<SceneResult>& at_forces,
                         const BeyondSolver& solve_beyond) {
  const std::vector<std::vector<double>> each(at_forces.size());
  CreepForces out{{compared_creepages.begin(), compared_creepages.end()}, each, each};
  for (const double creepage : compared_creepages)
    for (std::size_t m = 0; m < at_forces.size(); ++m) {
      const SceneResult& free = at_forces[m];
      const SceneResult beyond =
          solve_beyond(with_model(with_lateral(equal, *free.motion.lateral), free.choice.model),
                       *free.motion.free_rolling, creepage);
      out.Fx[m].push_back(beyond.result.totals.Fx);
      out.Fx_error[m].push_back(beyond.result.totals.Fx.error);
      out.certified = out.certified && certified(beyond);
    }
  return out;
}

} // namespace

Comparison compare_models(const SceneFile& scene, std::vector<Model> models, const SceneSolver& solve,
                          const BeyondSolver& solve_beyond) {
  require_comparable(scene, models);
  Comparison out;
  const auto real_bodies = std::ranges::find_if(models, has_files);
  out.reference = real_bodies != models.end() ? real_bodies - models.begin() : models.size() - 1;
  out.models = std::move(models);
  const Model reference = out.models[out.reference];

  const SceneFile asked = same_for_all(scene, reference, solve);
  if (scene.kind == SceneKind::patch) {
    out.at_forces = solve_each(asked, out.models, scene.grid, solve);
    return out;
  }
  out.at_position = solve_each(asked, out.models, scene.grid, solve);
  if (scene.motion.kind != MotionKind::steady && !scene.motion.frictionless)
    return out;

  SceneFile equal = asked;
  equal.motion.from_free_rolling = false;
  if (!scene.motion.frictionless)
    equal.load.force_x = scene.load.force_x.value_or(0);
  const bool the_same = scene.motion.frictionless || scene.load.force_x;
  const SceneResult& place = out.at_position[out.reference];
  const SceneResult there = the_same ? place : solve(with_model(equal, reference));
  for (const Model model : out.models)
    out.at_forces.push_back(model == reference && !scene.load.force_y
                                ? there
                                : solve_at_force(with_model(equal, model), scene.load.force_y, there, solve));
  const bool free_rolling = std::ranges::all_of(
      out.at_forces, [](const SceneResult& r) { return r.motion.free_rolling.has_value(); });
  if (!the_same && free_rolling)
    out.creep_forces = creep_forces(equal, out.at_forces, solve_beyond);
  return out;
}

bool certified(const Comparison& comparison) {
  const auto all = [](const std::vector<SceneResult>& results) {
    return std::ranges::all_of(results, [](const SceneResult& r) { return certified(r); });
  };
  return all(comparison.at_forces) && all(comparison.at_position) && comparison.creep_forces.certified;
}

} // namespace bem_contact
