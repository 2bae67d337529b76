#include "bem_contact/app/commands/creep_curves_command.hpp"

#include "bem_contact/app/number_list.hpp"
#include "bem_contact/app/output/output_names.hpp"
#include "bem_contact/app/output/print_answer.hpp"
#include "bem_contact/base/argument_error.hpp"
#include "bem_contact/base/error.hpp"
#include "bem_contact/base/output_file.hpp"
#include "bem_contact/record/csv.hpp"
#include "bem_contact/record/file_kinds.hpp"
#include "bem_contact/record/hdf5.hpp"
#include "bem_contact/sequence/models.hpp"
#include "bem_contact/sequence/result_warnings.hpp"
#include "bem_contact/sequence/scene_record.hpp"
#include "bem_contact/task/tasks.hpp"
#include "bem_contact/uses/curves/creep_record.hpp"
#include "bem_contact/uses/curves/measured_forces.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <memory>
#include <optional>
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
1.7163e+06 and 1.719e+06 N, a difference of -0.15 %), the sensitivities at the scene's creepages (dFx/dxi 6.093e+05 N),
and three tables, with a line for each creepage. With --jobs several processes share the points; then chunks of points start
cold, and the forces are the same within the certificate, whatever the number of processes. More, and how to draw them: data/tutorial/creep-curves.md.

--measured POINTS.csv puts forces that were measured beside those that are computed at the same creepages. Its columns are a
creepage, a force (N) and, if it is known, the scatter of the force: xi,Fx,scatter. Text, result file, page and picture have them.

Exit code 0: every certificate holds; 2: the input is wrong; 3: some point has no certified result.)";

struct CreepArguments {
  std::string scene, model, csv, output, measured;
  std::array<std::string, 3> ranges;
  bool json = false, strict = false;
  int jobs = 1;
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

/// The derivatives that linear theory does not set to zero: [force][creepage].
constexpr std::pair<std::size_t, std::size_t> in_linear_theory[] = {{0, 0}, {1, 1}, {1, 2}, {2, 1}, {2, 2}};

std::string slopes_text(const CreepCurves& c) {
  std::string out =
      "Slopes where nothing moves over the other (no creepage, no spin), beside Kalker's linear theory\n";
  if (c.linear)
    out += fmt::format(
        "  for the ellipse of {:.4g} x {:.4g} mm (semi-axes along x, s), from which the undeformed distance "
        "is {:.1f} % off\n",
        c.linear->semi_axis_x, c.linear->semi_axis_s, 100 * c.linear->deviation);
  else
    out += "  (the contact is no ellipse: nothing to compare with)\n";
  out += "               computed     error      Kalker   difference\n";
  for (const auto& [f, k] : in_linear_theory) {
    const double value = c.slopes.values[f][k];
    const std::string what =
        fmt::format("d{}/d{}", EnumNames<CreepForce>::names[f], EnumNames<CreepKind>::names[k]);
    out += fmt::format("  {:9} {:12.5g} {:9.1g}", what, value, c.slopes.errors[f][k]);
    if (c.linear)
      out += fmt::format(" {:11.5g} {:10.2f} %", c.linear->slopes[f][k],
                         100 * (value / c.linear->slopes[f][k] - 1));
    out += '\n';
  }
  return out;
}

std::string sensitivities_text(const CreepCurves& c) {
  std::string out = fmt::format("Sensitivities at the scene's creepages, {}\n              force      d/dxi  "
                                "   d/deta     d/dphi\n",
                                c.sensitivities.by_differences ? "by differences" : "by its derivatives");
  const MeasuredCreepForces forces = forces_of(c.solution);
  for (std::size_t f = 0; f < 3; ++f) {
    out += fmt::format("  {:4} {:12.5g}", EnumNames<CreepForce>::names[f], forces[f].value);
    for (std::size_t k = 0; k < 3; ++k)
      out += fmt::format(" {:10.4g}", c.sensitivities.values[f][k]);
    out += '\n';
  }
  return out;
}

/// Tables for people: slopes at zero beside Kalker's, sensitivities, and each curve.
std::string curves_text(const CreepCurves& c) {
  std::string out =
      fmt::format("Creep curves, model {}: Fz {:.6g} N, mu Fn {:.6g} N, c = {:.4g} mm; {} contact problems\n",
                  name_of(c.solution.choice.model), c.solution.result.totals.Fz.value, c.bound, c.radius,
                  c.contact_problems);
  if (is_closed_form(c.solution.choice.model))
    out += fmt::format("  ({})\n", c.solution.choice.why_this_model);
  out += slopes_text(c) + sensitivities_text(c);
  for (const CreepCurve& curve : c.curves) {
    out += fmt::format("Over {}\n  {:>12}        Fx N        Fs N     Mz N mm  |F|/(mu Fn)  adhesion\n",
                       name_of(curve.which), name_of(curve.which));
    for (const CreepPoint& p : curve.points)
      out += fmt::format("  {:12.5g} {:11.5g} {:11.5g} {:11.5g} {:12.4f} {:8.1f} %{}\n", p.creepage,
                         p.forces[0].value, p.forces[1].value, p.forces[2].value,
                         std::hypot(p.forces[0], p.forces[1]) / c.bound, 100 * p.adhesion_share,
                         p.certified ? "" : "  NOT certified");
  }
  return out;
}

/// What is asked for, at every door.
struct Answer {
  CreepCurves curves;
  std::optional<MeasuredForces> measured;

