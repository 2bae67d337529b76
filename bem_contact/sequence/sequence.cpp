#include "bem_contact/sequence/sequence.hpp"

#include "bem_contact/base/stopwatch.hpp"
#include "bem_contact/sequence/describe_case.hpp"
#include "bem_contact/sequence/solve_case.hpp"

#include <fmt/format.h>

namespace bem_contact {

namespace {

/// Whether the former elements are so much larger that their tractions are no start for many elements.
bool fine_enough(const ContactGrid& former, const SceneFile::Grid& wanted) {
  return former.dx <= coarse_former * wanted.dx && former.ds <= coarse_former * wanted.ds;
}

/// A warning where a solution misses the accuracy that its scene asks for. `why`: it was not reached.
void warn_of_accuracy(const SceneFile& scene, const std::string& why, SceneResult& out) {
  const double error = out.result.certificate.discretisation;
  if (!scene.grid.accuracy || !out.result.converged || error <= *scene.grid.accuracy)
    return;
  out.warnings.push_back(
      fmt::format("the estimated discretisation error reached is {:.2g} %, above the {:.2g} % that "
                  "grid.accuracy asks for ({} elements in contact; {})",
                  100 * error, 100 * *scene.grid.accuracy, count_elements(out.result).contact, why));
}

} // namespace

Sequence::Sequence(SequenceOptions options, std::shared_ptr<SequenceFiles> files)
    : options_(options), memory_{.files = files ? std::move(files) : std::make_shared<SequenceFiles>(),
                                 .numbers = {},
                                 .former = {},
                                 .areas = {},
                                 .element_size = ElementSize(options.learn)} {}

ContactCase Sequence::prepare(const SceneFile& scene) {
  if (!options_.keep_files)
    memory_.files = std::make_shared<SequenceFiles>();
  ContactCase out = prepare_case(scene, *memory_.files, options_.foresee_shear);
  if (out.estimate && !options_.potential_contact)
    out.estimate->reach *= generous_reach;
  return out;
}

SolveResources Sequence::resources(WorkBudget& work) {
  return {.work = work,
          .numbers = options_.keep_numbers ? &memory_.numbers : nullptr,
          .operators = options_.keep_numbers ? &memory_.operators : nullptr,
          .coarse_start = options_.coarse_start,
          .displacements = options_.displacements};
}

SceneResult Sequence::solve(const SceneFile& scene) {
  const Stopwatch clock;
  ++counts_.cases;
  const ContactCase asked = prepare(scene);
  const double preparing = clock.seconds();
  SceneResult out;
  if (asked.estimate && scene.motion.kind == MotionKind::steady) {
    out = solve_steady_rolling(asked);
  } else {
    ++counts_.solves;
    WorkBudget work;
    out = solve_case(asked, scene.grid, resources(work));
  }
  out.seconds.geometry += preparing;
  out.seconds.total = clock.seconds();
  return out;
}

SceneResult Sequence::solve_steady_rolling(const ContactCase& asked) {
  const std::vector<PotentialArea> areas = potential_areas(*asked.estimate);
  memory_.element_size.begin(asked, alike(areas, memory_.areas));
  memory_.areas = areas;
  WorkBudget work;
  SolveResources tools = resources(work);
  PhaseSeconds spent;
  for (int round = 1;; ++round) {
    const SceneFile::Grid grid = memory_.element_size.grid(asked);
    tools.start = start_for(areas, grid);
    counts_.starts += tools.start != nullptr;
    ++counts_.solves;
    SceneResult out = solve_case(asked, grid, tools);
    spent += out.seconds;
    out.seconds = spent;
    const bool again = memory_.element_size.learn(asked, out);
    remember(out, *asked.estimate);
    if (again && round < most_solves)
      continue;
    warn_of_accuracy(asked.scene, memory_.element_size.limit(grid.dx), out);
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
  const ContactResult& r = result.result;
  memory_.former.reset();
  if (options_.keep_start && r.converged && !r.patches.empty() && estimate.approach > 0)
    memory_.former = FormerSolution{result.problem.grid,
                                    result.problem.rows.front().s,
                                    r.Fz,
                                    r.approach,
                                    potential_areas(estimate),
                                    r.px,
                                    r.ps,
                                    r.pn};
}

Comparison Sequence::compare(const SceneFile& scene) {
  SceneFile::Grid grid = scene.grid;
  if (scene.kind == SceneKind::wheel_rail && (grid.elements || grid.accuracy)) {
    const ContactGrid chosen = solve(with_model(scene, Model::fem)).problem.grid;
    grid.dx = chosen.dx;
    grid.ds = chosen.ds;
  }
  Comparison out = compare_case(prepare(scene), grid, memory_.operators);
  for (SceneResult* result : {&out.halfspace, &out.fem})
    warn_of_accuracy(scene, "both models have the elements of fem", *result);
  return out;
}

std::vector<std::string> Sequence::check(const SceneFile& scene) {
  return describe_case(prepare(scene));
}

Sequence::Counts Sequence::counts() const {
  Counts counts = counts_;
  counts.numbers_kept = memory_.numbers.found();
  return counts;
}

} // namespace bem_contact
