#include "fem_influence/harmonic/harmonic_run.hpp"

#include "bem_contact/base/output_file.hpp"
#include "bem_contact/base/stopwatch.hpp"
#include "bem_contact/influence/stress_kernel_file.hpp"
#include "fem_influence/harmonic/harmonic_solver.hpp"
#include "fem_influence/harmonic/machine_system.hpp"
#include "fem_influence/harmonic/run_files.hpp"
#include "fem_influence/harmonic/run_plan.hpp"
#include "fem_influence/harmonic/stress_run.hpp"
#include "fem_influence/harmonic/task_distribution.hpp"
#include "fem_influence/shared/body_description.hpp"
#include "fem_influence/shared/memory.hpp"
#include "fem_influence/shared/parallel.hpp"

#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <utility>

namespace bem_contact::fem {

namespace {

/// 1. One of so many processes begins with the companion, so that the others never mesh it. The companion is
/// a sixth of the work.
constexpr int processes_per_companion = 5;

/// What is given, and must live as long as the run.
struct Input {
  const BodyFile& body;
  const ProfileCurve& curve;
  const std::filesystem::path& mesh;
  const std::filesystem::path& output;
};

/// All processes of the run, and what this one does. Made and destroyed together.
struct Processes {
  explicit Processes(bool companion);

