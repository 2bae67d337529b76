#include "bem_contact/sequence/sequence.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/base/stopwatch.hpp"
#include "bem_contact/sequence/lateral/lateral_search.hpp"
#include "bem_contact/sequence/plan/contact_estimate.hpp"
#include "bem_contact/sequence/plan/settings.hpp"
#include "bem_contact/sequence/result_warnings.hpp"
#include "bem_contact/sequence/settings.hpp"
#include "bem_contact/sequence/solution/free_rolling.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace bem_contact {

namespace {

/// Whether the former elements are so much larger that their tractions are no start for many elements.
bool fine_enough(const ContactGrid& former, const SceneFile::Grid& wanted) {
  return former.dx <= coarse_former * wanted.dx && former.ds <= coarse_former * wanted.ds;
}

/// What rough solutions of lateral forces are of: the same question with half-space numbers.
SceneFile rough_scene(const SceneFile& scene) {
  SceneFile rough = with_model(scene, Model::halfspace);
  rough.grid = SceneFile::Grid();
  rough.grid.rows = scene.grid.rows;
  rough.grid.planar = scene.grid.planar;
  rough.motion.free_rolling = false;
  rough.load.force_y.reset();
  rough.stresses.depths.clear();
  return rough;
}

std::optional<double> lateral_force_of(const SceneResult& solved) {
  const bool known = solved.result.converged && !solved.result.patches.empty();
  return known ? std::optional(solved.result.Fy) : std::nullopt;
}

} // namespace

Sequence::Sequence(SequenceOptions options, std::shared_ptr<SequenceFiles> files)
    : options_(options), memory_{.files = files ? std::move(files) : std::make_shared<SequenceFiles>(),
                                 .numbers = {},
                                 .operators = Workspace(operators_kept, options.threads),
                                 .former = {},
                                 .areas = {},
                                 .element_size = ElementSize(options.ablation.learn),
                                 .lateral = {}} {}

ContactCase Sequence::prepare(const SceneFile& scene, const SceneTask& task) {
  if (!options_.ablation.keep_files)
    memory_.files = std::make_shared<SequenceFiles>();
  return prepare_case(scene, *memory_.files,
                      {.foresee_shear = options_.ablation.foresee_shear,
                       .own_shape = options_.own_shape,
                       .read_influence = task.read_influence,
                       .lateral_force = task.lateral_force});
}

SolveResources Sequence::resources(WorkBudget& work) {
  return {.work = work,
          .files = memory_.files.get(),
          .numbers = options_.ablation.keep_numbers ? &memory_.numbers : nullptr,
          .operators = options_.ablation.keep_numbers ? &memory_.operators : nullptr,
          .coarse_start = options_.ablation.coarse_start,
          .displacements = options_.displacements,
          .threads = options_.threads};
}

SceneResult Sequence::solve(const SceneFile& scene, const std::atomic<bool>* stop) {
  return answer(scene, stop, {});
}

SceneResult Sequence::answer(const SceneFile& scene, const std::atomic<bool>* stop, const SceneTask& task) {
  const std::lock_guard turn(*turn_);
  stop_ = stop;
  const Stopwatch clock;
  ++counts_.cases;
  SceneResult out = scene.load.force_y ? solve_at_lateral_force(scene, task) : solve_at_position(scene, task);
  out.seconds.total = clock.seconds();
  return out;
}

SceneResult Sequence::solve_at_position(const SceneFile& scene, const SceneTask& task) {
  const Stopwatch clock;
  const ContactCase asked = prepare(scene, task);
  const double preparing = clock.seconds();
  SceneResult out;
  if (asked.estimate && scene.motion.kind == MotionKind::steady) {
    out = solve_steady_rolling(asked, task.totals_only);
  } else {
    ++counts_.solves;
    WorkBudget work(stop_);
    out = solve_case(asked, scene.grid, resources(work));
  }
  out.seconds.geometry += preparing;
  return out;
}

SceneResult Sequence::solve_steady_rolling(const ContactCase& asked, bool totals_only) {
  const std::vector<PotentialArea> areas = potential_areas(*asked.estimate);
  memory_.element_size.begin(asked, alike(areas, memory_.areas));
  memory_.areas = areas;
  WorkBudget work(stop_);
  SolveResources tools = resources(work);
  tools.totals_only = totals_only;
  PhaseSeconds spent;
  for (int round = 1;; ++round) {
    const SceneFile::Grid grid = memory_.element_size.grid(asked);
    tools.start = start_for(areas, grid);
    counts_.starts += tools.start != nullptr;
    ++counts_.solves;
    SceneResult out = solve_with_free_rolling(asked, grid, tools);
    spent += out.seconds;
    out.seconds = spent;
    const bool again = memory_.element_size.learn(asked, out);
    remember(out, *asked.estimate);
    if (again && round < most_solves)
      continue;
    warn_of_accuracy(asked.scene.grid, memory_.element_size.limit(grid.dx), out);
    return out;
  }
}

