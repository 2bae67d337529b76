#include "bem_contact/app/command.hpp"
#include "bem_contact/app/scene_options.hpp"
#include "bem_contact/app/wear/one_contact.hpp"
#include "bem_contact/app/wear/wear_influence.hpp"
#include "bem_contact/app/wear/wear_state.hpp"
#include "bem_contact/base/argument_error.hpp"
#include "bem_contact/base/counted.hpp"
#include "bem_contact/base/error.hpp"
#include "bem_contact/base/file_lock.hpp"
#include "bem_contact/base/output_folder.hpp"
#include "bem_contact/base/printable.hpp"
#include "bem_contact/base/progress.hpp"
#include "bem_contact/base/stopwatch.hpp"
#include "bem_contact/record/error_text.hpp"
#include "bem_contact/record/found.hpp"
#include "bem_contact/scene/settings.hpp"
#include "bem_contact/scene/sweep_check.hpp"
#include "bem_contact/task/tasks.hpp"
#include "bem_contact/uses/sweep/sweep_inputs.hpp"
#include "bem_contact/uses/wear/study.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <memory>

namespace bem_contact::app {

namespace {

/// 1. More than this of the depth at the deepest place taken by smoothing is a warning.
constexpr double most_smoothed_off = 0.02;

constexpr const char* wear_help =
    R"(The table [sweep] of the scene is the load collective; sweep.weight says how often each case occurs:
    [sweep]
    mode = "zip"
    position.lateral = [ 0.0, 2.0, 5.0 ]
    weight           = [ 6, 3, 1 ]
All cases are solved with the profiles as they are. Then wear moves the profiles by --cap at the deepest place. This is
repeated until --depth is reached. Example:
    bem_contact wear data/scenes/wear_collective.toml -o worn --depth 0.2
You should see one line for each step. The folder has the profiles of each step (rail_0001.txt, wheel_0001.txt), wear.csv
and wear.h5. If the program is stopped, give the same command again: it goes on after the last finished step.
With --jobs several processes share the cases of a step; then chunks of cases start cold, and the wear is the same within the
certificate, whatever the number of processes.

On a rail of sections (a crossing, a blade) the collective is a passage along the track ([passage]): each section wears by what
passes beside it. Then the folder has the profiles of all sections, stretch.csv, and the scene of each step (scene_0001.toml). Example:
    bem_contact new --crossing 9 --wheel S1002 --rail 60E1 -o crossing.toml && bem_contact wear crossing.toml -o worn --depth 0.05

A scene without [sweep] is one contact, or both wheels of a wheelset. What it wears away is printed, by km of the wheel and by
a million axles and a million gross tonnes (MGT) on the rail; the profiles stay. Example:
    bem_contact wear data/scenes/curved_track.toml

More: data/tutorial/wear.md. The collective as a CSV file (sweep.table), and a wear map of your own ([wear], for archard):
data/scenes/README.md.)";

struct WearArguments {
  std::string scene, output, model, influence;
  bool json = false;
  int jobs = 1;
  wear::StudyOptions study;