  MachineGroup machine;
  SharedCounters counters;
  bool companion_first = false; ///< this one begins with the companion; the others need no mesh of it at all
  bool machine_shares =
      false;               ///< the first process of this machine assembles the run's matrices for all of it
  bool meshes_run = false; ///< this one meshes the run's section at the start
};

Processes::Processes(bool companion) {
  const int last = std::max(1, process_count() / processes_per_companion);
  const auto begins_with_companion = [&](int rank) {
    return companion && rank > 0 && rank >= process_count() - last;
  };
  companion_first = begins_with_companion(process_rank());
  machine_shares = machine.count() > 1 && !begins_with_companion(machine.first_rank());
  meshes_run = !companion_first && (!machine_shares || machine.rank() == 0);
}

/// A run that is ready to be computed: whatever is wrong with its input has been found.
struct PreparedRun {
  RunPlan plan;
  std::optional<StressPlan> stresses;            ///< if they are asked for
  std::vector<WavenumberTask> tasks;             ///< of the plan's, those still to be done
  std::optional<MeshedSystem> meshed, companion; ///< what this process begins with
  std::size_t cells = 0, unknowns = 0;           ///< of the run's section, where it is meshed
  std::unique_ptr<RunFiles> files;               ///< on the first process
  std::size_t done() const { return plan.tasks.size() - tasks.size(); }
  std::size_t all() const { return plan.tasks.size() + (stresses ? stresses->wavenumber.size() : 0); }
};

MeshedSystem mesh_run(const Input& in, Timing& timing) {
  return {in.body, in.curve, in.mesh, {}, timing};
}

MeshedSystem mesh_companion(const Input& in, const CompanionPlan& plan, Timing& timing) {
  return {plan.body, in.curve, in.mesh, plan.stations, timing};
}

/// Together.
PreparedRun prepare(const Input& in, const Processes& processes, Timing& timing) {
  PreparedRun run;
  std::vector<char> done;
  together([&] {
    output_target(in.output, OutputForm::whole_file);
    run.plan = plan_run(in.body, in.curve);
    if (in.body.stress.depths > 0)
      run.stresses = plan_stresses(in.body, in.curve);
    require_mesh_of(in.body, in.curve, in.mesh);
    // What is wrong with the mesh is found before anything is written.
    if (processes.companion_first)
      run.companion = mesh_companion(in, *run.plan.companion, timing);
    if (processes.meshes_run) {
      run.meshed = mesh_run(in, timing);
      run.cells = run.meshed->system.cells;
      run.unknowns = run.meshed->system.unknowns();
    }
    done.assign(run.plan.tasks.size(), 0);
    if (process_rank() != 0)
      return;
    run.files = std::make_unique<RunFiles>(in.output, fingerprint(in.body, in.curve, in.mesh), run.plan);
    std::transform(run.plan.tasks.begin(), run.plan.tasks.end(), done.begin(),
                   [&](const WavenumberTask& task) { return run.files->has(task); });
  });
  broadcast_from_first(done);
  for (std::size_t t = 0; t < done.size(); ++t)
    if (!done[t])
      run.tasks.push_back(run.plan.tasks[t]);
  return run;
}

/// Together: does all tasks that are left; the first process keeps their results in its files.
void compute(const Input& in, PreparedRun& run, Processes& processes, const RunProgress& progress,
             Timing& timing) {
  const auto second = std::find_if(run.tasks.begin(), run.tasks.end(),
                                   [](const WavenumberTask& task) { return task.companion; });
  std::optional<MachineSystem> machine;
  if (processes.machine_shares && second != run.tasks.begin())
    machine.emplace(processes.machine, std::exchange(run.meshed, std::nullopt), timing);
  SolverOnDemand solver(
      [&] {
        if (machine)
          if (auto assembled = machine->take())
            return *std::move(assembled);
        auto meshed = std::exchange(run.meshed, std::nullopt);
        return add_matrices(meshed ? *std::move(meshed) : mesh_run(in, timing), timing);
      },
      timing);
  SolverOnDemand companion(
      [&] {
        auto meshed = std::exchange(run.companion, std::nullopt);
        return add_matrices(meshed ? *std::move(meshed) : mesh_companion(in, *run.plan.companion, timing),
                            timing);
      },
      timing);
  std::size_t done = run.done();
  distribute(
      processes.counters,
      {.count = run.tasks.size(),
       .second = static_cast<std::size_t>(second - run.tasks.begin()),
       .begins_with_second = processes.companion_first},
      [&](std::size_t t) {
        if (machine)
          machine->require_matrices();
        const WavenumberTask& task = run.tasks[t];
        if (task.companion != processes.companion_first) // this process has done the last of its first kind
          (processes.companion_first ? companion : solver).release();
        return packed((task.companion ? companion : solver).at(run.plan.wavenumber(task)));
      },
      [&](std::size_t t, std::vector<double> numbers) {
        run.files->write(run.tasks[t], std::move(numbers));
        if (progress)
          progress(++done, run.all());
      });
}

std::string method_of(const BodyFile& body, std::size_t cells) {
  return "harmonic, degree " + std::to_string(body.harmonic.degree) + ", " + std::to_string(cells) +
         " quadrilaterals, halved " + std::to_string(body.harmonic.border_levels) +
         " times at the stations' borders";
}

/// On the first process: the influence file from all finished wavenumbers, which are not kept any longer.
void finish(const Input& in, PreparedRun& run, const StressKernel& stresses, RunReport& report) {
  const KernelErrors errors = run.files->take_into(run.plan);
  InfluenceFunction& function = run.plan.function;
  report.betti_error = errors.betti;
  report.reaction_error = errors.reaction;
  report.smallest_eigenvalue = errors.smallest_eigenvalue;
  if (run.plan.companion)
    report.error = estimate_error(function, run.plan.companion->function,
                                  shortest_reference_dx(in.body, function.stations),
                                  error_ratio(in.body.harmonic.degree, in.body.harmonic.border_levels),
                                  in.body.harmonic.samples_per_decade);
  function.method = method_of(in.body, run.cells);
  function.betti_error = report.betti_error;
  function.reaction_error = report.reaction_error;
  function.estimated_error = run.plan.companion ? report.error.total : -1;
  write_influence_file(in.output, function, stresses);
  run.files->remove();
  if (run.stresses)
    std::filesystem::remove(partial_stresses(in.output));
}

} // namespace

RunReport run_harmonic(const BodyFile& body, const ProfileCurve& curve, const std::filesystem::path& mesh,
                       const std::filesystem::path& output, const RunProgress& progress) {
  RunReport report;
  {
    const TimedScope timer(report.seconds);
    const Input in{body, curve, mesh, output};
    const bool first = process_rank() == 0;
    Processes processes(body.harmonic.degree > 1);
    Timing timing;
    PreparedRun run = prepare(in, processes, timing);
    if (first && progress)
      progress(run.done(), run.all());
    compute(in, run, processes, progress, timing);
    StressKernel stresses;
    if (run.stresses)
      stresses = run_stresses(*run.stresses, curve, mesh, output, fingerprint(body, curve, mesh),
                              [&](std::size_t done) {
                                if (progress)
                                  progress(run.plan.tasks.size() + done, run.all());
                              });
    report.cells = run.cells;
    report.unknowns = run.unknowns;
    report.stations = run.plan.function.station_count();
    report.wavenumbers = run.plan.function.wavenumber_count();
    report.companion_wavenumbers = run.plan.tasks.size() - report.wavenumbers;
    report.resumed = run.done();
    report.timing = {sum_of_all(timing.assembly), sum_of_all(timing.analysis),
                     sum_of_all(timing.factorization)};
    together([&] {
      if (first)
        finish(in, run, stresses, report);
    });
    report.peak_memory = largest_of_all(peak_memory());
  }
  return report;
}

} // namespace bem_contact::fem
