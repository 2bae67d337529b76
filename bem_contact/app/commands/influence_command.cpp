#include "bem_contact/app/command.hpp"
#include "bem_contact/app/commands/influence_files.hpp"
#include "bem_contact/app/commands/numbers_file.hpp"
#include "bem_contact/base/argument_error.hpp"
#include "bem_contact/base/error.hpp"
#include "bem_contact/base/output_file.hpp"
#include "bem_contact/base/printable.hpp"
#include "bem_contact/halfspace/combine.hpp"
#include "bem_contact/halfspace/resample.hpp"
#include "bem_contact/influence/influence_file.hpp"
#include "bem_contact/influence/requirements.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fmt/format.h>
#include <memory>
#include <optional>

namespace bem_contact::app {

namespace {

/// GB. Largest table that `influence expand` writes. The table is held in memory three times (rail, wheel and
/// pair). Chosen, not measured: it allows 20 offsets of 950 rows.
constexpr double largest_table = 4.0;

constexpr const char* influence_help =
    R"(Influence files of standard bodies are prepared: `bem_contact influence list` names them, and this copies some:
    bem_contact influence get 60E1 S1002 -o files

An influence file holds a function. From it `expand` makes the influence numbers (Kalker's influence coefficients) of
one grid: how far element (m, I) moves under 1 MPa on element (0, J). m counts elements along x; I and J count rows
along the profile. `bem_contact info rail.h5` says the shortest --dx, and where on the profile the rows must lie.

One body: 20 offsets of 0.5 mm and 30 rows of 0.4 mm around the arc length s = -32 mm (.csv instead of .h5: as text):
    bem_contact influence expand rail.h5 --dx 0.5 --ds 0.4 --mx 20 --my 30 --centre -32 -o numbers.h5

A pair, the rail first. --centre on the rail lies opposite --wheel-centre on the wheel (`bem_contact check` prints both):
    bem_contact influence expand rail.h5 wheel.h5 --dx 0.5 --ds 0.4 --mx 20 --my 30 \
        --centre -32 --wheel-centre 35 -o pair.h5

For the program CONTACT (numerical influence coefficients, C3 = 9), one matrix for each loaded row, or one for all:
    bem_contact influence expand rail.h5 wheel.h5 ... --format contact --matrices each -o pair.txt

More: data/tutorial/influence.md. Every layout, unit and sign, and what CONTACT's case must have: data/INFLUENCE_FORMAT.md.)";

/// What `bem_contact influence expand` was asked for.
struct ExpandRequest {
  std::vector<std::string> files; ///< one body, or rail and wheel
  double dx = 0, ds = 0;          ///< mm
  int mx = 0, my = 0;             ///< offsets along x, rows
  /// Arc length of the middle of the rows on each body, mm; empty: the middle of its strip.
  std::optional<double> centre, wheel_centre;
  std::string structural = "removed"; ///< removed | included
  std::string format;                 ///< hdf5 | csv | contact; empty: by the ending of `output`
  std::string matrices = "each";      ///< each | one (contact alone)
  std::string output;
};

struct Body {
  InfluenceFunction function;
  std::vector<double> row_s;
  InfluenceNumbers numbers;
  double contact_radius = 0; ///< at which x was counted, mm; 0: a prismatic body
};

double middle_of(const InfluenceFunction& f) {
  return 0.5 * (f.stations.front().s + f.stations.back().s);
}

/// Radius at the arc length s; 0 for a prismatic body.
double radius_at(const InfluenceFunction& f, double s) {
  return f.invariance == Invariance::revolution ? f.radius_at(f.nearest_station(s).position) : 0;
}

/// `direction`: +1 if the rows ascend with the body's own s, -1 if they run against it.
Body expand_body(const ExpandRequest& r, const std::string& file, double direction,
                 std::optional<double> centre) {
  Body body{read_influence_file(file), {}, {}, 0};
  const double middle = centre.value_or(middle_of(body.function));
  for (int i = 0; i < r.my; ++i)
    body.row_s.push_back(middle + direction * (i - 0.5 * (r.my - 1)) * r.ds);
  ExpandOptions options;
  options.dx = r.dx;
  options.offsets = r.mx;
  options.structural =
      r.structural == "included" ? StructuralCompliance::included : StructuralCompliance::removed;
  body.contact_radius = options.contact_radius = radius_at(body.function, middle);
  body.numbers = halfspace::resample(body.function, options, body.row_s, r.ds);
  return body;
}

void describe(PlainNumbers& out, const ExpandRequest& r, const Body& body, const std::string& file,
              const std::string& suffix) {
  const InfluenceFunction& f = body.function;
  const auto add = [&](const std::string& name, std::string text) {
    out.remarks.emplace_back(name + suffix, std::move(text));
  };
  add("body", f.body);
  add("file", std::filesystem::path(file).filename().string());
  add("material", fmt::format("G = {:.10g} MPa, nu = {:.10g}", f.material.shear_modulus, f.material.poisson));
  add("structural_compliance", r.structural + (r.structural == "included" ? ", " + f.held : ""));
  if (f.invariance == Invariance::revolution)
    add("contact_radius", fmt::format("{:.10g} mm", body.contact_radius));
  add("estimated_error",
      f.estimated_error < 0 ? "not given" : fmt::format("{:.2e} of self", f.estimated_error));
  out.rows.emplace_back("s" + suffix, body.row_s);
}

/// Refuses what cannot be done with any file, before any file is read.
void check(const ExpandRequest& r, const std::string& format) {
  require_outputs(
      {r.files.begin(), r.files.end()},
      {{"--output", r.output, format == "hdf5" ? OutputForm::whole_file : OutputForm::text, true}});
  if (!(r.dx > 0 && std::isfinite(r.dx)) || !(r.ds > 0 && std::isfinite(r.ds)) || r.mx < 1 || r.my < 1)
    throw InputError("There are no such elements",
                     fmt::format("dx = {:g}, ds = {:g} mm, mx = {}, my = {}", r.dx, r.ds, r.mx, r.my),
                     "Give lengths above 0 and at least one element each way.");
  const double gigabytes = 3 * 8e-9 * 9 * r.mx * double(r.my) * r.my;
  if (gigabytes > largest_table)
    throw InputError(fmt::format("A table of {} offsets and {} rows is too large", r.mx, r.my),
                     fmt::format("it needs about {:.0f} GB, {:g} GB are allowed", gigabytes, largest_table),
                     "Ask for fewer rows.");
  if (format == "contact" && r.files.size() != 2)
    throw InputError("The format 'contact' is of a pair of bodies", "one influence file was given",
                     "Give two files, the rail's and then the wheel's.");
  if (r.wheel_centre && r.files.size() != 2)
    throw InputError("There is no wheel for --wheel-centre", "one influence file was given",
                     "Give two files, the rail's and then the wheel's, or --centre.");
  if (r.matrices != "each" && format != "contact")
    throw InputError("--matrices is of the format 'contact'", fmt::format("the format is '{}'", format),
                     "Leave it out, or give --format contact.");
}

std::string format_of(const ExpandRequest& r) {
  if (!r.format.empty())
    return r.format;
  const std::string ending = std::filesystem::path(r.output).extension().string();
  if (ending == ".csv")
    return "csv";
  if (ending == ".h5" || ending == ".hdf5")
    return "hdf5";
  throw InputError(fmt::format("The format of '{}' is not known", r.output),
                   "its name ends neither in .h5 nor in .csv", "Give --format hdf5, csv or contact.");
}

/// Writes the numbers; returns a line for people. Throws InputError for all that does not fit.
std::string expand_command(const ExpandRequest& r) {
  const std::string format = format_of(r);
  check(r, format);
  PlainNumbers out;
  if (r.files.size() == 1) {
    Body body = expand_body(r, r.files[0], 1, r.centre);
    out.remarks.emplace_back("frame", "the body's own: x along it, s its profile's arc length, n into it; "
                                      "traction and displacement are the body's own");
    describe(out, r, body, r.files[0], "");
    out.numbers = std::move(body.numbers);
  } else {
    // The wheel's own s runs against the rail's: its rows are those that lie opposite.
    Body rail = expand_body(r, r.files[0], 1, r.centre);
    Body wheel = expand_body(r, r.files[1], -1, r.wheel_centre);
    require_order(rail.function, wheel.function);
    out.remarks.emplace_back("frame",
                             "contact: x rolling direction, s the rail's arc length, n into the rail; "
                             "traction on the rail, displacement of the rail less that of the wheel");
    describe(out, r, rail, r.files[0], "_rail");
    describe(out, r, wheel, r.files[1], "_wheel");
    out.numbers = halfspace::combine(rail.numbers, wheel.numbers);
    out.shear_modulus = shear_modulus_of_pair(rail.function.material, wheel.function.material);
  }
  if (format == "hdf5")
    write_numbers_h5(r.output, out);
  else if (format == "csv")
    write_numbers_csv(r.output, out);
  else
    write_numbers_contact(r.output, out, r.matrices == "one" ? Matrices::one : Matrices::each);
  const int middle = out.numbers.rows / 2;
  return fmt::format(
      "{}: {} offsets x {} rows, elements of {:g} x {:g} mm; A_nn of the middle element {:.6e} "
      "mm/MPa; along the strip the numbers differ by up to {:.2g} % of it\n",
      r.output, out.numbers.offsets, out.numbers.rows, r.dx, r.ds,
      out.numbers.at(0, middle, component_n, middle, component_n),
      100 * variation_along_the_strip(out.numbers));
}

} // namespace

Command add_influence(CLI::App& program) {
  CLI::App* influence = program.add_subcommand(
      "influence", "Prepared influence files, and plain influence numbers from such files");
  influence->require_subcommand(1);
  influence->footer(influence_help);
  const auto request = std::make_shared<ExpandRequest>();
  ExpandRequest& r = *request;
  CLI::App* expand =
      influence->add_subcommand("expand", "Write the numbers of one body, or of rail and wheel, for a grid");
  expand->add_option("files", r.files, "Influence file of a body, or those of the rail and the wheel")
      ->required()
      ->expected(1, 2);
  expand->add_option("--dx", r.dx, "Length of an element along x, mm")->required();
  expand->add_option("--ds", r.ds, "Width of an element along s, mm")->required();
  expand->add_option("--mx", r.mx, "Offsets along x: 0 .. MX-1 elements")->required();
  expand->add_option("--my", r.my, "Rows along s")->required();
  expand->add_option("--centre", r.centre,
                     "Arc length of the middle of the rows, mm (default: the middle of the part covered)");
  expand->add_option("--wheel-centre", r.wheel_centre, "The same on the wheel of a pair");
  expand->add_option("--structural-compliance", r.structural, "The body's motion as a whole")
      ->check(CLI::IsMember({"included", "removed"}))
      ->capture_default_str();
  expand->add_option("--format", r.format, "Without it, the ending of the output decides: .h5 or .csv")
      ->check(CLI::IsMember({"hdf5", "csv", "contact"}));
  expand
      ->add_option("--matrices", r.matrices,
                   "Format contact: each = one matrix for each loaded row; one = one for all rows")
      ->check(CLI::IsMember({"each", "one"}))
      ->capture_default_str();
  add_output_option(*expand, "-o,--output", r.output, "File to write")->required();
  expand->footer(R"(Example:
    bem_contact influence expand data/influence/small_rail.h5 --dx 0.5 --ds 0.5 --mx 20 --my 30 -o numbers.h5
`bem_contact influence --help` explains it and has more.)");
  return {influence, [request, about_files = add_influence_files(*influence)] {
            if (about_files())
              return success;
            print_out("{}", expand_command(*request));
            return success;
          }};
}

} // namespace bem_contact::app
