#include "bem_contact/app/command.hpp"
#include "bem_contact/app/output/output_names.hpp"
#include "bem_contact/app/output/print_answer.hpp"
#include "bem_contact/base/argument_error.hpp"
#include "bem_contact/base/error.hpp"
#include "bem_contact/record/file_kinds.hpp"
#include "bem_contact/record/hdf5.hpp"
#include "bem_contact/sequence/scene_record.hpp"
#include "bem_contact/sequence/sequence.hpp"
#include "bem_contact/sequence/uncertified.hpp"
#include "bem_contact/uses/shakedown/shakedown_of_result.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <memory>
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
  std::string scene, model, output;
  bool json = false, in_plane = false;
  double alpha = -1; ///< below 0: of dang_van_a
  shakedown::ShakedownProperties properties;
};

std::string text_of(const shakedown::Shakedown& found, const shakedown::ShakedownProperties& properties) {
  std::string out;
  for (std::size_t k = 0; k < found.patches.size(); ++k) {
    const shakedown::PatchShakedown& p = found.patches[k];
    out += fmt::format("patch {} at s = {:.2f} mm, pmax {:.0f} MPa: {}\n", k + 1, p.s, p.pmax,
                       in_words(p, properties));
    out += fmt::format(
        "  Dang Van {:.1f} MPa {:.2f} mm deep (a = {:g}), Crossland {:.1f} MPa {:.2f} mm deep: "
        "compare with the "
        "fatigue limit in torsion\n",
        p.dang_van.value, p.dang_van.depth, properties.dang_van_a, p.crossland.value, p.crossland.depth);
  }
  if (found.patches.empty())
    out += "no contact that is large enough to tell\n";
  else if (found.too_small > 0)
    out += fmt::format("{} more with fewer than four rows or columns of elements\n", found.too_small);
  return out;
}

ExitCode run(ShakedownArguments arguments) {
  shakedown::ShakedownProperties& properties = arguments.properties;
  properties.residual = arguments.in_plane ? shakedown::Residual::in_plane : shakedown::Residual::all;
  if (arguments.alpha >= 0)
    properties.alpha = arguments.alpha;
  validate(properties);
  const GivenScene given = read_given_scene_for({{"--output", arguments.output, OutputForm::whole_file}},
                                                arguments.scene, arguments.model);
  if (given.scene.wheelset.force)
    throw InputError("There is no shakedown of a wheelset", "each of its wheels has its own",
                     "Solve it with bem_contact wheelset, and give one wheel's scene.");
  const SceneResult result = Sequence().solve(given.scene);
  warn(result.warnings);
  if (!certified(result))
    throw ConvergenceError("There is no shakedown of a result that is not certified",
                           why_not_certified(result), "Solve the scene alone to see why.");
  const shakedown::Shakedown found = shakedown_of(result, properties);
  if (!arguments.output.empty())
    record::write_hdf5(
        arguments.output,
        headed(shakedown_format, given, arguments.output).append(record_of(found, properties)));
  print_answer(headed(shakedown_format).append(record_of(found, properties)), arguments.json,
               text_of(found, properties));
  return success;
}

} // namespace

Command add_shakedown(CLI::App& program) {
  const auto arguments = std::make_shared<ShakedownArguments>();
  ShakedownArguments& a = *arguments;
  CLI::App* line = program.add_subcommand("shakedown", "Does the steel yield never, once or for ever?");
  line->add_option("scene", a.scene, "Scene file (TOML)")->required();
  add_model(*line, a.model);
  add_json(*line, a.json);
  add_output_option(*line, "-o,--output", a.output, "Write the same with maps over the section (HDF5)");
  line->add_option("--yield-shear", a.properties.yield_shear, "k, the yield stress in shear, MPa")
      ->check(CLI::Range(1.0, 1e4))
      ->capture_default_str();
  line->add_option("--dang-van", a.properties.dang_van_a,
                   "Dang Van's a, the weight of the hydrostatic stress")
      ->check(CLI::Range(0.0, 3.0))
      ->capture_default_str();
  line->add_option("--crossland", a.alpha, "Crossland's alpha; by default that of a steel with this a")
      ->check(CLI::Range(0.0, 3.0));
  line->add_flag(
      "--in-plane", a.in_plane,
      "Without residual shear along the track, which does not build up where traction changes its direction");
  line->footer(shakedown_help);
  return {line, [arguments] { return run(*arguments); }};
}

} // namespace bem_contact::app
