#include "bem_contact/app/command.hpp"
#include "bem_contact/base/argument_error.hpp"
#include "bem_contact/base/error.hpp"
#include "bem_contact/base/input_file.hpp"
#include "bem_contact/base/output_file.hpp"
#include "bem_contact/base/printable.hpp"
#include "bem_contact/profile/read_profile.hpp"
#include "bem_contact/profile/standard_profiles.hpp"
#include "bem_contact/scene/scene_file.hpp"

#include <CLI/CLI.hpp>
#include <filesystem>
#include <fmt/format.h>
#include <iostream>
#include <memory>
#include <ostream>

namespace bem_contact::app {

namespace {

constexpr const char* new_help =
    R"(Writes a scene of a wheelset with a comment beside each key, as a beginning for your own. Example:
    bem_contact new --wheel S1002 --rail 60E1 --curve 300 --load 80e3 -o curve.toml
    bem_contact wheelset curve.toml
You should see that the wheelset stands 6.23 mm to the right in this curve to the left.
`bem_contact study curve.toml -o curve` answers all that the file asks for; data/tutorial/study.md goes on from here.

Without --curve the track is straight and the wheelset stands in its middle.)";

/// Of the share of the vertical force that guides a leading wheelset in a curve. Chosen: a bogie asks for .1
/// to .2.
constexpr double guiding_share = 0.125;

struct NewScene {
  std::string wheel, rail, output;
  double curve = 0;  ///< m; 0: straight
  double load = 8e4; ///< N, of one wheel
  double speed = 15; ///< m/s
  double friction = 0.3;
};

/// The profile of a body as a scene in the output's folder names it, with the smoothing that its noise needs.
std::string profile_lines(const char* body, const std::string& name, ProfileKind kind,
                          const std::string& output) {
  const MeasuredProfile read = described_profile(name, kind); // what cannot be read is refused here
  const ProfileFileName given = profile_file_name(name);
  std::string path = name;
  if (!is_standard_profile(name) && !output.empty()) {
    const auto folder = std::filesystem::absolute(output).parent_path();
    path = std::filesystem::absolute(given.file).lexically_proximate(folder).generic_string();
    if (given.part > 0)
      path += fmt::format("#{}", given.part);
  }
  std::string out = fmt::format(
      "{}.profile = \"{}\" # a standard (bem_contact profile --help) or a profile file\n", body, path);
  const std::string noise = fmt::format("the points scatter by {:.2g} um", 1e3 * read.noise.scatter);
  if (const ReadingAdvice& advice = read.advice; !advice.nominal.empty())
    out += fmt::format("{}.nominal = \"{}\" # from which it was made: {}\n", body, advice.nominal, noise);
  else if (advice.smoothing > 0)
    out += fmt::format("{}.smoothing = {:.2g} # mm, shortest wave that is kept: {}\n", body, advice.smoothing,
                       noise);
  return out;
}

constexpr const char* head_text = R"(# A wheelset{where}, written by bem_contact new.
#   bem_contact check {file}          what would be solved
#   bem_contact study {file} -o DIR   all answers that the tables below ask for
# Units are mm, N, MPa, rad; x forward, y to the right, z down. bem_contact --print-default has all keys.
kind = "wheel_rail"
{wheel}{rail}solver.model = "auto"       # the cheapest model that is good enough; "halfspace", "fem" (wants influence files) ...

[position]
wheel_radius = 460          # mm, at the tape circle
rail_inclination = 0.025    # rad towards the track's centre: 1:40; 0.05 is 1:20; 0 where rails were measured as they lie
gauge = 1435                # mm
gauge_height = 14           # mm below the top of the rail, where the gauge is measured
back_to_back = 1360         # mm, of the flange backs
yaw = {yaw}                 # rad, front to the right: the angle of attack
lateral = {lateral}         # mm to the right{search}

)";

constexpr const char* track_text = R"([track]
curve_radius = -{radius}    # mm; below 0: its centre is to the left, so that the right wheel runs on the outer rail
superelevation = {cant}     # mm, outer rail over inner one

)";

constexpr const char* rest_text = R"([wheelset]
force = {force}             # N on the axle, normal to the track: both wheels share it
{guiding}
[motion]
friction = {friction}
{speed}
[grid]
accuracy = 0.02             # dx and ds for an estimated error of 2 % by the size of the elements

# From here on each table asks for an answer of `bem_contact study`. Its keys are the options of the command of its name.
[conicity]                  # how the wheelset steers itself
[wear]                      # what is worn away by km and by a million gross tonnes
[fatigue]                   # shakedown, damage and stresses below the surface
yield_shear = 300           # MPa, of the rail's steel
[creep_curves]              # forces over the creepages
xi = "-0.01:0.01:5"         # FROM:TO:COUNT; eta, phi and auto as well

