#include "bem_contact/sequence/scene_solve.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/base/progress.hpp"
#include "bem_contact/scene/motion.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace bem_contact {

namespace {

constexpr double largest_memory = 8.0;   // GB
constexpr std::size_t many_steps = 1000; // from here on progress is said

/// Numbers of both bodies, of the pair, and the operator's spectra: four times one table.
void require_memory(const ContactGrid& grid) {
  const double gigabytes = 4 * 8e-9 * 9 * double(grid.ms) * grid.ms * (grid.mx + 2);
  if (gigabytes > largest_memory)
    throw InputError(fmt::format("A grid of {} x {} elements is too large", grid.mx, grid.ms),
                     fmt::format("its influence numbers need about {:.0f} GB, {:g} GB are allowed", gigabytes,
                                 largest_memory),
                     "Use larger elements or fewer of them, above all along s.");
}

/// The fields of every step are kept: tractions, slip, distance, states.
void require_memory(const ContactGrid& grid, std::size_t steps) {
  const double gigabytes = 1e-9 * (6 * sizeof(double) + 1) * double(grid.size()) * double(steps);
  if (gigabytes > largest_memory)
    throw InputError(
        fmt::format("A history of {} steps on {} x {} elements is too large", steps, grid.mx, grid.ms),
        fmt::format("the fields of all steps need about {:.0f} GB, {:g} GB are allowed", gigabytes,
                    largest_memory),
        "Take fewer steps (rolling is steady after about two lengths of contact), or elements.");
}

InfluenceNumbers compute_numbers(const Stage& stage, Model model) {
  return model == Model::fem             ? fem_pair(*stage.scene, stage.files, stage.contact)
         : model == Model::tangent_plane ? tangent_plane_pair(*stage.scene, stage.contact)
                                         : halfspace_pair(*stage.scene, stage.contact);
}

SceneResult solve_by_hertz(const Stage& stage) {
  const std::optional<HertzModel> model = hertz_of(stage);
  if (!model)
    throw InputError(
        "Hertz's closed form does not fit this contact",
        "it is for a frictionless contact in three dimensions whose undeformed distance is curved "
        "both ways and known all over the contact (on at least 5 x 5 elements)",
        "Set motion.frictionless = true, give a larger grid, or choose another model.");
  SceneResult out;
  out.model = Model::hertz;
  out.problem = stage.contact.problem;
  out.problem.numbers.dx = out.problem.grid.dx; // not plane strain
  out.result = solve_hertz(out.problem, *model, out.displacements);
  return out;
}

InfluenceNumbers numbers_of(const Stage& stage, Model model) {
  NumbersStore* store = stage.wheel_rail && model != Model::tangent_plane ? stage.aids.numbers : nullptr;
  const auto compute = [&] { return compute_numbers(stage, model); };
  if (!store)
    return compute();
  // All that they depend on: half-space numbers on the grid's size alone.
  const ContactGrid& grid = stage.contact.problem.grid;
  const SceneFile& scene = *stage.scene;
  std::string key = fmt::format("{} {} {} {} {}", name_of(model), grid.mx, grid.ms, grid.dx, grid.ds);
  for (const SceneFile::Side* side : {&scene.rail, &scene.wheel})
    key += fmt::format(" {} {} {} {}", side->material.shear_modulus, side->material.poisson, side->influence,
                       name_of(side->structural));
  if (model == Model::fem)
    key += fmt::format(" {} {} {}", fmt::join(stage.contact.rail_s, " "),
                       fmt::join(stage.contact.wheel_s, " "), stage.contact.contact_radius);
  return store->get(key, compute);
}

} // namespace

std::optional<HertzModel> hertz_of(const Stage& stage) {
  const ContactProblem& problem = stage.contact.problem;
  if (problem.tangential || stage.contact.plane_strain)
    return std::nullopt;
  return fit_hertz(problem, stage.scene->rail.material, stage.scene->wheel.material);
}

SceneResult solve_once(Stage& stage, Model model, bool tangential) {
  if (model == Model::hertz)
    return solve_by_hertz(stage);
  SceneResult out;
  out.model = model;
  ContactProblem& problem = stage.contact.problem;
  require_memory(problem.grid);
  const Stopwatch numbers;
  problem.numbers = numbers_of(stage, model);
  out.seconds.numbers = numbers.seconds();
  const Stopwatch solving;
  std::optional<StartingPoint> start;
  if (stage.wheel_rail && stage.aids.start)
    start =
        start_from(*stage.aids.start, problem, potential_areas(stage.wheel_rail->estimate), problem.force);
  const bool steady = !problem.tangential || problem.motion == MotionKind::steady;
  const SolverOptions options{.tolerance = stage.scene->solver.tolerance,
                              .max_outer = stage.scene->solver.max_outer,
                              .estimate_discretisation = tangential,
                              .coarse_start = stage.aids.coarse_start,
                              .start = start ? &*start : nullptr,
                              .work =
                                  steady ? stage.aids.work : nullptr, // each step of a history has its own
                              .workspace = stage.aids.workspace};
  if (!tangential) {
    ContactProblem normal = problem;
    normal.tangential = false;
    out.result = solve(normal, options);
  } else if (steady) {
    out.result = solve(problem, options);
    out.displacements = displacements(problem, out.result);
  } else {
    const std::vector<MotionStep> steps = read_steps(*stage.scene);
    require_memory(problem.grid, steps.size());
    std::optional<Progress> progress;
    if (steps.size() >= many_steps)
      progress.emplace("steps", steps.size());
    const auto prescribe = [&](int k, ContactProblem& p) {
      if (progress && k > 0)
        progress->step();
      prescribe_step(p, *stage.scene, stage.wheel_rail ? &*stage.wheel_rail : nullptr, steps[k]);
    };
    const int last = static_cast<int>(steps.size()) - 1;
    out.history = solve_history(problem, last + 1, prescribe, options);
    if (progress) {
      progress->step();
      progress->finish();
    }
    out.result = out.history.back();
    progress.reset();
    prescribe(last, problem);
    out.displacements = displacements(problem, out.result);
    for (int k = 0; k < last; ++k)
      if (!out.history[k].converged)
        out.warnings.push_back(
            fmt::format("step {} of {} is not a solution ({})", k + 1, last + 1, out.history[k].remark));
  }
  problem.numbers.values = {}; // its form stays: plane strain or not
  out.seconds.solve = solving.seconds();
  out.problem = problem;
  return out;
}

} // namespace bem_contact
