#include "bem_contact/app/command.hpp"
#include "bem_contact/app/output/error_text.hpp"
#include "bem_contact/app/sweep/sweep_inputs.hpp"
#include "bem_contact/app/wear/wear_influence.hpp"
#include "bem_contact/app/wear/wear_state.hpp"
#include "bem_contact/base/error.hpp"
#include "bem_contact/base/progress.hpp"
#include "bem_contact/base/stopwatch.hpp"
#include "bem_contact/scene/settings.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <memory>

namespace bem_contact::app {

namespace {

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

More: data/tutorial/wear.md. The collective as a CSV file (sweep.table), and a wear map of your own ([wear], for archard):
data/scenes/README.md.)";

struct WearArguments {
  std::string scene, output, model, law = "energy", body = "both", influence;
  double depth = 0.1, hardness = 3000, speed = 3e4;
  wear::EvolutionOptions options;

  /// All that the result depends on but --depth and --influence: a run may go deeper later.
  std::string digest_text() const {
    return fmt::format("wear {} {} {} {} {} {} {} {} {}", model, law, body, hardness, speed, options.cap,
                       options.smoothing, options.passages, options.kept_turn);
  }
};

wear::EvolutionOptions options_of(const WearArguments& a, const std::optional<wear::WearMap>& map) {
  wear::EvolutionOptions out = a.options;
  out.law = wear::law_named(a.law, a.hardness, a.speed, map);
  out.rail = a.body != "wheel";
  out.wheel = a.body != "rail";
  return out;
}

ExitCode run(const WearArguments& arguments) {
  const SweepFile sweep = read_sweep_file(arguments.scene);
  check_values(sweep);
  const std::vector<wear::CollectiveCase> cases = wear::collective_of(sweep, arguments.model);
  const wear::EvolutionOptions options = options_of(arguments, wear::wear_map_of(cases.front().scene));
  wear::validate(cases, options, arguments.depth);
  if (arguments.law == "archard" && arguments.speed < least_speed)
    warn({fmt::format("--speed {:g} mm/s is below walking pace: give it in mm/s", arguments.speed)});
  const std::string digest = digest_of(sweep, arguments.digest_text());
  const std::filesystem::path folder = arguments.output;
  std::error_code failed;
  std::filesystem::create_directories(folder, failed);
  if (failed)
    throw InputError(fmt::format("The folder '{}' cannot be made", folder.string()), failed.message(),
                     "Give another one.");
  const SceneFile& first = cases.front().scene;
  const wear::WornPair unworn = wear::unworn(first);
  WearState state = read_wear(folder, digest).value_or(WearState{0, unworn, {}});
  WearInfluence influence(first, unworn, folder, arguments.influence);
  const Stopwatch watch;
  if (state.history.empty()) {
    state.history.push_back(wear::history_row(0, state.pair, first.position.wheel_radius));
    write_wear(folder, digest, state);
  } else
    fmt::print("continued after step {}\n", state.step);
  const int before = state.step;
  while (state.pair.largest() < arguments.depth * (1 - 1e-9)) {
    state.pair = wear::wear_step(state.pair, cases, options, arguments.depth, folder,
                                 influence.at(state.step, state.pair, options.kept_turn));
    state.history.push_back(wear::history_row(++state.step, state.pair, first.position.wheel_radius));
    write_wear(folder, digest, state);
    const wear::WearRow& row = state.history.back();
    fmt::print("step {}: {:.4g} km, rail {:.4f} mm deep, {:.4f} mm2; wheel {:.4f} mm deep, {:.4f} mm2\n",
               state.step, row.mileage, row.rail_depth, row.rail_area, row.wheel_depth, row.wheel_area);
    std::fflush(stdout);
  }
  const int steps = state.step - before;
  fmt::print("{}, {}, {}\n", counted(steps, "step", "steps"),
             counted(steps * static_cast<int>(cases.size()), "contact problem", "contact problems"),
             duration_text(watch.seconds()));
  return success;
}

} // namespace

Command add_wear(CLI::App& program) {
  const auto arguments = std::make_shared<WearArguments>();
  WearArguments& a = *arguments;
  CLI::App* line = program.add_subcommand("wear", "Let profiles wear under a load collective");
  line->add_option("scene", a.scene, "Scene file (TOML) with a table [sweep]")->required();
  line->add_option("-o,--output", a.output,
                   "Folder of the profiles and tables: a new or empty one, or one to go on in")
      ->required();
  const CLI::Range positive(1e-6, 1e6);
  const auto number = [&](const char* name, double& value, const char* what) {
    line->add_option(name, value, what)->check(positive)->capture_default_str();
  };
  number("--depth", a.depth, "End when this depth is worn off at the deepest place, mm");
  number("--cap", a.options.cap, "Largest depth of one step, mm");
  number("--smoothing", a.options.smoothing, "Shortest wavelength of the wear of a step, mm");
  number("--passages", a.options.passages, "Wheels that pass a place of the rail while one wheel turns once");
  number("--kept-turn", a.options.kept_turn,
         "Influence functions are kept until a surface has turned by this, rad");
  number("--hardness", a.hardness, "Hardness of the softer body, for archard, MPa");
  number("--speed", a.speed, "Rolling speed, for archard, mm/s");
  line->add_option(
      "--influence", a.influence,
      "Program that computes new influence functions where they are needed, such as tools/influence: "
      "called with a body file and the file to write");
  add_model(*line, a.model);
  line->add_option("--law", a.law, "Wear law; energy: T-gamma")
      ->check(CLI::IsMember(wear::law_names))
      ->capture_default_str();
  line->add_option("--body", a.body, "Which body wears")
      ->check(CLI::IsMember({"both", "rail", "wheel"}))
      ->capture_default_str();
  line->footer(wear_help);
  return {line, [arguments] { return run(*arguments); }};
}

} // namespace bem_contact::app
