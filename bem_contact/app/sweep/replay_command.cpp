#include "bem_contact/app/command.hpp"
#include "bem_contact/app/output/output_names.hpp"
#include "bem_contact/app/sweep/whole_sweep.hpp"
#include "bem_contact/base/argument_error.hpp"
#include "bem_contact/uses/sweep/replay_file.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <memory>

namespace bem_contact::app {

namespace {

constexpr const char* replay_help =
    R"(The run is a CSV file that a vehicle program wrote: names of columns, then a line for each time step. The scene says
what is in its columns, one wheel at a time:
    [replay.columns]                     # key of the scene = column of the run
    time = "t"
    position.lateral = { column = "y_{wheel}", unit = "m" }
    load.force = { column = "Q_{wheel}", unit = "kN" }
    motion.xi = "xi_{wheel}"
    [replay.compare]                     # forces of the run's own contact model, beside ours
    Fx = { column = "Tx_{wheel}", unit = "kN", factor = -1 }
    [replay.wheels]                      # what {wheel} is, and on which side
    "1R" = "right"
    "1L" = "left"
Example:
    bem_contact replay data/scenes/replay.csv data/scenes/replay.toml --wheel 1R -o replay.h5 --csv replay.csv
You should see where the run's own forces differ most from ours, how many steps were solved, and `200 of 200 cases are certified`.
A step is not solved if it lies between two solved ones within --tolerance stated errors. All cores share the steps; if the
command is stopped, call it again. More: data/tutorial/replay.md.

Exit code 0: every step is certified. 2: the input is wrong. 3: a step is missing or not certified.)";

struct ReplayRequest : SweepRequest {
  ReplayAsked asked;
};

ExitCode run(ReplayRequest request) {
  request.more = fmt::format(" wheel {} tolerance {}", request.asked.wheel, request.asked.tolerance);
  return solve_whole_sweep(request, parse_replay(read_scene_text(request.scene), request.asked));
}

} // namespace

Command add_replay(CLI::App& program) {
  const auto request = std::make_shared<ReplayRequest>();
  ReplayRequest& r = *request;
  CLI::App* line = program.add_subcommand("replay", "Solve each step of a vehicle program's run");
  line->add_option("run", r.asked.run, "CSV file of the run: a line for each step")->required();
  line->add_option("scene", r.scene, "Scene file (TOML) with a table [replay.columns]")->required();
  add_output_option(*line, "-o,--output", r.output, "File of all steps (HDF5)")->required();
  add_output_option(*line, "--csv", r.csv,
                    "R.csv: a line for each step; R_patches.csv and R_units.csv as sweep has them");
  line->add_option("--wheel", r.asked.wheel, "Which of [replay.wheels]; its name replaces {wheel}");
  line->add_option("--tolerance", r.asked.tolerance,
                   "Stated errors within which a step may lie between two solved ones; 0: every step that "
                   "differs from the one before is solved")
      ->check(CLI::Range(0.0, 100.0))
      ->capture_default_str();
  add_model(*line, r.model);
  add_strict(*line, r.strict);
  add_jobs(*line, r.jobs);
  line->footer(replay_help);
  return {line, [request] { return run(*request); }};
}

} // namespace bem_contact::app