  /// All that the result depends on but the cases, --depth and --influence: a run may go deeper later.
  std::string digest_text(const SceneFile::Wear& map) const {
    const wear::EvolutionOptions& steps = study.steps;
    return fmt::format("wear 2 {} {} {} {} {} {} {} {} {} {} {} {}", model, study.law, study.body,
                       study.hardness, study.speed, steps.cap, steps.smoothing, steps.passages,
                       steps.kept_turn, fmt::join(map.speeds, ","), fmt::join(map.pressures, ","),
                       fmt::join(map.coefficients, ","));
  }
};

void print_step(const wear::WearRow& row) {
  print_out("step {:g}: {:.4g} km, rail {:.4f} mm deep, {:.4f} mm2; wheel {:.4f} mm deep, {:.4f} mm2; "
            "smoothed at {:.2f} mm, {:.1f} % off the deepest place\n",
            row.step, row.mileage, row.rail_depth, row.rail_area, row.wheel_depth, row.wheel_area,
            row.smoothing, 100 * row.smoothed_off);
  std::fflush(stdout);
}

void warn_of_smoothing(const std::vector<wear::WearRow>& history) {
  const double most = std::ranges::max(history, {}, &wear::WearRow::smoothed_off).smoothed_off;
  if (most > most_smoothed_off)
    warn({fmt::format("smoothing took up to {:.1f} % of the depth at the deepest place of a step: give a "
                      "smaller --smoothing, and a smaller --cap with it",
                      100 * most)});
}

bool is_file_of_one_contact(const std::filesystem::path& output) {
  return output.extension() == ".h5";
}

/// Refuses a folder for one contact, and a study without one.
void require_folder(const WearArguments& arguments, bool study) {
  if (study && arguments.output.empty())
    throw InputError("A wear study needs a folder",
                     "the scene has a table [sweep], and --output is not given",
                     "Give -o FOLDER, or a scene without [sweep] for the wear of one contact.");
  if (study && arguments.json)
    throw InputError("A wear study has no --json", "its tables are wear.csv and wear.h5 in the folder",
                     "Leave it out.");
  if (!study && !arguments.output.empty() && !is_file_of_one_contact(arguments.output))
    throw InputError("There is no wear study", "the scene has no table [sweep] with a load collective",
                     "Give one, or a result file (-o FILE.h5) for the wear of one contact.");
}

ExitCode study(const WearArguments& arguments, const SceneText& scene);

ExitCode run(const WearArguments& arguments) {
  const SceneText scene = read_scene_text(arguments.scene);
  const bool is_study = has_sweep(scene);
  require_repeated_program(scene, "wear", "influence", arguments.influence);
  require_folder(arguments, is_study);
  if (arguments.study.law == "archard" && arguments.study.speed < least_speed)
    warn({fmt::format("--speed {:g} mm/s is below walking pace: give it in mm/s", arguments.study.speed)});
  return is_study ? study(arguments, scene)
                  : wear_of_one_contact({arguments.scene, arguments.model, arguments.output, arguments.json,
                                         arguments.study});
}

ExitCode study(const WearArguments& arguments, const SceneText& scene) {
  const SweepFile sweep = parse_sweep_file(scene);
  check_values(sweep);
  wear::Study study = wear::study_of(sweep, arguments.model, arguments.study);
  const std::string digest = digest_of(sweep, arguments.digest_text(study.scene().wear));
  const std::filesystem::path folder = arguments.output;
  OutputFolder made(folder, {.maker = wear_maker, .inputs = files_read(arguments.scene, sweep)});
  if (arguments.jobs != 1)
    study.options.solve =
        task::wear_by(task::in_children(arguments.jobs), sweep, arguments.model, arguments.study);
  const LockFile lock(folder / lock_file_name, "Wait for it, or give another folder.");
  if (!lock.warning().empty())
    warn({lock.warning()});
  const wear::WornPair unworn = wear::unworn(study.scene());
  WearState state = read_wear(made, digest, unworn).value_or(WearState{});
  WearInfluence influence(study.scene(), unworn, folder, arguments.influence);
  const Stopwatch watch;
  const auto keep = [&](const wear::WornPair& pair) {
    state.pair = pair;
    state.history.push_back(wear::history_row(state.step() + 1, pair, study.scene().position.wheel_radius));
    write_wear(made, digest, scene, state);
  };
  if (state.history.empty())
    keep(unworn);
  else
    print_out("continued after step {}\n", state.step());
  const int before = state.step();
  wear::evolve(
      study, state.pair, folder,
      [&](const wear::WornPair& pair) { return influence.at(state.step(), pair, study.options.kept_turn); },
      [&](const wear::WornPair& pair) {
        keep(pair);
        print_step(state.history.back());
      });
  warn_of_smoothing(state.history);
  const int steps = state.step() - before;
  print_out("{}", record::found_text(record_of(state, digest)));
  print_out("{}, {}, {}\n", counted(steps, "step", "steps"),
            counted(steps * study.cases.size(), "contact problem", "contact problems"),
            duration_text(watch.seconds()));
  return success;
}

} // namespace

Command add_wear(CLI::App& program) {
  const auto arguments = std::make_shared<WearArguments>();
  WearArguments& a = *arguments;
  CLI::App* line = program.add_subcommand(
      "wear", "Let profiles wear under a load collective, or what one contact wears away");
  line->add_option("scene", a.scene, "Scene file (TOML); with a table [sweep]: a study")->required();
  add_output_option(
      *line, "-o,--output", a.output,
      "Folder of the profiles and tables of a study: a new or empty one, or one to go on in; of "
      "one contact a result file (.h5)");
  add_json(*line, a.json);
  const CLI::Range positive(1e-6, 1e6);
  const auto number = [&](const char* name, double& value, const char* what) {
    line->add_option(name, value, what)->check(positive)->capture_default_str();
  };
  number("--depth", a.study.depth, "End when this depth is worn off at the deepest place, mm");
  number("--cap", a.study.steps.cap, "Largest depth of one step, mm");
  number("--smoothing", a.study.steps.smoothing, "Shortest wavelength of the wear of a step, mm");
  number("--passages", a.study.steps.passages,
         "Wheels that pass a place of the rail while one wheel turns once");
  number("--kept-turn", a.study.steps.kept_turn,
         "Influence functions are kept until a surface has turned by this, rad");
  number("--hardness", a.study.hardness, "Hardness of the softer body, for archard, MPa");
  number("--speed", a.study.speed, "Rolling speed, for archard, mm/s");
  line->add_option(
          "--influence", a.influence,
          "Program that computes new influence functions where they are needed, such as tools/influence: "
          "called with a body file and the file to write")
      ->configurable(false); // require_repeated_program()
  add_model(*line, a.model);
  add_jobs(*line, a.jobs);
  line->add_option("--law", a.study.law, "Wear law; energy: T-gamma")
      ->check(CLI::IsMember(wear::law_names))
      ->capture_default_str();
  line->add_option("--body", a.study.body, "Which body wears")
      ->check(CLI::IsMember(wear::body_names))
      ->capture_default_str();
  line->footer(wear_help);
  return {line, [arguments] { return run(*arguments); }};
}

} // namespace bem_contact::app
