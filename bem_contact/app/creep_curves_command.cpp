#include "bem_contact/app/creep_curves_command.hpp"

#include "bem_contact/app/creep_curves_output.hpp"
#include "bem_contact/app/number_list.hpp"
#include "bem_contact/app/scene_record.hpp"
#include "bem_contact/base/error.hpp"
#include "bem_contact/base/output_file.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <memory>
#include <nlohmann/json.hpp>
#include <ostream>
#include <spdlog/spdlog.h>

namespace bem_contact::app {

namespace {

constexpr const char* creep_curves_help =
    R"(Each curve varies one creepage; all else is what the scene says, and the wheelset stays where it is. Without a range
there are three curves, from full slip to full slip. A range is FROM:TO:COUNT, as --xi=-0.002:0.002:21 (the = is for a
leading minus), or auto. Example:
    bem_contact creep-curves data/scenes/steady_rolling.toml -o creep.h5
You should see the slopes at zero creepage and spin beside those of Kalker's linear theory for the same ellipse (dFx/dxi
1.7149e+06 and 1.719e+06 N, a difference of -0.24 %), the sensitivities at the scene's creepages (dFx/dxi 6.092e+05 N),
and three tables, with a line for each creepage. To draw them:
    tools/plot creep.h5 -o creep.png

Exit code 0: every certificate holds; 2: the input is wrong; 3: some point has no certified result.)";

struct CreepArguments {
  std::string scene, model, csv, output;
  std::array<std::string, 3> ranges;
  bool json = false;
};

std::vector<CreepRange> ranges_of(const std::array<std::string, 3>& texts) {
  std::vector<CreepRange> out;
  for (const CreepKind kind : {CreepKind::xi, CreepKind::eta, CreepKind::phi})
    if (const std::string& text = texts[static_cast<std::size_t>(kind)]; !text.empty())
      out.push_back(creep_range(kind, text));
  if (out.empty())
    out = {{CreepKind::xi, {}}, {CreepKind::eta, {}}, {CreepKind::phi, {}}};
  return out;
}

ExitCode run(const CreepArguments& arguments) {
  const std::vector<CreepRange> ranges = ranges_of(arguments.ranges);
  const GivenScene given =
      read_given_scene_for({{"--output", arguments.output, OutputForm::whole_file}, {"--csv", arguments.csv}},
                           arguments.scene, arguments.model);
  const CreepCurves curves = creep_curves(given.scene, ranges);
  if (!arguments.output.empty()) {
    H5Table table = to_table(curves);
    add_scene(table, given, arguments.output);
    write_h5(arguments.output, table);
  }
  if (!arguments.csv.empty())
    write_text(arguments.csv, [&](std::ostream& out) { out << to_csv(curves); });
  fmt::print("{}", arguments.json ? to_json(curves).dump(2) + "\n" : to_text(curves));
  warn(curves.solution.warnings);
  if (curves.certified())
    return success;
  spdlog::error(
      "Some points are not solutions (their certificates do not hold) Look at the column `certified`, and "
      "leave these points out or coarsen the grid.");
  return no_convergence;
}

} // namespace

CreepRange creep_range(CreepKind kind, const std::string& text) {
  if (text == "auto")
    return {kind, {}};
  const std::vector<double> numbers = number_list(text, ':').value_or(std::vector<double>());
  const double count = numbers.size() == 3 ? numbers[2] : 0;
  if (!(count >= 2 && count <= 10000 && count == static_cast<int>(count)))
    throw InputError(fmt::format("The range '{}' of {} cannot be read", text,
                                 EnumNames<CreepKind>::names[static_cast<std::size_t>(kind)]),
                     "it is neither auto nor FROM:TO:COUNT with a count of 2 to 10000",
                     "Give one like 0:0.005:21.");
  CreepRange range{kind, {}};
  for (int i = 0; i < count; ++i)
    range.values.push_back(numbers[0] + (numbers[1] - numbers[0]) * i / (count - 1));
  return range;
}

Command add_creep_curves(CLI::App& program) {
  const auto arguments = std::make_shared<CreepArguments>();
  CLI::App* line = program.add_subcommand("creep-curves", "Forces over creepages, slopes and sensitivities");
  line->add_option("scene", arguments->scene, "Scene file (TOML)")->required();
  line->add_option("--xi", arguments->ranges[0],
                   "Range of the longitudinal creepage, as motion.xi counts it");
  line->add_option("--eta", arguments->ranges[1], "Range of the lateral creepage");
  line->add_option("--phi", arguments->ranges[2], "Range of the spin, 1/mm");
  add_model(*line, arguments->model);
  add_json(*line, arguments->json);
  line->add_option("--csv", arguments->csv, "Write all curves, one line for each point");
  line->add_option("-o,--output", arguments->output, "Write all results (HDF5)");
  line->footer(creep_curves_help);
  return {line, [arguments] { return run(*arguments); }};
}

} // namespace bem_contact::app
