#include "bem_contact/app/command.hpp"
#include "bem_contact/app/commands/creep_curves_command.hpp"
#include "bem_contact/app/output/output_names.hpp"
#include "bem_contact/app/output/print_answer.hpp"
#include "bem_contact/app/scene_options.hpp"
#include "bem_contact/base/argument_error.hpp"
#include "bem_contact/base/comma_separated.hpp"
#include "bem_contact/base/error.hpp"
#include "bem_contact/record/file_kinds.hpp"
#include "bem_contact/record/hdf5.hpp"
#include "bem_contact/sequence/result_warnings.hpp"
#include "bem_contact/sequence/scene_record.hpp"
#include "bem_contact/uses/fit/fit_curve.hpp"
#include "bem_contact/uses/fit/fit_record.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <memory>
#include <spdlog/spdlog.h>
#include <string>
#include <vector>

namespace bem_contact::app {

namespace {

constexpr const char* fit_help =
    R"(Finds the values of keys of the scene with which the computed forces come closest to the measured ones, by least squares.
The scene's own values are the first guess; the right order of magnitude will do. Columns of the points: a creepage (xi, eta,
phi), a force (Fx, Fs, Mz) and, if it is known, the scatter of the force, by which points are weighted: xi,Fx,scatter. Or a
line of pressures, s,pn or x,pn. Give --measured once for each file.
Example:
    bem_contact fit data/scenes/compliant_layer.toml --measured data/scenes/creep_forces_of_a_locomotive.csv --parameters layer.compliance --model simplified
You should see that layer.compliance is 0.000146 mm3/N, that in 95 of 100 cases it lies between 0.000108 and 0.000225 mm3/N, and that
the points do not measure the slope at zero creepage. Intervals are a bootstrap of the points. More: data/tutorial/fit.md.

Exit code 0: the search ended and all is certified; 2: the input is wrong; 3: no certified result.)";

struct FitArguments {
  std::string scene, model, output;
  std::vector<std::string> measured, parameters;
  bool json = false, strict = false;
};

std::string keys_text(const fit::CurveFit& f) {
  std::string out = fmt::format("  {:28} {:>11} {:>11} {:>11} {:>11}  unit\n", "key", "first guess", "found",
                                "from", "to (95 %)");
  for (const fit::FittedKey& k : f.keys)
    out += fmt::format("  {:28} {:11.4g} {:11.4g} {:11.4g} {:11.4g}  {}{}\n", k.key, k.start, k.value, k.low,
                       k.high, k.unit.empty() ? "1" : k.unit,
                       k.bound == fit::Bound::none ? "" : ", at the end of its range");
  const std::size_t count = f.keys.size();
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t j = 0; j < i; ++j)
      out += fmt::format("  correlation of {} and {}: {:.3f}\n", f.keys[j].key, f.keys[i].key,
                         f.correlation[i * count + j]);
  return out;
}

std::string pressures_text(const fit::MeasuredPressures& m) {
  const bool over_x = m.line == fit::PressureLine::over_x;
  std::string out = fmt::format("pn as measured ({}) and as computed, MPa\n  {:>12} {:>11} {:>11} {:>11}\n",
                                m.source, over_x ? "x, mm" : "s, mm", "measured", "computed", "difference");
  for (std::size_t i = 0; i < m.computed.size(); ++i)
    out += fmt::format("  {:12.5g} {:11.5g} {:11.5g} {:11.4g}\n", over_x ? m.x[i] : m.s[i], m.measured[i],
                       m.computed[i], m.computed[i] - m.measured[i]);
  return out;
}

std::string fit_text(const fit::CurveFit& f, const std::vector<std::string>& files) {
  std::string out =
      fmt::format("Fitted to {} points ({}), model {}; {} sets of values were solved\n", f.measured.points(),
                  fmt::join(files, ", "), name_of(f.solution.choice.model), f.tried);
  out += keys_text(f);
  for (const MeasuredForces& forces : f.measured.forces)
    out += measured_text(forces);
  for (const fit::MeasuredPressures& pressures : f.measured.pressures)
    out += pressures_text(pressures);
  for (const std::string& open : f.undetermined)
    out += open + '\n';
  out += "The scene with these values has\n";
  for (const fit::FittedKey& k : f.keys)
    out += fmt::format("  {} = {:.6g}\n", k.key, k.value);
  return out;
}

void require_points(const FitArguments& arguments) {
  if (arguments.measured.empty())
    throw InputError("There is nothing to fit to", "no measured forces or pressures are named",
                     "Give --measured FILE.csv, or fit.measured in the scene.");
}

std::vector<std::string> keys_of(const FitArguments& arguments) {
  std::vector<std::string> out;
  for (const std::string& list : arguments.parameters)
    for (std::string& key : comma_separated(list))
      out.push_back(std::move(key));
  return out;
}

ExitCode run(const FitArguments& arguments) {
  require_points(arguments);
  const std::vector<Output> outputs{{"--output", arguments.output, OutputForm::whole_file}};
  GivenScene given = read_given_scene_for(outputs, arguments.scene, arguments.model);
  require_named_outputs({arguments.measured.begin(), arguments.measured.end()}, outputs);
  const fit::CurveFit found = fit::fit_curve({.text = given.text,
                                              .changes = {},
                                              .model = given.model,
                                              .measured = fit::read_measured(arguments.measured),
                                              .keys = keys_of(arguments)});
  if (arguments.strict)
    refuse_warnings(found.solution.warnings);
  given.scene = found.scene;
  const record::Record answer = record_of(found);
  if (!arguments.output.empty())
    record::write_hdf5(arguments.output, headed(fit_format, given, arguments.output).append(answer));
  print_answer(headed(fit_format).append(answer), arguments.json, fit_text(found, arguments.measured));
  warn(found.solution.warnings);
  if (certified(found))
    return success;
  spdlog::error(
      "The fit cannot be trusted (the search did not end, or some points have no certified solution) "
      "Fit fewer keys, or begin nearer to what they may be.");
  return no_convergence;
}

} // namespace

Command add_fit(CLI::App& program) {
  const auto arguments = std::make_shared<FitArguments>();
  CLI::App* line = program.add_subcommand("fit", "Keys of a scene, by measured forces and pressures");
  line->add_option("scene", arguments->scene, "Scene file (TOML): the first guess")->required();
  line->add_option("--measured", arguments->measured,
                   "Measured forces (CSV: xi,Fx or xi,Fx,scatter) or pressures (s,pn or x,pn or x,s,pn); "
                   "several may be given")
      ->type_name(file_option)
      ->allow_extra_args(false);
  line->add_option("--parameters", arguments->parameters,
                   "Keys to fit, with commas between: layer.compliance,motion.friction")
      ->allow_extra_args(false);
  add_model(*line, arguments->model);
  add_strict(*line, arguments->strict);
  add_json(*line, arguments->json);
  add_output_option(*line, "-o,--output", arguments->output, "Write all results (HDF5)");
  line->footer(fit_help);
  return {line, [arguments] { return run(*arguments); }};
}

} // namespace bem_contact::app
