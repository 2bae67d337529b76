#include "bem_contact/uses/sweep/sweep_case.hpp"

#include "bem_contact/base/said_by.hpp"
#include "bem_contact/base/stopped.hpp"
#include "bem_contact/base/stopwatch.hpp"
#include "bem_contact/sequence/foreseen_work.hpp"
#include "bem_contact/sequence/quantities.hpp"
#include "bem_contact/sequence/result_warnings.hpp"
#include "bem_contact/sequence/uncertified.hpp"
#include "bem_contact/uses/sweep/replay_steps.hpp"
#include "bem_contact/uses/sweep/sweep_columns.hpp"

#include <algorithm>
#include <ctime>
#include <fmt/format.h>
#include <optional>

namespace bem_contact {

namespace {

using record::Outcome;

/// 1. One process solves a chunk of cases one after the other and starts each case from the one before. More
/// chunks share the work better; longer chunks have fewer cold starts. Chosen, not measured.
constexpr std::size_t chunks_of_a_sweep = 8;
/// Cases. Smallest and largest chunk. Chosen, not measured.
constexpr std::size_t smallest_chunk = 4;
constexpr std::size_t largest_chunk = 32;
/// Cases. Largest chunk of a replay, whose first and last steps are always solved. Chosen.
constexpr std::size_t steps_of_a_replay = 256;

/// Units of work, a second or less. A sweep of no more is one chunk: cold starts and other processes would
/// cost more than they save.
constexpr double little_work = 2e7;
/// Units of work: of a case of which nothing is known (contact/work.hpp).
constexpr double usual_case_work = 1e6;
/// Units of work, half a minute. A case that takes longer is a chunk of its own, so that no chunk takes many
/// minutes. Chosen.
constexpr double slow_case_work = 1e9;

/// Adds to the reason of a case.
void say(SweepCase& record, const std::string& text) {
  if (!text.empty())
    record.reason += (record.reason.empty() ? "" : "; ") + text;
}

SweepCase case_of(const SceneResult& result, const SweepOptions& options, const SweepColumns& columns) {
  SweepCase out;
  const bool all = certified(result);
  out.status = all ? Outcome::certified : Outcome::not_certified;
  say(out, all ? result.result.trust.solver_note : why_not_certified(result));
  out.summary = summary_of(result, columns.inputs);
  out.patches = patch_rows(result);
  if (options.seen)
    options.seen("", result);
  return out;
}

SweepCase case_of(const WheelsetResult& result, const SweepOptions& options, const SweepColumns&) {
  SweepCase out;
  out.status = certified(result.state) ? Outcome::certified : Outcome::not_certified;
  out.summary = summary_of(result);
  out.patches = patch_rows(result);
  for (const WheelSide side : both_sides) {
    const SceneResult& wheel = result.state.solved(side);
    const std::string name(name_of(side));
    if (!certified(wheel))
      say(out, fmt::format("{} wheel: {}", name, why_not_certified(wheel)));
    if (options.seen)
      options.seen(name + "/", wheel);
  }
  return out;
}

/// What all cases of a sweep have in common.
struct Common {
  const SweepOptions& options;
  const std::shared_ptr<SequenceFiles>& files;
  SweepColumns columns;
};

SweepCase solve_case(Sequence& sequence, SweepScenes& scenes, std::size_t index, const Common& common) {
  const SweepOptions& options = common.options;
  const Stopwatch watch;
  const std::clock_t cpu = std::clock();
  SweepCase out;
  try {
    const SceneFile scene = with_model(scenes.scene(index), options.model);
    const auto kept = [&](const auto& result) {
      if (options.strict)
        refuse_warnings(result.warnings);
      SweepCase found = case_of(result, options, common.columns);
      for (const Warning& warning : result.warnings)
        say(found, warning.text);
      return found;
    };
    out = scene.wheelset.force ? kept(solve_wheelset(scene, options.stop, common.files))
                               : kept(sequence.solve(scene, options.stop));
  } catch (const Stopped&) {
    throw;
  } catch (const std::exception& error) {
    out = {.status = record::outcome_of(error), .reason = said_by(error)};
  }
  out.index = index;
  out.seconds = watch.seconds();
  out.cpu_seconds = static_cast<double>(std::clock() - cpu) / CLOCKS_PER_SEC;
  return out;
}

} // namespace

std::size_t chunk_size(std::size_t cases) {
  return std::clamp(cases / chunks_of_a_sweep, smallest_chunk, largest_chunk);
}

SweepCut cut_of(std::size_t cases, double case_work) {
  if (case_work * double(cases) <= little_work)
    return {case_work, std::max<std::size_t>(cases, 1), true};
  return {case_work, case_work > slow_case_work ? 1 : chunk_size(cases), false};
}

SweepCut cut_of(const SweepFile& sweep, const std::string& model, SequenceFiles& files) {
  double work = usual_case_work;
  try {
    work = foreseen_work(with_model(sweep.first_scene(), model), files);
  } catch (const Error&) { // others may be solved
  }
  SweepCut cut = cut_of(sweep.size(), work);
  if (sweep.replay && !cut.little) // its chunks are long, so that what is static is solved once
    cut.chunk = std::clamp(sweep.size() / chunks_of_a_sweep, smallest_chunk, steps_of_a_replay);
  return cut;
}

void solve_cases(const SweepFile& sweep, CaseRange cases, const SweepOptions& options,
                 const std::shared_ptr<SequenceFiles>& files, const std::function<bool(SweepCase)>& kept) {
  const std::size_t chunk = cut_of(sweep, options.model, *files).chunk;
  SweepScenes scenes(sweep);
  const Common common{options, files, columns_of_contacts(sweep)};
  bool go_on = true;
  for (CaseRange some{cases.first, 0}; some.first < cases.last && go_on; some.first = some.last) {
    some.last = std::min(cases.last, (some.first / chunk + 1) * chunk);
    Sequence sequence(SequenceOptions{.displacements = options.displacements}, files);
    const auto solve = [&](std::size_t i) { return solve_case(sequence, scenes, i, common); };
    const auto keep = [&](SweepCase one) { return go_on = kept(std::move(one)); };
    if (sweep.replay)
      replay_steps(sweep, some, solve, keep);
    else
      for (std::size_t i = some.first; i < some.last && go_on; ++i)
        keep(solve(i));
  }
}

} // namespace bem_contact
