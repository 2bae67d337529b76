#include "bem_contact/app/command.hpp"
#include "bem_contact/app/number_list.hpp"
#include "bem_contact/app/output/output_names.hpp"
#include "bem_contact/app/output/print_answer.hpp"
#include "bem_contact/base/argument_error.hpp"
#include "bem_contact/base/counted.hpp"
#include "bem_contact/base/error.hpp"
#include "bem_contact/base/output_file.hpp"
#include "bem_contact/base/printable.hpp"
#include "bem_contact/base/progress.hpp"
#include "bem_contact/base/stopwatch.hpp"
#include "bem_contact/record/file_kinds.hpp"
#include "bem_contact/sequence/scene_record.hpp"
#include "bem_contact/task/tasks.hpp"
#include "bem_contact/uses/table/creep_table.hpp"
#include "bem_contact/uses/table/packed_table.hpp"
#include "bem_contact/uses/table/scene_table.hpp"
#include "bem_contact/uses/table/table_file.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <iterator>
#include <memory>
#include <optional>
#include <ostream>
#include <span>
#include <spdlog/spdlog.h>

namespace bem_contact::app {

namespace {

constexpr const char* table_help =
    R"(Creep forces of an elliptic contact between half-spaces, over a/b and the three creepages (Kalker's USETAB):
    bem_contact table --creep-forces --tolerance 0.1 --elements 10 --ratio 0.5:2 -o creep.h5
You should see the points of the axes, how many contacts were solved, and for Fx, Fy and Mz the largest error of the
interpolation (7.99 %, 9.83 % and 7.82 %). The defaults, 2 % for a/b from 0.5 to 2, take 13 seconds of processor time.

Forces of a pair of profiles: add a table [table] to a scene. Points are added until the error in each cell is small enough.
    [table]
    position.lateral = { from = -4, to = 2, count = 4 }     # the axes begin with these points
    load.force = [ 4e4, 8e4 ]
    hold = [ "Fx", "Fy" ]      # quantities whose error is kept within the tolerance; or leave it out
    bem_contact table SCENE.toml -o forces.h5

Values of a table, as C, Fortran and Python look them up (tools/examples):
    bem_contact table creep.h5 --at 6,4,82000,30000,0.001,0,0    # a, b (mm), G (MPa), mu N (N), xi, eta, phi (1/mm)
    bem_contact table forces.h5 --at 0.5,6e4                     # one number for each axis
    bem_contact table forces.h5 --pack forces.c                  # one C source: values and derivatives, no library
More: data/tutorial/table.md.

Exit code 0: the table is within the tolerance; 2: the input is wrong; 3: a point has no certified result, or the
tolerance takes more than --most-points.)";

struct TableArguments {
  std::string input, output, text, model, at, pack;
  std::vector<std::string> columns = {"Fx", "Fy", "Fz", "Mz"}; ///< that are packed
  std::string ratio = "0.5:2";
  bool creep = false, json = false;
  table::CreepTableOptions options;
  table::Wanted wanted;
  int jobs = 0;
};

/// Throws InputError naming the option.
std::vector<double> numbers_of(const std::string& text, char between, const char* option,
                               const char* example) {
  if (const auto numbers = number_list(text, between))
    return *numbers;
  throw InputError(fmt::format("{} '{}' cannot be read", option, text),
                   fmt::format("it is no list of numbers with '{}' between them", between),
                   fmt::format("Give one like {}.", example));
}

/// What --json prints: all but the values.
record::Record summary_of(const table::ContactTable& t, double seconds) {
  record::Record axes, columns;
  for (const table::Axis& axis : t.axes)
    if (axis.first.empty())
      axes.add(axis.name, record::Field{axis.unit, axis.description, {axis.points.size()}, axis.points});
    else
      axes.add(axis.name,
               record::Record{{"points", record::Number{double(axis.points.size()), "1", "", {}, true}},
                              {"from", record::Number{axis.from(), axis.unit, "its lower end"}},
                              {"to", record::Number{axis.to(), axis.unit, "its upper end"}}});
  const record::Record all = record_of(t);
  for (const table::Column& c : t.columns) {
    record::Record one{{"unit", record::Text{c.unit}}, {"held", c.held}};
    for (const char* what : {"scale", "interpolation_error", "element_error"})
      one.add(what, *record::find(all, fmt::format("{}/{}", what, c.name)));
    columns.add(c.name, std::move(one));
  }
  record::Record out = headed(table_format);
  for (const char* what : {"points", "solved", "checked", "tolerance"})
    out.add(what, *record::find(all, what));
  return out.add("seconds", record::Number{seconds, "s", "wall clock"})
      .add("axes", std::move(axes))
      .add("columns", std::move(columns));
}

std::string words_of(const table::ContactTable& t, double seconds) {
  std::string out = "Table";
  bool below = false;
  for (const table::Axis& axis : t.axes) {
    const bool nested = !axis.first.empty();
    out += fmt::format("{}{} {}",
                       &axis == &t.axes.front() ? " over "
                       : !nested                ? " x "
                       : !below                 ? ", below them "
                                                : ", ",
                       axis.points.size(), axis.name);
    below = nested;
  }
  out += fmt::format(": {} points. {} contacts were solved in {}, the middle of {} cells among "
                     "them\n{:22} {:>18} {:>10} {:>16} {:>10}\n",
                     t.size(), t.solved, duration_text(seconds), t.checked, "", "interpolation", "",
                     "elements", "");
  for (const table::Column& c : t.columns)
    out += fmt::format("{:22} {:>18.3g} {:>8.3g} % {:>16.2g}  {}{}\n", c.name, c.interpolation_error,
                       100 * c.interpolation_error / c.scale, c.element_error, c.unit,
                       c.held ? fmt::format(", held within {:g} %", 100 * t.tolerance) : "");
  return out;
}

/// The value of every column at a point, or forces by creepages, with its stated error.
void print_values(const TableArguments& arguments) {
  const table::ContactTable t = table::read_table(arguments.input);
  const std::vector<double> at = numbers_of(arguments.at, ',', "--at", "0.5,6e4");
  const auto print = [](const char* name, double value, double error, const std::string& unit) {
    print_out("{} {:.12g} +- {:.2g} {}\n", name, value, error, unit);
  };
  if (t.scale) {
    if (at.size() != 7)
      throw InputError(fmt::format("--at '{}' cannot be used", arguments.at),
                       "a creep table wants a, b, G, mu N, xi, eta and phi",
                       "Give seven numbers, such as 6,4,82000,30000,0.001,0,0.");
    const table::TabulatedForces f =
        table::creep_forces(t, {at[0], at[1], at[2], at[3]}, at[4], at[5], at[6]);
    print("Fx", f.Fx, f.Fx_error, "N");
    print("Fy", f.Fy, f.Fy_error, "N");
    print("Mz", f.Mz, f.Mz_error, "N mm");
    return;
  }
  const std::vector<double> values = table::look_up(t, at);
  for (std::size_t c = 0; c < values.size(); ++c)
    print(t.columns[c].name.c_str(), values[c], t.columns[c].error(), t.columns[c].unit);
}

/// The table as one C source.
void write_packed(const TableArguments& arguments) {
  const table::ContactTable t = table::read_table(arguments.input);
  const std::string source = table::packed_source(t, arguments.columns);
  require_named_outputs({arguments.input}, {{"--pack", arguments.pack}});
  write_text(arguments.pack, [&](std::ostream& out) { out << source; });
  print_out("'{}' has {} of {}: call conformal_packed_force() in it.\n", arguments.pack,
            fmt::join(arguments.columns, ", "), counted(std::ptrdiff_t(t.size()), "point", "points"));
}

/// What is solved, by whom, and what the file says of it.
struct Order {
  table::ContactTable table;
  table::PointsSolver solve;
  std::optional<GivenScene> given;
};

Order creep_order(TableArguments& arguments, const task::Done& done) {
  const std::vector<double> ratio = numbers_of(arguments.ratio, ':', "--ratio", "0.5:2");
  if (ratio.size() != 2)
    throw InputError(fmt::format("--ratio '{}' cannot be used", arguments.ratio), "it needs two ends",
                     "Give FROM:TO, as 0.5:2.");
  arguments.options.from = ratio[0], arguments.options.to = ratio[1];
  arguments.options.tolerance = arguments.wanted.tolerance;
  Order order{table::creep_table(arguments.options), {}, {}};
  order.solve = task::points_by(task::in_children(arguments.jobs), *order.table.scale,
                                arguments.options.elements, done);
  return order;
}

Order scene_order(TableArguments& arguments, const task::Done& done) {
  table::SceneTable described = table::parse_scene_table(read_scene_text(arguments.input));
  described.model = arguments.model;
  arguments.wanted.rescale = table::rescale;
  const SceneFile scene = table::first_scene(described);
  return {table::table_of(described), task::points_by(task::in_children(arguments.jobs), described, done),
          GivenScene{described.text, described.model, scene, inputs_of(scene)}};
}

ExitCode run(TableArguments arguments) {
  if (!arguments.at.empty()) {
    print_values(arguments);
    return success;
  }
  if (!arguments.pack.empty()) {
    write_packed(arguments);
    return success;
  }
  if (arguments.creep == !arguments.input.empty())
    throw InputError("It is not clear which table is wanted",
                     arguments.creep ? "a scene and --creep-forces are given" : "there is no scene",
                     "Name a scene with a table [table], or give --creep-forces.");
  if (arguments.output.empty() && arguments.text.empty())
    throw InputError("The table has no file", "neither --output nor --text is given",
                     "Give -o TABLE.h5 to make a table, or --at to look one up.");
  std::optional<Progress> progress;
  const auto done = [&](std::size_t more) { progress->step(more); };
  Order order = arguments.creep ? creep_order(arguments, done) : scene_order(arguments, done);
  const std::vector<std::filesystem::path> inputs =
      order.given ? files_read(arguments.input, order.given->scene) : std::vector<std::filesystem::path>{};
  require_named_outputs(inputs,
                        {{"--output", arguments.output, OutputForm::whole_file}, {"--text", arguments.text}});
  arguments.wanted.progress = [](const std::string& text) { spdlog::info("the table has {}", text); };
  const Stopwatch watch;
  const table::PointsSolver counted_points = [&](std::span<const table::Point> points) {
    if (!points.empty())
      progress ? progress->extend(points.size()) : void(progress.emplace("contacts", points.size()));
    return order.solve(points);
  };
  table::refine(order.table, counted_points, arguments.wanted);
  if (progress)
    progress->finish();
  const double seconds = watch.seconds();
  if (!arguments.output.empty()) {
    const record::Record head =
        order.given ? headed(table_format, *order.given, arguments.output) : headed(table_format);
    table::write_table(arguments.output, head, order.table);
  }
  if (!arguments.text.empty())
    write_text(arguments.text, [&](std::ostream& out) { out << table::to_text(order.table); });
  print_answer(summary_of(order.table, seconds), arguments.json, words_of(order.table, seconds));
  return success;
}

} // namespace

