#include "bem_contact/app/command.hpp"
#include "bem_contact/app/vtk_file.hpp"
#include "bem_contact/app/wheelset_output.hpp"
#include "bem_contact/base/output_file.hpp"
#include "bem_contact/sequence/result_warnings.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <memory>
#include <nlohmann/json.hpp>

namespace bem_contact::app {

namespace {

constexpr const char* wheelset_help =
    R"(A scene of one wheel becomes one of both if its table [load] is replaced by
    [wheelset]
    force = 2e5          # N, vertical force on the axle; both wheels share it
Example:
    bem_contact wheelset data/scenes/wheelset.toml
You should see that a lateral force of 20000 N moves the wheelset by 6.07 mm to the right, where the right wheel bears
0.547 of the vertical force and the axle rolls on a radius of 461.93 mm. Then comes what solve prints of each wheel.

Both forces act at the wheelset's centre, on the axle. Roll follows from the moments about the forward axis through
that centre: vertical forces have the lever arm y of their contacts, lateral forces the height of the axle, and their
sum is wheelset.roll_moment (0). The first table is in the track frame for both wheels; the left wheel's own result
counts y, s, Fy, Mz, eta and phi to the left.

Exit code 0: both certificates hold. 2: the input is wrong, a wheel lifts, or no displacement gives the lateral force.
3: no equilibrium was found, or a certificate does not hold.)";

struct WheelsetArguments {
  std::string scene, model, output, vtk;
  bool json = false, strict = false;
};

std::string surface_of(const WheelsetArguments& arguments, WheelSide side) {
  return fmt::format("{}_{}.vts", arguments.vtk, name_of(side));
}

std::vector<Output> outputs_of(const WheelsetArguments& arguments) {
  std::vector<Output> out{{"--output", arguments.output, OutputForm::whole_file}};
  for (const WheelSide side : both_sides)
    if (!arguments.vtk.empty())
      out.push_back({"--vtk-prefix", surface_of(arguments, side)});
  return out;
}

ExitCode run(const WheelsetArguments& arguments) {
  const GivenScene given = read_given_scene_for(outputs_of(arguments), arguments.scene, arguments.model);
  const WheelsetResult result = solve_wheelset(given.scene);
  if (arguments.strict)
    refuse_warnings(result.warnings);
  if (!arguments.output.empty())
    write_h5(arguments.output, to_table(result, given, arguments.output));
  for (const WheelSide side : both_sides)
    if (!arguments.vtk.empty())
      write_vts(surface_of(arguments, side), result.state.solved(side));
  fmt::print("{}", arguments.json ? to_json(result).dump(2) + "\n" : to_text(result));
  warn(result.warnings);
  return result.state.certified() ? success : no_convergence;
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
  line->add_option("--vtk-prefix", arguments->vtk,
                   "Write PREFIX_right.vts and PREFIX_left.vts for ParaView, each in the frame of its side");
  line->footer(wheelset_help);
  return {line, [arguments] { return run(*arguments); }};
}

} // namespace bem_contact::app
