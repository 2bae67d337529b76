#include "bem_contact/sequence/solve_scene.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/scene/doubts.hpp"
#include "bem_contact/scene/elastic_limit.hpp"
#include "bem_contact/sequence/scene_growth.hpp"
#include "bem_contact/sequence/scene_solve.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <iterator>
#include <tuple>

namespace bem_contact {

namespace {

constexpr double poor_discretisation = 0.2; // relative error that deserves a warning
constexpr int few_elements = 40;            // in contact

/// Of all steps, as far as they are solutions, MPa.
double highest_pressure(const SceneResult& out) {
  double highest = 0;
  const auto look = [&](const ContactResult& result) {
    if (result.converged)
      highest = std::max(highest, largest_pressure(result));
  };
  look(out.result);
  std::ranges::for_each(out.history, look);
  return highest;
}

void finish(SceneResult& out, const Stage& stage) {
  require_elastic(*stage.scene, highest_pressure(out));
  std::ranges::move(doubts(*stage.scene, stage.wheel_rail ? &*stage.wheel_rail : nullptr),
                    std::back_inserter(out.warnings));
  out.left = stage.scene->position.side == WheelSide::left;
  out.reference = stage.reference();
  out.moment = out.result.Mz + out.reference.position.y * out.result.Fx - out.reference.x * out.result.Fy;
  if (stage.wheel_rail || stage.files.complete())
    out.wheel_s = stage.contact.wheel_s;
  if (stage.wheel_rail) {
    const ContactProblem& problem = out.problem;
    std::tie(out.rail_profile, out.wheel_profile) =
        profiles_near(*stage.wheel_rail, problem.rows.front().s, problem.rows.back().s);
  } else {
    for (const ContactRow& row : out.problem.rows) {
      const double gap =
          out.problem.gap[(&row - out.problem.rows.data()) * out.problem.grid.mx + out.problem.grid.mx / 2];
      out.rail_profile.push_back(row.position);
      if (gap < excluded_gap)
        out.wheel_profile.push_back(row.position - gap * normal_of(row.delta));
    }
  }
  out.seconds.geometry = stage.seconds.geometry;
  const double error = out.result.certificate.discretisation;
  const auto exterior = std::ranges::count(out.result.state, ElementState::exterior);
  const auto contact = static_cast<std::ptrdiff_t>(out.result.state.size()) - exterior;
  if (error > poor_discretisation)
    out.warnings.push_back(fmt::format(
        "the elements are too large for this contact: the estimated discretisation error is {:.0f} %",
        100 * error));
  else if (contact > 0 && contact < few_elements && error < 0 && !out.result.touches_border)
    out.warnings.push_back(fmt::format(
        "the elements are too large for this contact: {} of them touch, and no error can be estimated",
        contact));
}

/// Hertz where he serves; else by a look at the normal problem with half-space numbers.
ModelChoice choose(Stage& stage, PhaseSeconds& spent) {
  const double tolerance = stage.scene->solver.model_tolerance;
  if (const auto hertz = hertz_of(stage)) {
    ModelChoice choice = choose_hertz(*hertz, tolerance);
    if (choice.enough)
      return choice;
  }
  const SceneResult normal = solve_grown(stage, Model::halfspace, false);
  spent = normal.seconds;
  const bool equal = stage.scene->rail.material == stage.scene->wheel.material;
  return choose_model(normal.problem, normal.result, equal, stage.files.complete(), tolerance);
}

void add_stresses(SceneResult& out, const SceneFile& scene) {
  if (scene.stresses.depths.empty() || !out.result.converged)
    return;
  out.stresses = stresses_below(scene.stresses, out.problem, out.result, scene.grid.plane_strain,
                                scene.rail.material.poisson, out.reference.s);
  const double turn = turn_of_contact(out.problem, out.result);
  if (predicted_halfspace_error(turn) > scene.solver.model_tolerance)
    out.warnings.push_back(fmt::format("the stresses below the surface are those of a half-space under these "
                                       "tractions: an approximation here, for {}",
                                       halfspace_text(turn)));
}

} // namespace

SceneResult solve_scene(const SceneFile& scene) {
  return solve_scene(scene, SceneAids{});
}

SceneResult solve_scene(const SceneFile& scene, const SceneAids& given) {
  WorkBudget work;
  SceneAids aids = given;
  if (!aids.work)
    aids.work = &work;
  const Stopwatch watch;
  const std::optional<Model> asked = scene.solver.model;
  Stage stage = prepare_stage(scene, asked == Model::fem, aids);
  SceneResult out;
  PhaseSeconds probe;
  ModelChoice choice{asked.value_or(Model::halfspace), "asked for"};
  if (!asked) {
    choice = choose(stage, probe);
    if (choice.model == Model::fem)
      stage = prepare_stage(scene, true, aids);
  }
  out = solve_grown(stage, choice.model, true);
  out.reason = choice.reason;
  if (!choice.enough)
    out.warnings.push_back("the finite-element model is needed here: " + out.reason);
  finish(out, stage);
  add_stresses(out, scene);
  out.seconds.numbers += probe.numbers;
  out.seconds.solve += probe.solve;
  out.seconds.total = watch.seconds();
  return out;
}

Comparison compare_scene(const SceneFile& scene) {
  const Stopwatch watch;
  if (!scene.load.force && scene.motion.kind != MotionKind::steady)
    throw InputError("The models cannot be compared over these steps", "only the approach is given",
                     "Give load.force, at which they are compared, or solve the scene with either model.");
  Stage stage = prepare_stage(scene, true);
  Comparison out;
  const ContactProblem asked = stage.contact.problem;
  for (int round = 0;; ++round) {
    // Both on one grid: where either grows, both are solved again.
    out.fem = solve_grown(stage, Model::fem, true);
    const int size = stage.contact.problem.grid.size();
    ContactProblem& problem = stage.contact.problem;
    if (asked.load == LoadKind::approach) {
      problem.load = LoadKind::force;
      problem.force = out.fem.result.Fz;
    }
    out.halfspace = solve_grown(stage, Model::halfspace, true);
    if (stage.contact.problem.grid.size() == size)
      break;
    stage.contact.problem.load = asked.load;
    stage.contact.problem.force = asked.force;
    if (round == most_growths)
      throw ConvergenceError("The two models found no common grid", "each needs another potential contact",
                             "Give grid.s_from and grid.s_to.");
  }
  finish(out.fem, stage);
  finish(out.halfspace, stage);
  add_stresses(out.fem, scene);
  add_stresses(out.halfspace, scene);
  out.fem.reason = out.halfspace.reason = "compared at equal vertical force";
  out.fem.seconds.total = out.halfspace.seconds.total = watch.seconds();
  return out;
}

} // namespace bem_contact
