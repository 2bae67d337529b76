#include "bem_contact/app/command.hpp"
#include "bem_contact/app/output/output_names.hpp"
#include "bem_contact/app/output/print_answer.hpp"
#include "bem_contact/base/argument_error.hpp"
#include "bem_contact/base/error.hpp"
#include "bem_contact/base/output_file.hpp"
#include "bem_contact/inside/stresses_in_body.hpp"
#include "bem_contact/record/file_kinds.hpp"
#include "bem_contact/record/hdf5.hpp"
#include "bem_contact/sequence/scene_record.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <memory>
#include <ostream>
#include <string>

namespace bem_contact::app {

namespace {

constexpr const char* stresses_help =
    R"(Takes a result of bem_contact solve -o, and computes the stresses of a half-space below each patch while it passes. Or takes
what fem_influence --stresses wrote, which has those of the real body beside them. Example:
    bem_contact solve data/scenes/steady_rolling.toml -o rolling.h5
    bem_contact stresses rolling.h5
You should see a line for the patch: its largest von Mises and shear stress, and how deep they lie.

With --body they are those of the real rail or wheel, beside the half-space's. What to do with them:
data/tutorial/stresses.md.)";

struct StressesArguments {
  std::string file, points, body, output, csv, vtu;
  bool wheel = false, json = false;
};

inside::StressesInside stresses_of(const StressesArguments& arguments) {
  const record::Record file = record::read_hdf5(arguments.file);
  const auto format = record::text_at(file, "format").value_or("");
  if (kind_name(format) == kind_name(stresses_format)) {
    if (arguments.wheel || !arguments.points.empty() || !arguments.body.empty())
      throw InputError("--wheel, --points and --body belong to a result", "this file has its points already",
                       "Leave them out, or give the result.");
    return inside::stresses_from(file);
  }
  if (!arguments.body.empty()) {
    if (arguments.wheel)
      throw InputError("--wheel cannot be given with --body",
                       "the body's profile says which of the two it is", "Leave it out.");
    return inside::stresses_in_body(arguments.file, arguments.body, arguments.points);
  }
  const inside::Side side = arguments.wheel ? inside::Side::wheel : inside::Side::rail;
  const std::vector<inside::BelowSurface> own = arguments.points.empty()
                                                    ? std::vector<inside::BelowSurface>{}
                                                    : inside::read_points_below(arguments.points);
  inside::StressesInside out = inside::halfspace_inside(inside::read_tractions(file, side), side, own);
  out.traction_error = inside::traction_error(file);
  return out;
}

std::string text_of(const inside::StressesInside& stresses) {
  std::string out;
  for (std::size_t k = 0; k < stresses.areas.size(); ++k) {
    const inside::AreaStresses& area = stresses.areas[k];
    out += fmt::format("{} {} of the {}: {}\n", area.section ? "patch" : "points", k + 1,
                       name_of(stresses.side), in_words(stresses, area));
  }
  if (stresses.areas.empty())
    out += "no contact that is large enough to tell\n";
  else if (stresses.too_small > 0)
    out += fmt::format("{} more with fewer than four rows or columns of elements\n", stresses.too_small);
  return out;
}

ExitCode run(const StressesArguments& a) {
  require_named_outputs({a.file, a.points, a.body}, {{"--output", a.output, OutputForm::whole_file},
                                                     {"--csv", a.csv, OutputForm::text},
                                                     {"--vtu", a.vtu, OutputForm::text}});
  const inside::StressesInside stresses = stresses_of(a);
  const record::Record answer = headed(stresses_format).append(record_of(stresses));
  if (!a.output.empty())
    record::write_hdf5(a.output, answer);
  if (!a.csv.empty())
    write_text(a.csv, [&](std::ostream& out) { write_csv(out, stresses); });
  if (!a.vtu.empty())
    write_text(a.vtu, [&](std::ostream& out) { write_vtu(out, stresses); });
  print_answer(answer, a.json, text_of(stresses));
  return success;
}

} // namespace

Command add_stresses(CLI::App& program) {
  const auto arguments = std::make_shared<StressesArguments>();
  StressesArguments& a = *arguments;
  CLI::App* line = program.add_subcommand("stresses", "Which stresses are inside wheel and rail?");
  line->add_option("file", a.file, "Result of bem_contact solve -o, or stresses of fem_influence (HDF5)")
      ->required();
  line->add_flag("--wheel", a.wheel, "Of the wheel in place of the rail");
  line->add_option("--body", a.body,
                   "Influence file (HDF5) with stresses, or body file (TOML, by mesh_body and "
                   "fem_influence), of the rail or "
                   "the wheel: stresses in it, not in a half-space");
  line->add_option("--points", a.points, "Points of your own: a CSV file with s,depth (mm)");
  add_json(*line, a.json);
  add_output_option(*line, "-o,--output", a.output, "Write all tensors (HDF5)");
  add_output_option(*line, "--csv", a.csv, "Write all tensors as a table");
  add_output_option(*line, "--vtu", a.vtu, "Write them for ParaView (.vtu)");
  line->footer(stresses_help);
  return {line, [arguments] { return run(*arguments); }};
}

} // namespace bem_contact::app
