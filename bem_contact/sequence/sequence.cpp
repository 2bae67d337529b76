#include "bem_contact/sequence/sequence.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/base/stopwatch.hpp"
#include "bem_contact/scene/derivative_inputs.hpp"
#include "bem_contact/sequence/asked_error.hpp"
#include "bem_contact/sequence/describe_case.hpp"
#include "bem_contact/sequence/lateral/lateral_search.hpp"
#include "bem_contact/sequence/lateral/settings.hpp"
#include "bem_contact/sequence/models.hpp"
#include "bem_contact/sequence/numbers/sequence_files.hpp"
#include "bem_contact/sequence/plan/contact_case.hpp"
#include "bem_contact/sequence/plan/contact_estimate.hpp"
#include "bem_contact/sequence/plan/element_size.hpp"
#include "bem_contact/sequence/result_warnings.hpp"
#include "bem_contact/sequence/settings.hpp"
#include "bem_contact/sequence/solution/derivatives_of.hpp"
#include "bem_contact/sequence/solution/foundations.hpp"
#include "bem_contact/sequence/solution/free_rolling.hpp"
#include "bem_contact/sequence/solution/slide_errors.hpp"
#include "bem_contact/sequence/solution/solve_case.hpp"
#include "bem_contact/sequence/solution/warm_start.hpp"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <optional>
#include <tuple>

namespace bem_contact {

namespace {

/// 1. Elements in contact of the rough half-space solutions that a search for a lateral force begins with.
/// Chosen: they only tell which branches there are.
constexpr int lateral_map_elements = 60;
/// 1. Length and width over the wanted ones.
constexpr double coarse_former = 1.5;
/// 1. Grids whose operators are kept: they take more.
constexpr int operators_kept = 3;

/// How a scene is solved on the way to an answer.
struct SceneTask {
  const std::atomic<bool>* stop = nullptr; ///< of the call
  bool totals_only = false;                ///< no stated errors, no displacements
  bool read_influence = false; ///< influence files are read for each model: all have the same rows
  bool lateral_force = false;  ///< the lateral displacement is found for a force, and not given
};

/// Whether the former elements are so much larger that their tractions are no start for many elements.
bool fine_enough(const ContactGrid& former, const SceneFile::Grid& wanted) {
  return former.dx <= coarse_former * wanted.dx && former.ds <= coarse_former * wanted.ds;
}

/// Whether model or elements are chosen by a solution.
bool chooses(const SceneFile& scene) {
  return !scene.solver.model || scene.grid.elements || scene.grid.accuracy;
}

std::optional<double> lateral_force_of(const SceneResult& solved) {
  const bool known = solved.result.certified() && !solved.result.patches.empty();
  return known ? std::optional(solved.result.totals.Fy) : std::nullopt;
}

} // namespace

class Sequence::Impl {
public:
  Impl(SequenceOptions options, std::shared_ptr<SequenceFiles> files);

  SceneResult answer(const SceneFile& scene, const SceneTask& task);
  SceneResult solve_beyond(const SceneFile& scene, const FreeRolling& free, double creepage,
                           const std::atomic<bool>* stop);
  ContactCase prepare(const SceneFile& scene, const SceneTask& task);
  Counts counts() const;

  std::mutex turn; ///< held by the call that runs

private:
  /// Lateral forces of a scene, for any load.force_y.
  struct LateralMemory {
    SceneFile rough, exact; ///< the scenes solved, without load.force_y
    KnownLateralForces known;
  };
  /// What a search for a lateral displacement keeps all the way.
  struct LateralWay {
    SceneFile scene; ///< without load.force_y; one model and the same elements
    std::optional<SceneResult> chosen =
        {}; ///< by which model and elements were chosen, if they were not given
    std::string limit = "all displacements are tried on the elements of the first one"; ///< of the accuracy
  };

