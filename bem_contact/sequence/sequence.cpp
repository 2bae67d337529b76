#include "bem_contact/sequence/sequence.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/base/stopwatch.hpp"
#include "bem_contact/sequence/contact_estimate.hpp"
#include "bem_contact/sequence/describe_case.hpp"
#include "bem_contact/sequence/free_rolling.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <tuple>

namespace bem_contact {

namespace {

/// Whether the former elements are so much larger that their tractions are no start for many elements.
bool fine_enough(const ContactGrid& former, const SceneFile::Grid& wanted) {
  return former.dx <= coarse_former * wanted.dx && former.ds <= coarse_former * wanted.ds;
}

/// A warning where a solution misses the accuracy that its scene asks for. `why`: it was not reached.
void warn_of_accuracy(const SceneFile& scene, const std::string& why, SceneResult& out) {
  const double error = asked_error(scene.grid, out);
  if (!scene.grid.accuracy || !out.result.converged || error <= *scene.grid.accuracy)
    return;
  out.warnings.push_back(
      fmt::format("the estimated discretisation error reached is {:.2g} %, above the {:.2g} % that "
                  "grid.accuracy asks for ({} elements in contact; {})",
                  100 * error, 100 * *scene.grid.accuracy, count_elements(out.result).contact, why));
}

SceneFile at_lateral(SceneFile scene, double lateral) {
  scene.position.lateral = lateral;
  scene.load.force_y.reset();
  return scene;
}

SceneFile with_elements_of(SceneFile scene, const SceneResult& solved) {
  scene.grid.dx = solved.problem.grid.dx;
  scene.grid.ds = solved.problem.grid.ds;
  scene.grid.elements.reset();
  scene.grid.accuracy.reset();
  return scene;
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

[[noreturn]] void refuse_lateral_force(double wanted, const std::vector<LateralSample>& samples) {
  if (samples.empty())
    throw InputError(fmt::format("No lateral displacement gives a lateral force of {:g} N", wanted),
                     "wheel and rail have no elastic contact at any displacement that was looked at",
                     "Check load, gauge and profiles, or give another position.lateral.");
  const auto [least, most] = std::ranges::minmax(samples, {}, &LateralSample::force);
  throw InputError(
      fmt::format("No lateral displacement gives a lateral force of {:g} N", wanted),
      fmt::format("from {:.4g} to {:.4g} mm the force on the rail is between {:.4g} and {:.4g} N",
                  samples.front().lateral, samples.back().lateral, least.force, most.force),
      "Give load.force_y in this range (its sign: towards the side of this wheel), or another "
      "position.lateral.");
}

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

} // namespace

Sequence::Sequence(SequenceOptions options, std::shared_ptr<SequenceFiles> files)
    : options_(options), memory_{.files = files ? std::move(files) : std::make_shared<SequenceFiles>(),
                                 .numbers = {},
                                 .former = {},
                                 .areas = {},
                                 .element_size = ElementSize(options.learn),
                                 .lateral = {}} {}

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

SceneResult Sequence::solve(const SceneFile& scene, const std::atomic<bool>* stop) {
  const std::lock_guard turn(*turn_);
  stop_ = stop;
  const Stopwatch clock;
  ++counts_.cases;
  SceneResult out = scene.load.force_y ? solve_at_lateral_force(scene) : solve_at_position(scene);
  out.seconds.total = clock.seconds();
  return out;
}

SceneResult Sequence::solve_at_position(const SceneFile& scene, bool totals_only) {
  const Stopwatch clock;
  const ContactCase asked = prepare(scene);
  const double preparing = clock.seconds();
  SceneResult out;
  if (asked.estimate && scene.motion.kind == MotionKind::steady) {
    out = solve_steady_rolling(asked, totals_only);
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
  memory_.former = options_.keep_start ? former_of(result.problem, result.result, estimate) : std::nullopt;
}

std::optional<double> Sequence::rough_lateral_force(SceneFile scene, double lateral) {
  try {
    const ContactCase asked = prepare(at_lateral(std::move(scene), lateral));
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

const Sequence::LateralBranches& Sequence::lateral_branches(const SceneFile& scene) {
  if (!memory_.lateral || memory_.lateral->scene != scene)
    memory_.lateral = LateralBranches{
        scene, sample_lateral_force([&](double lateral) { return rough_lateral_force(scene, lateral); },
                                    scene.position.lateral)};
  return *memory_.lateral;
}

SceneResult Sequence::solve_at_lateral_force(const SceneFile& scene) {
  const double wanted = *scene.load.force_y;
  const SceneFile rough = rough_scene(scene);
  const LateralBranches& branches = lateral_branches(rough);
  const std::vector<LateralRoot> roots = find_lateral_roots(
      [&](double lateral) { return rough_lateral_force(rough, lateral); }, branches.samples, wanted);
  if (roots.empty()) {
    check(at_lateral(scene, scene.position.lateral)); // a scene that cannot be solved anywhere says why
    refuse_lateral_force(wanted, branches.samples);
  }
  const auto nearest = std::ranges::min_element(
      roots, {}, [&](const LateralRoot& root) { return std::abs(root.lateral - scene.position.lateral); });

  SceneFile asked = scene;
  std::string reason;
  if (!scene.solver.model || scene.grid.elements ||
      scene.grid.accuracy) { // the same model and elements all the way
    const SceneResult first = solve_at_position(at_lateral(scene, nearest->lateral + branches.offset));
    asked = with_elements_of(with_model(std::move(asked), first.model), first);
    reason = first.reason;
  }
  SceneFile on_the_way = asked;
  on_the_way.motion.free_rolling = false;
  const double tolerance = lateral_tolerance * std::hypot(wanted, *scene.load.force);
  const double lateral = solve_lateral_force(
      [&](double at) { return lateral_force_of(solve_at_position(at_lateral(on_the_way, at), true)); },
      wanted, {nearest->lateral + branches.offset, nearest->slope}, tolerance);
  memory_.lateral->offset = lateral - nearest->lateral;

  SceneResult out = solve_at_position(at_lateral(asked, lateral));
  out.reason = reason.empty() ? out.reason : reason;
  out.found_lateral = LateralPosition{lateral, {}};
  for (const LateralRoot& root : roots)
    if (root.lateral != nearest->lateral)
      out.found_lateral->others.push_back(root.lateral);
  warn_of_accuracy(scene, "all displacements are tried on the elements of the first one", out);
  return out;
}

std::vector<CreepForces> Sequence::creep_forces(const SceneFile& scene,
                                                const std::vector<SceneResult>& at_forces) {
  std::vector<CreepForces> out;
  for (const double creepage : compared_creepages) {
    CreepForces forces{creepage, {}};
    for (const SceneResult& free : at_forces) {
      WorkBudget work(stop_);
      SolveResources tools = resources(work);
      tools.totals_only = true;
      const ContactCase asked = prepare(with_model(at_lateral(scene, *free.lateral), free.model));
      forces.Fx.push_back(
          solve_case(beyond_free_rolling(asked, *free.free_rolling, creepage), scene.grid, tools).result.Fx);
    }
    out.push_back(std::move(forces));
  }
  return out;
}

Comparison Sequence::compare(const SceneFile& scene, std::vector<Model> models) {
  const std::lock_guard turn(*turn_);
  require_comparable(scene, models);
  Comparison out;
  const auto fem = std::ranges::find(models, Model::fem);
  out.reference = fem != models.end() ? fem - models.begin() : models.size() - 1;
  out.models = std::move(models);
  const Model reference = out.models[out.reference];
  const bool patch = scene.kind == SceneKind::patch;

  // What the others have to meet: the size of the elements, Fz, the place.
  SceneFile asked = scene;
  if (scene.grid.elements || scene.grid.accuracy || !scene.load.force || scene.load.force_y) {
    const SceneResult first = solve(with_model(scene, reference));
    asked = with_elements_of(std::move(asked), first);
    asked.position.lateral = first.lateral.value_or(asked.position.lateral);
    asked.load.force_y.reset();
    asked.load.force = first.result.Fz;
    asked.load.approach.reset();
    asked.position.vertical.reset();
  }
  std::vector<SceneResult>& first = patch ? out.at_forces : out.at_position;
  for (const Model model : out.models) {
    first.push_back(solve(with_model(asked, model)));
    warn_of_accuracy(scene, "all models have the elements of the reference", first.back());
  }
  if (patch || (scene.motion.kind != MotionKind::steady && !scene.motion.frictionless))
    return out;

  SceneFile equal = asked;
  equal.motion.from_free_rolling = false;
  if (!scene.motion.frictionless)
    equal.load.force_x = scene.load.force_x.value_or(0);
  const bool the_same = scene.motion.frictionless || scene.load.force_x;
  const SceneResult& place = out.at_position[out.reference];
  SceneResult there = the_same ? place : solve(with_model(equal, reference));
  equal.load.force_y = scene.load.force_y.value_or(there.result.Fy);
  for (const Model model : out.models)
    out.at_forces.push_back(model == reference && !scene.load.force_y ? there
                                                                      : solve(with_model(equal, model)));
  equal.load.force_y.reset();
  if (!the_same &&
      std::ranges::all_of(out.at_forces, [](const SceneResult& r) { return r.free_rolling.has_value(); }))
    out.creep_forces = creep_forces(equal, out.at_forces);
  return out;
}

SceneDescription Sequence::check(const SceneFile& scene) {
  const std::lock_guard turn(*turn_);
  return describe_case(prepare(scene));
}

Sequence::Counts Sequence::counts() const {
  const std::lock_guard turn(*turn_);
  Counts counts = counts_;
  counts.numbers_kept = memory_.numbers.found();
  return counts;
}

} // namespace bem_contact