Command add_table(CLI::App& program) {
  const auto arguments = std::make_shared<TableArguments>();
  TableArguments& a = *arguments;
  CLI::App* line = program.add_subcommand("table", "Tables of forces to look up, with measured errors");
  line->add_option("input", a.input, "Scene file (TOML) with a table [table]; with --at a table (HDF5)");
  line->add_flag("--creep-forces", a.creep, "Forces of an ellipse over its creepages, instead of a scene")
      ->configurable(false);
  add_output_option(*line, "-o,--output", a.output, "The table (HDF5)");
  add_output_option(*line, "--text", a.text,
                    "The same as plain text (bem_contact/uses/table/table_file.hpp)");
  line->add_option("--tolerance", a.wanted.tolerance,
                   "Largest error of the interpolation: over mu N (Mz: mu N R), or over each number's scale")
      ->capture_default_str();
  line->add_option("--most-points", a.wanted.most_points, "Refuse a table with more points")
      ->capture_default_str();
  line->add_option("--ratio", a.ratio, "Creep forces: FROM:TO of a/b")
      ->configurable(false)
      ->capture_default_str();
  line->add_option("--poisson", a.options.poisson, "Creep forces: Poisson's ratio")
      ->configurable(false)
      ->capture_default_str();
  line->add_option("--elements", a.options.elements, "Creep forces: elements across each axis of the ellipse")
      ->configurable(false)
      ->capture_default_str();
  add_model(*line, a.model);
  add_jobs(*line, a.jobs);
  add_json(*line, a.json);
  line->add_option("--at", a.at,
                   "Print the values of a table at a point, with the error of the interpolation")
      ->configurable(false);
  add_output_option(
      *line, "--pack", a.pack,
      "Write a table that is there (HDF5) as one C source, which looks up values and derivatives "
      "without any library");
  line->add_option("--columns", a.columns, "With --pack: which numbers of the table")
      ->delimiter(',')
      ->configurable(false)
      ->capture_default_str();
  line->footer(table_help);
  return {line, [arguments] { return run(*arguments); }};
}

} // namespace bem_contact::app