const FormerSolution* Sequence::start_for(const std::vector<PotentialArea>& areas,
                                          const SceneFile::Grid& grid) const {
  const std::optional<FormerSolution>& former = memory_.former;
  const bool serves = former && alike(areas, former->areas) &&
                      (memory_.element_size.wanted() < many_elements || fine_enough(former->grid, grid));
  return serves ? &*former : nullptr;
}

void Sequence::remember(const SceneResult& result, const ContactEstimate& estimate) {
  memory_.former = options_.ablation.keep_start
                       ? former_of(result.model, result.problem, result.result, estimate)
                       : std::nullopt;
}

std::optional<double> Sequence::rough_lateral_force(SceneFile scene, double lateral) {
  ++counts_.rough;
  try {
    const ContactCase asked = prepare(with_lateral(std::move(scene), lateral), {});
    SceneFile::Grid grid;
    std::tie(grid.dx, grid.ds) =
        size_of_elements(*asked.estimate, lateral_map_elements, 1, 0, longest_element);
    WorkBudget work(stop_);
    return lateral_force_of(solve_with_free_rolling(asked, grid, {.work = work, .totals_only = true}));
  } catch (const InputError&) { // the bodies do not meet there, or not as elastic bodies
  } catch (const ConvergenceError&) {
  }
  return std::nullopt;
}

SceneResult Sequence::solve_at_lateral_force(const SceneFile& scene, const SceneTask& task) {
  const Stopwatch searching;
  const double wanted = *scene.load.force_y, start = scene.position.lateral;
  const SceneFile rough = rough_scene(scene);
  if (!memory_.lateral || memory_.lateral->rough != rough)
    memory_.lateral.emplace().rough = rough;
  LateralMemory& memory = *memory_.lateral;
  LateralSearch search(
      {wanted, start, std::hypot(wanted, *scene.load.force)},
      [&](double lateral) { return rough_lateral_force(rough, lateral); }, memory.known);
  if (!search.passes())
    check(with_lateral(scene, start)); // a scene that cannot be solved anywhere says why

  SceneFile asked = scene;
  asked.load.force_y.reset();
  std::optional<SceneResult> chosen;
  if (!scene.solver.model || scene.grid.elements ||
      scene.grid.accuracy) { // the same model and elements all the way
    SceneTask choosing = task;
    choosing.lateral_force = true;
    chosen = solve_at_position(with_lateral(scene, search.guess()), choosing);
    const ContactGrid& grid = chosen->problem.grid;
    asked = with_elements(with_model(std::move(asked), chosen->model), grid.dx, grid.ds);
  }
  SceneFile on_the_way = asked;
  on_the_way.motion.free_rolling = false;
  if (memory.exact != on_the_way)
    memory.known.exact.clear();
  memory.exact = on_the_way;
  SceneTask totals = task;
  totals.totals_only = true;
  const double lateral = search.find(
      [&](double at) { return lateral_force_of(solve_at_position(with_lateral(on_the_way, at), totals)); });

  const double searched = searching.seconds();
  SceneResult out = solve_at_position(with_lateral(asked, lateral), task);
  out.seconds.search = searched;
  if (chosen)
    take_choice(*chosen, out);
  const double error = out.result.discretisation ? out.result.discretisation->errors.Fy : unknown_error;
  out.found_lateral = search.describe(lateral, error);
  warn_of_accuracy(scene.grid, "all displacements are tried on the elements of the first one", out);
  warn_of_lateral(scene, search.force_at_start(), out);
  return out;
}

SceneResult Sequence::solve_beyond(const SceneFile& scene, const FreeRolling& free, double creepage) {
  WorkBudget work(stop_);
  return solve_case(beyond_free_rolling(prepare(scene, {.read_influence = true}), free, creepage), scene.grid,
                    resources(work));
}

Comparison Sequence::compare(const SceneFile& scene, std::vector<Model> models,
                             const std::atomic<bool>* stop) {
  const std::lock_guard turn(*turn_);
  return compare_models(
      scene, std::move(models),
      [&](const SceneFile& asked) { return answer(asked, stop, {.read_influence = true}); },
      [&](const SceneFile& asked, const FreeRolling& free, double creepage) {
        return solve_beyond(asked, free, creepage);
      });
}

SceneDescription Sequence::check(const SceneFile& scene) {
  const std::lock_guard turn(*turn_);
  return describe_case(prepare(scene, {.read_influence = true}));
}

Sequence::Counts Sequence::counts() const {
  const std::lock_guard turn(*turn_);
  Counts counts = counts_;
  counts.numbers_kept = memory_.numbers.found();
  return counts;
}

} // namespace bem_contact
