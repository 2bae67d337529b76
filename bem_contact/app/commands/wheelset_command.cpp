#include "bem_contact/app/command.hpp"
#include "bem_contact/app/output/output_names.hpp"
#include "bem_contact/app/output/print_answer.hpp"
#include "bem_contact/app/output/report.hpp"
#include "bem_contact/app/output/vtk_file.hpp"
#include "bem_contact/base/argument_error.hpp"
#include "bem_contact/base/fixed_text.hpp"
#include "bem_contact/base/output_file.hpp"
#include "bem_contact/base/provenance.hpp"
#include "bem_contact/record/error_text.hpp"
#include "bem_contact/record/file_kinds.hpp"
#include "bem_contact/record/hdf5.hpp"
#include "bem_contact/sequence/quantities.hpp"
#include "bem_contact/sequence/result_file.hpp"
#include "bem_contact/sequence/result_warnings.hpp"
#include "bem_contact/sequence/scene_record.hpp"
#include "bem_contact/uses/wheelset/quantities.hpp"
#include "bem_contact/uses/wheelset/settings.hpp"
#include "bem_contact/uses/wheelset/solve_wheelset.hpp"

#include <CLI/CLI.hpp>
#include <cmath>
#include <filesystem>
#include <fmt/format.h>
#include <memory>
#include <string>

