#include "bem_contact/app/command.hpp"
#include "bem_contact/app/output/output_names.hpp"
#include "bem_contact/app/output/print_answer.hpp"
#include "bem_contact/app/output/repeat.hpp"
#include "bem_contact/app/scene_options.hpp"
#include "bem_contact/base/argument_error.hpp"
#include "bem_contact/base/error.hpp"
#include "bem_contact/base/input_file.hpp"
#include "bem_contact/record/file_kinds.hpp"
#include "bem_contact/record/hdf5.hpp"
#include "bem_contact/scene/derivative_inputs.hpp"
#include "bem_contact/scene/sweep_check.hpp"
#include "bem_contact/sequence/scene_record.hpp"
#include "bem_contact/sequence/sequence.hpp"
#include "bem_contact/sequence/uncertified.hpp"
#include "bem_contact/task/engine.hpp"
#include "bem_contact/uses/shakedown/collective.hpp"
#include "bem_contact/uses/shakedown/shakedown_in_body.hpp"
#include "bem_contact/uses/sweep/sweep_inputs.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <fmt/format.h>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>

namespace bem_contact::app {

namespace {

constexpr const char* shakedown_help =
    R"(The scene is solved. Then it passes over the rail again and again: below each patch the program asks whether the
steel yields never, once (residual stresses keep it elastic afterwards) or for ever, and how large a load would shake
down. Lower and upper bound are both computed. Dang Van's and Crossland's stresses tell about fatigue. Example:
    bem_contact shakedown data/scenes/steady_rolling.toml --yield-shear 150
You should see that the patch yields once, with a shakedown factor of 1.14, and a line with its stresses.

What stands behind it, and maps over the section: data/tutorial/shakedown.md.)";

struct ShakedownArguments {
  std::string scene, model, output, steel, initial_stress, body;
  bool json = false, in_plane = false;
  std::optional<double> yield_shear, dang_van_a, alpha, fatigue_limit; ///< nothing: of the steel, or usual

  shakedown::ShakedownProperties properties() const {
    shakedown::ShakedownProperties out =
        steel.empty() ? shakedown::ShakedownProperties{} : shakedown::properties_of(steel);
    out.residual = in_plane ? shakedown::Residual::in_plane : shakedown::Residual::all;
    out.yield_shear = yield_shear.value_or(out.yield_shear);
    out.dang_van_a = dang_van_a.value_or(out.dang_van_a);
    out.alpha = alpha;
    if (fatigue_limit)
      out.fatigue_limit = fatigue_limit;
    if (!initial_stress.empty())
      out.initial = shakedown::read_initial_stress(initial_stress);
    validate(out);
    return out;
  }
};

std::string text_of(const shakedown::Shakedown& found, const shakedown::ShakedownProperties& properties) {
  std::string out;
  for (std::size_t k = 0; k < found.patches.size(); ++k) {
    const shakedown::PatchShakedown& p = found.patches[k];
    const std::string words = found.patches.size() > 1 ? ": " + in_words(p, properties) : ""; // of one: above
    out += fmt::format("patch {} at s = {:.2f} mm, pmax {:.0f} MPa{}\n", k + 1, p.s, p.pmax, words);
    out += fmt::format(
        "  Dang Van {:.1f} MPa {:.2f} mm deep (a = {:g}), Crossland {:.1f} MPa {:.2f} mm deep: {}\n",
        p.dang_van.value, p.dang_van.depth, properties.dang_van_a, p.crossland.value, p.crossland.depth,
        fatigue_in_words(p, properties));
  }
  if (found.patches.empty())
    out += "no contact that is large enough to tell\n";
  else if (found.too_small > 0)
    out += fmt::format("{} more with fewer than four rows or columns of elements\n", found.too_small);
  return out;
}

/// What was found says all of a collective.
std::string text_of(const shakedown::CollectiveShakedown&, const shakedown::ShakedownProperties&) {
  return "";
}

Output output_of(const ShakedownArguments& arguments) {
  return {"--output", arguments.output, OutputForm::whole_file};
}

/// Neither the initial stress nor the body is overwritten.
void require_output_beside(const ShakedownArguments& arguments) {
  require_named_outputs({arguments.initial_stress, arguments.body}, {output_of(arguments)});
}

/// Writes, prints, or both. `head`: of a file.
template <class Found>
void say(const Found& found, const shakedown::ShakedownProperties& properties,
         const ShakedownArguments& arguments, const std::function<record::Record()>& head) {
  if (!arguments.output.empty())
    record::write_hdf5(arguments.output, head().append(record_of(found, properties)));
  print_answer(headed(shakedown_format).append(record_of(found, properties)), arguments.json,
               text_of(found, properties));
}

/// Of stresses that a file holds: of the real body where it has them.
void of_stresses(const ShakedownArguments& arguments) {
  require_named_outputs({arguments.scene}, {output_of(arguments)});
  const record::Record file = record::read_hdf5(arguments.scene);
  if (!arguments.body.empty())
    throw InputError("--body belongs to a scene", "the stresses of this file are computed already",
                     "Leave it out.");
  if (!arguments.model.empty())
    throw InputError("--model belongs to a scene", "the stresses of this file are computed already",
                     "Leave it out.");
  const shakedown::ShakedownProperties properties = arguments.properties();
  say(shakedown_of(inside::stresses_from(file), properties), properties, arguments,
      [] { return headed(shakedown_format); });
}

/// Of all cases of a load collective.
void of_sweep(const ShakedownArguments& arguments, const SceneText& text) {
  const SweepFile sweep = parse_sweep_file(text);
  if (!arguments.model.empty())
    throw InputError("--model belongs to one scene", "a sweep names the model of its cases",
                     "Give solver.model.");
  check_values(sweep);
  require_named_outputs(files_read(arguments.scene, sweep), {output_of(arguments)});
  const shakedown::ShakedownProperties properties = arguments.properties();
  const int threads = static_cast<int>(task::processes_of(0));
  const auto head = [&] { return headed(shakedown_format, given_sweep(sweep, ""), arguments.output); };
  if (arguments.body.empty())
    return say(shakedown_of(sweep, properties, threads), properties, arguments, head);
  const auto in_body = [&](std::span<const SceneResult> results) {
    return shakedown_in_body(results, arguments.body, properties, threads);
  };
  say(shakedown_of(sweep, properties, in_body, shakedown::most_cases_in_body), properties, arguments, head);
}

void of_scene(const ShakedownArguments& arguments) {
  const shakedown::ShakedownProperties properties = arguments.properties();
  const GivenScene given = read_given_scene_for({output_of(arguments)}, arguments.scene, arguments.model);
  if (given.scene.wheelset.force)
    throw InputError("There is no shakedown of a wheelset", "each of its wheels has its own",
                     "Solve it with bem_contact wheelset, and give one wheel's scene.");
  refuse_derivatives(given.scene, "shakedown");
  const SceneResult result = Sequence().solve(given.scene);
  warn(result.warnings);
  if (!certified(result))
    throw ConvergenceError("There is no shakedown of a result that is not certified",
                           why_not_certified(result), "Solve the scene alone to see why.");
  const auto head = [&] { return headed(shakedown_format, given, arguments.output); };
  if (arguments.body.empty())
    return say(shakedown_of(result, properties), properties, arguments, head);
  say(shakedown_in_body({&result, 1}, arguments.body, properties).front(), properties, arguments, head);
}

ExitCode run(const ShakedownArguments& arguments) {
  if (!arguments.initial_stress.empty() || !arguments.body.empty())
    require_output_beside(arguments);
  if (!is_regular(arguments.scene)) { // a pipe can be read but once
    of_scene(arguments);
  } else if (is_hdf5(arguments.scene)) {
    of_stresses(arguments);
  } else if (const SceneText text = read_scene_text(arguments.scene); has_sweep(text)) {
    of_sweep(arguments, text);
  } else {
    of_scene(arguments);
  }
  return success;
}

} // namespace