# More of them, without the # in front:
# [sweep]                   # many cases
# position.lateral = {{ from = 0, to = 6, count = 4 }}
# [table]                   # forces to look up, with measured errors
# position.lateral = {{ from = {from}, to = {lateral}, count = 2 }}
# load.force = [{low}, {high}]
# tolerance = 0.05
# [compare]                 # models of elasticity at equal forces
# models = ["halfspace", "tangent_plane"]
# [influence]               # bodies whose influence functions are computed for "fem" (minutes, once)
# rail = "rail_body.toml"   # data/bodies has examples; rail.influence above names the file to be written
# [uncertainty]             # how much the answers scatter where the inputs do
# friction = 0.03           # standard deviation
# load = {scatter}          # N
# draws = 10
)";

std::string scene_text(const NewScene& n) {
  using fmt::arg;
  const bool curve = n.curve > 0;
  const std::string file =
      n.output.empty() ? "CASE.toml" : std::filesystem::path(n.output).filename().string();
  std::string out = fmt::format(
      fmt::runtime(head_text), arg("where", curve ? fmt::format(" in a curve of {:g} m", n.curve) : ""),
      arg("file", file), arg("wheel", profile_lines("wheel", n.wheel, ProfileKind::wheel, n.output)),
      arg("rail", profile_lines("rail", n.rail, ProfileKind::rail, n.output)),
      arg("yaw", curve ? "3e-3" : "0"), arg("lateral", curve ? "5" : "0"),
      arg("search", curve ? ", where the search for the lateral force begins" : ""));
  if (curve)
    out += fmt::format(fmt::runtime(track_text), arg("radius", fmt::format("{:g}", 1e3 * n.curve)),
                       arg("cant", 100));
  return out +
         fmt::format(
             fmt::runtime(rest_text), arg("force", fmt::format("{:g}", 2 * n.load)),
             arg("guiding", curve ? fmt::format("force_y = {:g}             # N to the right, besides "
                                                "that of the curve: the bogie guides the axle\n",
                                                2 * n.load * guiding_share)
                                  : ""),
             arg("friction", fmt::format("{:g}", n.friction)),
             arg("speed", curve ? fmt::format("speed = {:g}               # mm/s\n", 1e3 * n.speed) : ""),
             arg("from", curve ? 3 : -2), arg("lateral", curve ? 5 : 2),
             arg("low", fmt::format("{:g}", 0.8 * n.load)), arg("high", fmt::format("{:g}", 1.2 * n.load)),
             arg("scatter", fmt::format("{:g}", 0.1 * n.load)));
}

ExitCode run_new(const NewScene& asked) {
  if (!asked.output.empty() && file_exists(asked.output))
    throw InputError(fmt::format("'{}' exists", asked.output), "what is in it would be lost",
                     "Give another name, or remove the file.");
  const std::string text = scene_text(asked);
  parse_scene_file(
      {text, "the new scene",
       asked.output.empty() ? std::filesystem::path() : std::filesystem::path(asked.output).parent_path()});
  if (asked.output.empty())
    print_out("{}", text);
  else
    write_text(asked.output, [&](std::ostream& out) { out << text; });
  return success;
}

} // namespace

Command add_new(CLI::App& program) {
  const auto asked = std::make_shared<NewScene>();
  CLI::App* line = program.add_subcommand("new", "A scene of a wheelset with comments, to begin with");
  line->add_option("--wheel", asked->wheel, "Standard or profile file of the wheels")->required();
  line->add_option("--rail", asked->rail, "Standard or profile file of the rails")->required();
  line->add_option("--curve", asked->curve, "Radius of the curve, m; 0: straight track")
      ->check(CLI::Range(0.0, 1e6))
      ->capture_default_str();
  const CLI::Range positive(1e-6, 1e9);
  line->add_option("--load", asked->load, "Vertical force of one wheel, N")
      ->check(positive)
      ->capture_default_str();
  line->add_option("--speed", asked->speed, "Speed in the curve, m/s")
      ->check(positive)
      ->capture_default_str();
  line->add_option("--friction", asked->friction, "Coefficient of friction")
      ->check(positive)
      ->capture_default_str();
  add_output_option(*line, "-o,--output", asked->output, "The scene file; without it, standard output");
  line->footer(new_help);
  return {line, [asked] { return run_new(*asked); }};
}

} // namespace bem_contact::app