  SolveResources resources(WorkBudget& work);
  SceneResult solve_at_position(const SceneFile& scene, const SceneTask& task);
  SceneResult solve_at_lateral_force(const SceneFile& scene, const SceneTask& task);
  std::optional<double> rough_lateral_force(SceneFile scene, double lateral, const SceneTask& task);
  LateralMemory& lateral_memory(const SceneFile& rough);
  /// At position.lateral, if that may bear the force and has a solution.
  std::optional<SceneResult> solve_at_start(const SceneFile& scene, LateralSearch& search,
                                            const SceneTask& task);
  LateralWay lateral_way(const SceneFile& scene, const std::optional<SceneResult>& first, double guess,
                         const SceneTask& task);
  /// The displacement that bears the force, mm.
  double found_lateral(const SceneFile& scene, LateralSearch& search, const SceneTask& task,
                       std::vector<LateralTrial>& trials);
  SceneResult solve_steady_rolling(const ContactCase& asked, const SceneTask& task);
  const FormerSolution* start_for(const std::vector<PotentialArea>& areas, const SceneFile::Grid& grid) const;
  void remember(const SceneResult& result, const ContactEstimate& estimate);

  const SequenceOptions options_;
  // All that outlives a case.
  std::shared_ptr<SequenceFiles> files_;
  NumbersStore numbers_;
  Workspace operators_;
  std::optional<FormerSolution> former_;
  std::vector<PotentialArea> areas_; ///< of the last case
  ElementSize element_size_;
  std::optional<LateralMemory> lateral_;
  Counts counts_;
};

Sequence::Impl::Impl(SequenceOptions options, std::shared_ptr<SequenceFiles> files)
    : options_(options), files_(files ? std::move(files) : std::make_shared<SequenceFiles>()),
      operators_(operators_kept, options.threads), element_size_(options.ablation.learn) {}

ContactCase Sequence::Impl::prepare(const SceneFile& scene, const SceneTask& task) {
  if (!options_.ablation.keep_files)
    files_ = std::make_shared<SequenceFiles>();
  return prepare_case(scene, *files_,
                      {.foresee_shear = options_.ablation.foresee_shear,
                       .own_shape = options_.own_shape,
                       .read_influence = task.read_influence,
                       .lateral_force = task.lateral_force});
}

SolveResources Sequence::Impl::resources(WorkBudget& work) {
  return {.work = work,
          .files = files_.get(),
          .numbers = options_.ablation.keep_numbers ? &numbers_ : nullptr,
          .operators = options_.ablation.keep_numbers ? &operators_ : nullptr,
          .coarse_start = options_.ablation.coarse_start,
          .displacements = options_.displacements,
          .derivatives = true,
          .threads = options_.threads};
}

SceneResult Sequence::Impl::answer(const SceneFile& scene, const SceneTask& task) {
  const Stopwatch clock;
  ++counts_.cases;
  require_derivatives(scene);
  if (scene.load.force_y) {
    SceneResult out = solve_at_lateral_force(scene, task);
    out.seconds.total = clock.seconds();
    return out;
  }
  const auto rigid = [&](const SceneFile& bodies) { return solve_at_position(bodies, task); };
  SceneResult out = rigid(on_foundations(scene, rigid));
  add_slide_errors(out);
  out.seconds.total = clock.seconds();
  return out;
}

SceneResult Sequence::Impl::solve_at_position(const SceneFile& scene, const SceneTask& task) {
  const Stopwatch clock;
  const ContactCase asked = prepare(scene, task);
  const double preparing = clock.seconds();
  SceneResult out;
  if (asked.estimate && scene.motion.kind == MotionKind::steady) {
    out = solve_steady_rolling(asked, task);
  } else {
    ++counts_.solves;
    WorkBudget work(task.stop);
    out = solve_case(asked, scene.grid, resources(work));
  }
  out.seconds.geometry += preparing;
  return out;
}

SceneResult Sequence::Impl::solve_steady_rolling(const ContactCase& asked, const SceneTask& task) {
  const std::vector<PotentialArea> areas = potential_areas(*asked.estimate);
  element_size_.begin(asked, alike(areas, areas_));
  areas_ = areas;
  WorkBudget work(task.stop);
  SolveResources tools = resources(work);
  tools.totals_only = task.totals_only;
  const EarlyEnd early_end{rough_share * asked.scene.grid.accuracy.value_or(0),
                           [&](const ContactProblem& problem, const ContactResult& rough) {
                             return element_size_.asks_for_more(asked, problem, rough);
                           }};
  PhaseSeconds spent;
  for (int round = 1;; ++round) {
    const SceneFile::Grid grid = element_size_.grid(asked);
    tools.early_end =
        asked.scene.grid.accuracy && round < most_solves && !task.totals_only ? &early_end : nullptr;
    tools.start = start_for(areas, grid);
    counts_.starts += tools.start != nullptr;
    ++counts_.solves;
    SceneResult out = solve_with_free_rolling(asked, grid, tools);
    spent += out.seconds;
    out.seconds = spent;
    const bool again = element_size_.learn(asked, out);
    remember(out, *asked.estimate);
    if (again && round < most_solves)
      continue;
    warn_of_accuracy(asked.scene.grid, element_size_.limit(grid.dx), out);
    return out;
  }
}

const FormerSolution* Sequence::Impl::start_for(const std::vector<PotentialArea>& areas,
                                                const SceneFile::Grid& grid) const {
  const std::optional<FormerSolution>& former = former_;
  const bool serves = former && alike(areas, former->areas) &&
                      (element_size_.wanted() < many_elements || fine_enough(former->grid, grid));
  return serves ? &*former : nullptr;
}

void Sequence::Impl::remember(const SceneResult& result, const ContactEstimate& estimate) {
  former_ = options_.ablation.keep_start
                ? former_of(result.choice.model, result.problem, result.result, estimate)
                : std::nullopt;
}

std::optional<double> Sequence::Impl::rough_lateral_force(SceneFile scene, double lateral,
                                                          const SceneTask& task) {
  ++counts_.rough;
  try {
    const ContactCase asked = prepare(with_lateral(std::move(scene), lateral), {});
    SceneFile::Grid grid;
    std::tie(grid.dx, grid.ds) = size_of_elements(*asked.estimate, lateral_map_elements, 1, {});
    WorkBudget work(task.stop);
    return lateral_force_of(solve_with_free_rolling(asked, grid, {.work = work, .totals_only = true}));
  } catch (const InputError&) { // the bodies do not meet there, or not as elastic bodies
  } catch (const ConvergenceError&) {
  }
  return std::nullopt;
}

Sequence::Impl::LateralMemory& Sequence::Impl::lateral_memory(const SceneFile& rough) {
  if (!lateral_ || lateral_->rough != rough)
    lateral_.emplace().rough = rough;
  return *lateral_;
}

std::optional<SceneResult> Sequence::Impl::solve_at_start(const SceneFile& scene, LateralSearch& search,
                                                          const SceneTask& task) {
  try {
    if (search.start_may_bear())
      return solve_at_position(with_lateral(scene, scene.position.lateral), task);
  } catch (const InputError&) { // the search may lead to where there is a solution
  } catch (const ConvergenceError&) {
  }
  return std::nullopt;
}

Sequence::Impl::LateralWay Sequence::Impl::lateral_way(const SceneFile& scene,
                                                       const std::optional<SceneResult>& first, double guess,
                                                       const SceneTask& task) {
  LateralWay out{scene};
  out.scene.load.force_y.reset();
  if (!chooses(scene))
    return out;
  out.chosen = first && std::abs(guess - scene.position.lateral) <= lateral::spacing
                   ? first
                   : solve_at_position(with_lateral(scene, guess), task);
  const ContactGrid& grid = out.chosen->problem.grid;
  out.scene = with_elements(with_model(std::move(out.scene), out.chosen->choice.model), grid.dx, grid.ds);
  if (scene.grid.accuracy && asked_error(scene.grid, out.chosen->result) > *scene.grid.accuracy)
    out.limit = element_size_.limit(grid.dx);
  return out;
}

double Sequence::Impl::found_lateral(const SceneFile& scene, LateralSearch& search, const SceneTask& task,
                                     std::vector<LateralTrial>& trials) {
  SceneTask totals = task;
  totals.totals_only = true;
  const auto force_at = [&](double at) {
    const SceneResult there = solve_at_position(with_lateral(scene, at), totals);
    const std::optional<double> force = lateral_force_of(there);
    if (force)
      trials.push_back({there.result.totals, there.moment});
    return force;
  };
  return search.find([&](double at) -> std::optional<double> {
    try {
      if (const std::optional<double> force = force_at(at))
        return force;
    } catch (const ConvergenceError&) {
    }
    former_.reset(); // a start that lies elsewhere on a steep flange may lead nowhere
    return force_at(at);
  });
}

SceneResult Sequence::Impl::solve_at_lateral_force(const SceneFile& scene, const SceneTask& task) {
  const Stopwatch searching;
  const double wanted = *scene.load.force_y, start = scene.position.lateral;
  const Counts before = counts_;
  LateralMemory& memory = lateral_memory(rough_scene(scene));
  LateralSearch search(
      {wanted, start, std::hypot(wanted, *scene.load.force)},
      [&](double lateral) { return rough_lateral_force(memory.rough, lateral, task); }, memory.known);
  SceneTask choosing = task;
  choosing.lateral_force = chooses(scene);
  const std::optional<SceneResult> first = solve_at_start(scene, search, choosing);
  const std::optional<double> force_there = first ? lateral_force_of(*first) : std::nullopt;
  const bool is_there = force_there && search.met(*force_there);
  const auto tell = [&](SceneResult& out, double lateral) {
    LateralPosition& at =
        out.motion.found_lateral.emplace(search.describe(lateral, out.result.totals.Fy.error));
    std::tie(at.solutions, at.rough) =
        std::pair(counts_.solves - before.solves, counts_.rough - before.rough);
    warn_of_lateral(scene, is_there ? force_there : search.force_at_start(), out);
  };
  if (is_there) {
    SceneResult out = *first;
    add_slide_errors(out);
    tell(out, start);
    return out;
  }
  if (!search.passes())
    describe_case(prepare(with_lateral(scene, start),
                          {.read_influence = true})); // a scene that cannot be solved anywhere says why

  const LateralWay way = lateral_way(scene, first, chooses(scene) ? search.guess() : start, choosing);
  SceneFile on_the_way = way.scene;
  on_the_way.motion.free_rolling = false;
  if (memory.exact != on_the_way)
    memory.known.exact.clear();
  memory.exact = on_the_way;
  if (force_there && (!way.chosen || way.chosen->motion.lateral == start))
    search.learn({start, *force_there});
  std::vector<LateralTrial> trials;
  const double lateral = found_lateral(on_the_way, search, task, trials), searched = searching.seconds();
  SceneResult out = solve_at_position(with_lateral(way.scene, lateral), task);
  out.seconds.search = searched;
  if (way.chosen)
    take_choice(way.chosen->choice, out);
  warn_of_accuracy(scene.grid, way.limit, out);
  add_position_errors(trials, add_slide_errors(out), out);
  tell(out, lateral);
  return out;
}

SceneResult Sequence::Impl::solve_beyond(const SceneFile& scene, const FreeRolling& free, double creepage,
                                         const std::atomic<bool>* stop) {
  WorkBudget work(stop);
  return solve_case(beyond_free_rolling(prepare(scene, {.read_influence = true}), free, creepage), scene.grid,
                    resources(work));
}

Sequence::Counts Sequence::Impl::counts() const {
  Counts counts = counts_;
  counts.numbers_kept = numbers_.found();
  return counts;
}

Sequence::Sequence(SequenceOptions options, std::shared_ptr<SequenceFiles> files)
    : impl_(std::make_unique<Impl>(options, std::move(files))) {}
Sequence::Sequence(Sequence&&) noexcept = default;
Sequence& Sequence::operator=(Sequence&&) noexcept = default;
Sequence::~Sequence() = default;

SceneResult Sequence::solve(const SceneFile& scene, const std::atomic<bool>* stop) {
  const std::lock_guard turn(impl_->turn);
  return impl_->answer(scene, {.stop = stop});
}

Comparison Sequence::compare(const SceneFile& scene, std::vector<Model> models,
                             const std::atomic<bool>* stop) {
  const std::lock_guard turn(impl_->turn);
  refuse_derivatives(scene, "a comparison");
  return compare_models(
      scene, std::move(models),
      [&](const SceneFile& asked) { return impl_->answer(asked, {.stop = stop, .read_influence = true}); },
      [&](const SceneFile& asked, const FreeRolling& free, double creepage) {
        return impl_->solve_beyond(asked, free, creepage, stop);
      });
}

SceneDescription Sequence::check(const SceneFile& scene) {
  const std::lock_guard turn(impl_->turn);
  require_derivatives(scene);
  return describe_case(impl_->prepare(scene, {.read_influence = true}));
}

Sequence::Counts Sequence::counts() const {
  const std::lock_guard turn(impl_->turn);
  return impl_->counts();
}

} // namespace bem_contact