  record::Record record() const {
    record::Record out = record_of(curves);
    if (measured)
      out.add("measured", record_of(*measured));
    return out;
  }
};

bool certified(const Answer& answer) {
  return certified(answer.curves) && (!answer.measured || certified(*answer.measured));
}

/// All curves below each other: which creepage varied, the creepage, and the columns of a curve.
void write_curves(std::ostream& out, const CreepCurves& c) {
  for (const CreepCurve& curve : c.curves) {
    record::Table table = table_of(curve);
    table.columns.front().unit = "1"; // that of phi is another
    if (&curve == &c.curves.front())
      out << "varied," << record::csv_head(table) << '\n';
    for (std::size_t row = 0; row < table.size(); ++row)
      out << name_of(curve.which) << ',' << record::csv_line(table, row) << '\n';
  }
}

ExitCode run(const CreepArguments& arguments) {
  const std::vector<CreepRange> ranges = ranges_of(arguments.ranges);
  const std::vector<Output> outputs{{"--output", arguments.output, OutputForm::whole_file},
                                    {"--csv", arguments.csv}};
  const GivenScene given = read_given_scene_for(outputs, arguments.scene, arguments.model);
  const CreepSolver solver =
      arguments.jobs == 1 ? nullptr : task::creep_points_by(task::in_children(arguments.jobs), given.text);
  Answer answer;
  if (!arguments.measured.empty()) {
    require_named_outputs({arguments.measured}, outputs);
    answer.measured = read_measured_forces(arguments.measured);
    answer.curves = creep_curves_beside(*answer.measured, given.scene, ranges, nullptr, solver);
  } else
    answer.curves = creep_curves(given.scene, ranges, nullptr, solver);
  const CreepCurves& curves = answer.curves;
  if (arguments.strict)
    refuse_warnings(curves.solution.warnings);
  if (!arguments.output.empty())
    record::write_hdf5(arguments.output,
                       headed(creep_curves_format, given, arguments.output).append(answer.record()));
  if (!arguments.csv.empty())
    write_text(arguments.csv, [&](std::ostream& out) { write_curves(out, curves); });
  print_answer(headed(creep_curves_format).append(answer.record()), arguments.json,
               curves_text(curves) + (answer.measured ? measured_text(*answer.measured) : ""));
  warn(curves.solution.warnings);
  if (certified(answer))
    return success;
  spdlog::error(
      "Some points are not solutions (their certificates do not hold) Look at the column `certified`, and "
      "leave these points out or coarsen the grid.");
  return no_convergence;
}

} // namespace

std::string measured_text(const MeasuredForces& m) {
  const auto force = static_cast<std::size_t>(m.force);
  std::string out = fmt::format("{} as measured ({}) and as computed\n  {:>12} {:>11}{} {:>11} {:>11}\n",
                                name_of(m.force), m.source, name_of(m.which), "measured",
                                m.scatter.empty() ? "" : "     scatter", "computed", "difference");
  for (std::size_t i = 0; i < m.computed.size(); ++i)
    out += fmt::format("  {:12.5g} {:11.5g}{} {:11.5g} {:11.4g}{}\n", m.creepage[i], m.measured[i],
                       m.scatter.empty() ? "" : fmt::format(" {:11.4g}", m.scatter[i]),
                       m.computed[i].forces[force].value, m.computed[i].forces[force] - m.measured[i],
                       m.computed[i].certified ? "" : "  NOT certified");
  return out;
}

CreepRange creep_range(CreepKind kind, const std::string& text) {
  if (text == "auto")
    return {kind, {}};
  constexpr int most_points = 10000;
  if (auto values = equal_steps(text, most_points))
    return {kind, std::move(*values)};
  throw InputError(fmt::format("The range '{}' of {} cannot be read", text,
                               EnumNames<CreepKind>::names[static_cast<std::size_t>(kind)]),
                   "it is neither auto nor FROM:TO:COUNT with a count of 2 to 10000",
                   "Give one like 0:0.005:21.");
}

Command add_creep_curves(CLI::App& program) {
  const auto arguments = std::make_shared<CreepArguments>();
  CLI::App* line = program.add_subcommand("creep-curves", "Forces over creepages, slopes and sensitivities");
  line->add_option("scene", arguments->scene, "Scene file (TOML)")->required();
  line->add_option("--xi", arguments->ranges[0],
                   "Range of the longitudinal creepage, as motion.xi counts it");
  line->add_option("--eta", arguments->ranges[1], "Range of the lateral creepage");
  line->add_option("--phi", arguments->ranges[2], "Range of the spin, 1/mm");
  line->add_option("--measured", arguments->measured,
                   "Measured forces to compare with (CSV: xi,Fx or xi,Fx,scatter)");
  add_model(*line, arguments->model);
  add_strict(*line, arguments->strict);
  add_jobs(*line, arguments->jobs);
  add_json(*line, arguments->json);
  add_output_option(*line, "--csv", arguments->csv, "Write all curves, one line for each point");
  add_output_option(*line, "-o,--output", arguments->output, "Write all results (HDF5)");
  line->footer(creep_curves_help);
  return {line, [arguments] { return run(*arguments); }};
}

} // namespace bem_contact::app