Command add_shakedown(CLI::App& program) {
  const auto arguments = std::make_shared<ShakedownArguments>();
  ShakedownArguments& a = *arguments;
  CLI::App* line = program.add_subcommand("shakedown", "Does the steel yield never, once or for ever?");
  line->add_option(
          "scene", a.scene,
          "Scene file (TOML), perhaps with [sweep]; or stresses (HDF5) of fem_influence or bem_contact "
          "stresses")
      ->required();
  add_model(*line, a.model);
  add_json(*line, a.json);
  add_output_option(*line, "-o,--output", a.output, "Write the same with maps over the section (HDF5)");
  line->add_option(
      "--steel", a.steel,
      "Of rails R200 to R400HT (EN 13674-1), of wheels ER6 to ER9 (EN 13262): their fatigue limit, "
      "estimated, Dang Van's a, and k of wheels");
  line->add_option("--yield-shear", a.yield_shear, "k, the yield stress in shear, MPa; by default 300")
      ->check(CLI::Range(1.0, 1e4));
  line->add_option("--fatigue-limit", a.fatigue_limit, "In torsion, MPa, for Dang Van's stress")
      ->check(CLI::Range(1.0, 1e4));
  line->add_option("--dang-van", a.dang_van_a,
                   "Dang Van's a, the weight of the hydrostatic stress; by default 0.4")
      ->check(CLI::Range(0.0, 3.0));
  line->add_option("--crossland", a.alpha, "Crossland's alpha; by default that of a steel with this a")
      ->check(CLI::Range(0.0, 3.0));
  line->add_option("--initial-stress", a.initial_stress,
                   "Residual and thermal stress of the body (CSV: depth, perhaps s, mm; any of "
                   "xx,ss,nn,xs,xn,sn, MPa)")
      ->type_name(file_option);
  line->add_option("--body", a.body,
                   "Influence file (HDF5) with stresses, or body file (TOML, by mesh_body and "
                   "fem_influence), of the rail "
                   "or the wheel: with the stresses in it, not in a half-space")
      ->type_name(file_option);
  line->add_flag(
      "--in-plane", a.in_plane,
      "Without residual shear along the track, which does not build up where traction changes its direction");
  line->footer(shakedown_help);
  return {line, [arguments] { return run(*arguments); }};
}

} // namespace bem_contact::app
