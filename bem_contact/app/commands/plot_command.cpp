#include "bem_contact/app/command.hpp"
#include "bem_contact/app/commands/start_python.hpp"
#include "bem_contact/base/argument_error.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <string>
#include <vector>

namespace bem_contact::app {

namespace {

constexpr const char* plot_help =
    R"(It recognises what FILE is. Python draws it (Debian's python3-matplotlib and python3-h5py). Example:
    bem_contact solve data/scenes/hertz.toml -o hertz.h5
    bem_contact plot hertz.h5 -o hertz.png
You should see the patch with its pressure, a cut through it, and the numbers: the largest pressure is 1238 MPa.

FILE         written by       the picture shows
result       solve -o         patch with adhesion, slip and traction; a cut with the bound of friction; section or stresses
comparison   compare -o       a patch for each model on one scale, section, pressures and their differences, numbers
sweep        sweep -o         patches over y; pressure, area, forces, T-gamma over the key that varies; along the track
                              patches from above, the wheel's centre from the side, and a film
sections     you              of a scene with sections or a slices file, from above: which points are joined
creep curves creep-curves -o  forces over creepages, the bound of friction, Kalker's slopes
fit          fit -o           measured forces, the curve that was fitted to them, and its band
conicity     conicity -o      rolling radius difference, contact points, equivalent conicity
wheelset     wheelset -o      both wheels
table        table -o         interpolation errors beside the tolerance; forces over the axes
FOLDER       wear -o          what is gone from both profiles by step, depth and area over mileage
fatigue      fatigue -o, --csv  shakedown diagram, FI_surf, stresses below, damage
stresses     stresses -o      a section of the body, beside it that of a half-space, and both over the depth
profile      you, profile --csv  the profile and its curvature; more profiles behind the first
BODY.toml    you              its mesh, the strip, the held part, and how good the worst element is
mesh .msh    mesh_body -o     the same
influence    fem_influence -o the strip, and how its surface moves, beside a half-space

Behind a result or a comparison come the meshes of its rail and of its wheel: both bodies, and the patch in space:
    bem_contact plot demo/comparison.h5 demo/rail_60E1.msh demo/wheel_S1002.msh -o demo/conformal.png

Behind profiles come the options of `bem_contact profile`:
    bem_contact plot data/bodies/hollow_wheel.txt S1002 --kind wheel -o profile.png
PICTURE ends in .png, .pdf or .svg; of wear also in .gif or .html: the profiles from step to step, with the depth drawn
larger than it is. In Python: bem_contact.plot(), and Result.plot().)";

struct PlotArguments {
  std::string file, output;
};

} // namespace

Command add_plot(CLI::App& program) {
  const auto arguments = std::make_shared<PlotArguments>();
  CLI::App* line = program.add_subcommand(
      "plot", "A picture of a result file, a folder of wear, a profile, a body, a mesh or an influence file");
  line->add_option("file", arguments->file, "What to draw; further profiles are drawn behind the first");
  add_output_option(*line, "-o,--output", arguments->output, "The picture; else FILE.png in this folder");
  line->prefix_command(); // further profiles, and options of the command profile, are Python's
  line->footer(plot_help);
  return {line, [arguments, line]() -> ExitCode {
            const std::vector<std::string> rest = line->remaining();
            if (std::ranges::count(rest, "--help") + std::ranges::count(rest, "-h") > 0)
              throw CLI::CallForHelp();
            std::vector<std::string> words;
            if (!arguments->output.empty())
              words = {"-o", arguments->output};
            if (!arguments->file.empty())
              words.push_back(arguments->file);
            words.insert(words.end(), rest.begin(), rest.end());
            become_python(system_python, "bem_contact.plotting", words);
          }};
}

} // namespace bem_contact::app