namespace bem_contact::app {

namespace {

using namespace record; // of its texts of numbers

constexpr const char* wheelset_help =
    R"(A scene of one wheel becomes one of both if its table [load] is replaced by
    [wheelset]
    force = 2e5          # N, vertical force on the axle; both wheels share it
Example:
    bem_contact wheelset data/scenes/wheelset.toml
You should see that a lateral force of 20000 N moves the wheelset by 6.07 mm to the right, where the right wheel bears
0.547 of the vertical force and the axle rolls on a radius of 461.92 mm. The first table is in the track frame for both
wheels. Then comes what solve prints of each wheel; the left one counts y, s, Fy, Mz, eta and phi to the left.

More, and which moments give the roll: data/tutorial/wheelset.md.

Exit code 0: both certificates hold. 2: the input is wrong, a wheel lifts, or no displacement gives the lateral force.
3: no equilibrium was found, or a certificate does not hold.)";

struct WheelsetArguments {
  std::string scene, model, output, vtk;
  bool json = false, strict = false;
};

/// Numbers from 1e4 to 1e7, such as forces in N, are printed without decimals, all others with five digits. A
/// number with a smaller error gets more digits.
std::string number(double value, double error = unknown_error) {
  const double size = std::abs(value);
  return size >= 1e4 && size < 1e7 ? fixed_fine(value, error, 0) : digits_fine(value, error, 5);
}

double error_of(const WheelQuantity& q, const WheelsetResult& r, WheelSide side) {
  return q.measured(r.state, side).error;
}

/// The stated errors below a line of the table; "" where there are none.
std::string errors_of(const WheelQuantity& q, const WheelsetResult& r) {
  std::string out = fmt::format("  {:>22}", "+-"), cells;
  for (const WheelSide side : both_sides)
    cells += fmt::format(" {:>13}", two_digits(error_of(q, r, side)));
  return cells.find_first_not_of(' ') == std::string::npos ? "" : out + cells + "\n";
}

/// "  Fz               N          109328         90672        200000": the sum only where there is one.
std::string line_of(const WheelQuantity& q, const WheelsetResult& r) {
  std::string out = fmt::format("  {:16} {:5}", q.name, q.unit.rolling);
  for (const WheelSide side : both_sides)
    out += fmt::format(" {:>13}", number(q.value(r.state, side), error_of(q, r, side)));
  for (const WheelsetQuantity& sum : wheelset_quantities())
    if (std::string_view(sum.name) == q.name)
      out += fmt::format(" {:>13}", number(sum.value(r)));
  return out + "\n" + errors_of(q, r);
}

std::string pose_text(const WheelsetResult& r) {
  const WheelsetPose& pose = r.state.pose;
  std::string out = fmt::format(
      "Wheelset: lateral {} mm{}, roll {:.4e} rad (right side down), yaw {:g} rad; its "
      "centre is {:.4f} mm "
      "above the rails\n",
      r.lateral_error > 0 ? record::rounded(pose.lateral, r.lateral_error) : fixed_text(pose.lateral, 4),
      std::isnan(r.lateral_residual) ? "" : " (found for the lateral force)", pose.roll, r.state.yaw,
      r.state.wheel_radius - pose.vertical);
  if (pose.rolling_radius)
    out +=
        fmt::format("the axle rolls on a radius of {:.3f} mm (found for the torque)\n", *pose.rolling_radius);
  return out;
}

/// What the curve asks, and what there is of it.
std::string curve_text(const WheelsetResult& r) {
  if (std::isnan(r.curve.force))
    return "";
  const double outer = r.curve.radius_difference > 0 ? 1 : -1; // 1: the right wheel is the outer one
  const double found = named(wheelset_quantities(), "radius_difference").value(r);
  return fmt::format(
      "the curve presses the axle with {} N {}wards{}; the outer wheel rolls on a radius {:.3f} mm "
      "{} than the inner one, and without longitudinal creepage it would be {:.3f} mm larger\n",
      number(std::abs(r.curve.force)), outer * r.curve.force < 0 ? "in" : "out",
      std::isnan(r.lateral_residual) ? " (not added: the displacement is given)" : "", std::abs(found),
      outer * found < 0 ? "smaller" : "larger", outer * r.curve.radius_difference);
}

/// For people: both wheels side by side in the track frame, then what solve prints of each.
std::string wheelset_text(const WheelsetResult& r) {
  std::string out = pose_text(r) + curve_text(r);
  const Model right = r.state.right.choice.model, left = r.state.left.choice.model;
  if (right != left)
    out +=
        fmt::format("the right wheel is solved by {}, the left one by {}\n", name_of(right), name_of(left));
  out += fmt::format("  {:22} {:>13} {:>13} {:>13}\n", "y to the right for both", "right", "left", "sum");
  for (const WheelQuantity& q : wheel_quantities())
    out += line_of(q, r);
  const Wrench sum = r.state.sum();
  out +=
      fmt::format("on the axle: roll moment {:.5g} N mm and yaw moment {:.5g} N mm about its centre, torque "
                  "{:.5g} N mm\n",
                  r.state.roll_moment(sum), sum.moment[2], r.state.torque(sum));
  out += fmt::format(
      "equilibrium: largest residual {:.1e} of {:.0e} allowed; {} contact problems, {:.2f} s\n",
      std::fmax(r.residual, r.lateral_residual), equilibrium_tolerance, r.contact_problems, r.seconds);
  for (const WheelSide side : both_sides)
    out += fmt::format("\n{} wheel\n{}", side == WheelSide::right ? "Right" : "Left",
                       to_text(r.state.solved(side)));
  return out;
}

std::string surface_of(const WheelsetArguments& arguments, WheelSide side) {
  return fmt::format("{}_{}.vts", arguments.vtk, name_of(side));
}

std::vector<Output> outputs_of(const WheelsetArguments& arguments) {
  std::vector<Output> out{{"--output", arguments.output, OutputForm::whole_file}};
  for (const WheelSide side : both_sides)
    if (!arguments.vtk.empty())
      out.push_back(
          {.option = "--vtk-prefix", .file = surface_of(arguments, side), .begins_with = surface_begin});
  return out;
}

ExitCode run(const WheelsetArguments& arguments) {
  const GivenScene given = read_given_scene_for(outputs_of(arguments), arguments.scene, arguments.model);
  const WheelsetResult result = solve_wheelset(given.scene);
  if (arguments.strict)
    refuse_warnings(result.warnings);
  if (!arguments.output.empty())
    record::write_hdf5(arguments.output,
                       headed(wheelset_format, given, arguments.output).append(record_of(result)));
  for (const WheelSide side : both_sides)
    if (!arguments.vtk.empty())
      write_vts(surface_of(arguments, side), result.state.solved(side));
  print_answer(headed(wheelset_format).append(record_of(result, {.fields = false})), arguments.json,
               wheelset_text(result));
  warn(result.warnings);
  return certified(result.state) ? success : no_convergence;
}

} // namespace

Command add_wheelset(CLI::App& program) {
  const auto arguments = std::make_shared<WheelsetArguments>();
  CLI::App* line =
      program.add_subcommand("wheelset", "Both wheels of a wheelset under the forces on its axle");
  line->add_option("scene", arguments->scene, "Scene file (TOML) with a table [wheelset]")->required();
  add_model(*line, arguments->model);
  add_strict(*line, arguments->strict);
  add_json(*line, arguments->json);
  add_output(*line, arguments->output);
  add_output_option(*line, "--vtk-prefix", arguments->vtk,
                    "Write PREFIX_right.vts and PREFIX_left.vts for ParaView, each in the frame of its side");
  line->footer(wheelset_help);
  return {line, [arguments] { return run(*arguments); }};
}

} // namespace bem_contact::app
