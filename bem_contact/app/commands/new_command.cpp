#include "bem_contact/app/command.hpp"
#include "bem_contact/app/commands/new_crossing.hpp"
#include "bem_contact/base/argument_error.hpp"
#include "bem_contact/base/error.hpp"
#include "bem_contact/base/input_file.hpp"
#include "bem_contact/base/output_file.hpp"
#include "bem_contact/base/printable.hpp"
#include "bem_contact/base/schema_text.hpp"
#include "bem_contact/profile/read_profile.hpp"
#include "bem_contact/profile/standard_profiles.hpp"
#include "bem_contact/profile/worn/like_standard.hpp"
#include "bem_contact/scene/scene_file.hpp"

#include <CLI/CLI.hpp>
#include <filesystem>
#include <fmt/format.h>
#include <iostream>
#include <memory>
#include <optional>
#include <ostream>
#include <tuple>

namespace bem_contact::app {

namespace {

constexpr const char* new_help =
    R"(Writes a scene of a wheelset with a comment beside each key, as a beginning for your own. Example:
    bem_contact new --wheel S1002 --rail 60E1 --curve 300 --load 80e3 -o curve.toml
    bem_contact wheelset curve.toml
You should see that the wheelset stands 6.23 mm to the right in this curve to the left.
`bem_contact study curve.toml -o curve` answers all that the file asks for; data/tutorial/study.md goes on from here.

Without --curve the track is straight and the wheelset stands in its middle.

A wheel over a crossing, by its angle 1:9, without a drawing (data/tutorial/passage.md):
    bem_contact new --crossing 9 --wheel S1002 --rail 60E1 -o crossing.toml
    bem_contact sweep crossing.toml -o passage.h5)";

/// 1. Share of the vertical force that guides a leading wheelset in a curve. Chosen: a bogie asks for 0.1 to
/// 0.2.
constexpr double guiding_share = 0.125;
/// rad. Angle of attack of a leading wheelset in a curve. Chosen: a bogie in 300 m has 2e-3 to 5e-3.
constexpr double usual_attack = 3e-3;
/// mm. Superelevation of a curve. Chosen: usual ones reach 150 mm.
constexpr double usual_superelevation = 100;
/// rad. Of rails that stand upright in their profile: 1:40.
constexpr double usual_inclination = 0.025;

struct NewScene {
  std::string wheel, rail, inner_rail, output;
  double curve = 0;  ///< m; 0: straight
  double load = 8e4; ///< N, of one wheel
  double speed = 15; ///< m/s
  double friction = 0.3;
  std::optional<double> superelevation, force_y, yaw; ///< mm, N, rad; empty: chosen
  NewCrossing crossing;                               ///< with a number: this is asked for

  bool is_curve() const { return curve > 0; }
  double axle_force() const { return 2 * load; } ///< N
  /// N; empty: the wheelset stands where position.lateral says.
  std::optional<double> lateral_force() const {
    return force_y || !is_curve() ? force_y : guiding_share * axle_force();
  }
};

/// A body as the scene has it.
struct NewBody {
  std::string lines;
  std::string nominal = {}; ///< "": none
  double smoothing = 0;     ///< mm
  double inclination = 0;   ///< rad, of a rail in its file
};

/// The name of a profile, as a scene in the output's folder gives it.
std::string name_in_scene(const std::string& name, const std::string& output) {
  if (is_standard_profile(name) || output.empty())
    return name;
  const ProfileFileName given = profile_file_name(name);
  const auto folder = std::filesystem::absolute(output).parent_path();
  const std::string path = std::filesystem::absolute(given.file).lexically_proximate(folder).generic_string();
  return given.part > 0 ? fmt::format("{}#{}", path, given.part) : path;
}

/// The profile of a body, with what its noise needs: the standard from which it was made, or a smoothing.
NewBody new_body(const char* body, const std::string& name, ProfileKind kind, const std::string& output) {
  const MeasuredProfile read = described_profile(name, kind); // what cannot be read is refused here
  NewBody out{.lines =
                  fmt::format("{}.profile = {} # a standard (bem_contact profile --help) or a profile file\n",
                              body, toml_text(name_in_scene(name, output))),
              .nominal = read.advice.nominal};
  const std::string noise = fmt::format("the points scatter by {:.2g} um", 1e3 * read.noise.scatter);
  if (!out.nominal.empty())
    out.lines += fmt::format("{}.nominal = \"{}\" # from which it was made: {}\n", body, out.nominal, noise);
  else if (read.advice.smoothing > 0) {
    out.smoothing = read.advice.smoothing;
    out.lines += fmt::format("{}.smoothing = {:.2g} # mm, shortest wave that is kept: {}\n", body,
                             out.smoothing, noise);
  }
  if (kind == ProfileKind::rail && read.points > 0) // no standard is inclined
    out.inclination = rail_inclination(read.curve, read.scatter_left());
  return out;
}

/// What the scene says of a rail that is inclined in its file, or is not.
std::string inclination_line(const std::string& key, const NewBody& rail) {
  return rail.inclination > 0
             ? fmt::format("{} = 0        # rad: the file has the rail inclined already ({})\n", key,
                           inclination_text(rail.inclination))
             : fmt::format(
                   "{} = {:g}    # rad towards the track's centre: 1:40; 0.05 is 1:20; 0 where rails were "
                   "measured as they lie\n",
                   key, double(usual_inclination));
}

/// The inner rail of a curve to the left is the left one.
std::string inner_rail_text(const NewScene& n, const NewBody& outer) {
  if (n.inner_rail.empty())
    return "";
  const NewBody inner = new_body("left_rail", n.inner_rail, ProfileKind::rail, n.output);
  std::string out = "# The inner rail. What left_rail leaves out is as rail has it.\n" + inner.lines;
  if (!outer.nominal.empty() && inner.nominal.empty())
    out += "left_rail.nominal = \"\"\n";
  if (outer.smoothing > 0 && inner.smoothing == 0)
    out += "left_rail.smoothing = 0\n";
  if ((inner.inclination > 0) != (outer.inclination > 0))
    out += inclination_line("left_rail.inclination", inner);
  return out;
}

constexpr const char* head_text = R"(# A wheelset{where}, written by bem_contact new.
#   bem_contact check {file}          what would be solved
#   bem_contact study {file} -o DIR   all answers that the tables below ask for
# Units are mm, N, MPa, rad; x forward, y to the right, z down. bem_contact --print-default has all keys.
kind = "wheel_rail"
{wheel}{rail}{inner}solver.model = "auto"       # the cheapest model that is good enough; "halfspace", "fem" (wants influence files) ...

[position]
wheel_radius = 460          # mm, at the tape circle
{inclination}gauge = 1435                # mm
gauge_height = 14           # mm below the top of the rail, where the gauge is measured
back_to_back = 1360         # mm, of the flange backs
yaw = {yaw:g}                 # rad, front to the right: the angle of attack
lateral = {lateral}         # mm to the right{search}

)";

constexpr const char* track_text = R"([track]
curve_radius = -{radius:g}    # mm; below 0: its centre is to the left, so that the right wheel runs on the outer rail
superelevation = {cant:g}     # mm, outer rail over inner one

)";

constexpr const char* rest_text = R"([wheelset]
force = {force:g}             # N on the axle, normal to the track: both wheels share it
{guiding}
[motion]
friction = {friction:g}
{speed}
# [layer]                   # what lies on the rail. Creep forces grow with 0.9 to 1 of Kalker's slope on clean rigs, and grew
# state = "locomotive"      # with 0.26 of it on a locomotive in service. Or clean, rig, oxide, sand, clay, MoS2

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
# {swept}
# [table]                   # forces to look up, with measured errors
# position.lateral = {{ from = {from}, to = {lateral}, count = 2 }}
# load.force = [{low:g}, {high:g}]
# tolerance = 0.05
# [compare]                 # models of elasticity at equal forces
# models = ["halfspace", "tangent_plane"]
# [influence]               # bodies whose influence functions are computed for "fem" (minutes, once)
# rail = "60E1"             # a standard, or a body file (data/bodies has examples). The file to be written needs a key
# wheel = "S1002"           # above the first [table]: rail.influence = "rail.h5" and wheel.influence = "wheel.h5"
# [uncertainty]             # how much the answers scatter where the inputs do
# friction = 0.03           # standard deviation
# load = {scatter:g}          # N
# draws = 10
# states = "clean, rig"     # the same numbers for other states of the surfaces (layer.state)
)";

/// The lists of a sweep, over what is not found.
std::string swept_text(const NewScene& n) {
  if (const std::optional<double> force = n.lateral_force())
    return fmt::format(
        "wheelset.force_y = {{ from = 0, to = {:g}, count = 4 }} # position.lateral is found for each",
        *force);
  return "position.lateral = { from = 0, to = 6, count = 4 }";
}

std::string guiding_text(const NewScene& n) {
  const std::optional<double> force = n.lateral_force();
  if (!force)
    return "";
  return fmt::format("force_y = {:g}             # N to the right{}\n", *force,
                     n.is_curve() ? ", besides that of the curve: the bogie guides the axle" : "");
}

std::string scene_text(const NewScene& n) {
  using fmt::arg;
  const bool curve = n.is_curve(), found = n.lateral_force().has_value();
  const std::string file =
      n.output.empty() ? "CASE.toml" : std::filesystem::path(n.output).filename().string();
  const NewBody rail = new_body("rail", n.rail, ProfileKind::rail, n.output);
  std::string out = fmt::format(
      fmt::runtime(head_text), arg("where", curve ? fmt::format(" in a curve of {:g} m", n.curve) : ""),
      arg("file", file), arg("wheel", new_body("wheel", n.wheel, ProfileKind::wheel, n.output).lines),
      arg("rail", rail.lines), arg("inner", inner_rail_text(n, rail)),
      arg("inclination", inclination_line("rail_inclination", rail)),
      arg("yaw", n.yaw.value_or(curve ? usual_attack : 0)), arg("lateral", curve ? "5" : "0"),
      arg("search", found ? ", where the search for the lateral force begins" : ""));
  if (curve)
    out += fmt::format(fmt::runtime(track_text), arg("radius", 1e3 * n.curve),
                       arg("cant", n.superelevation.value_or(usual_superelevation)));
  return out +
         fmt::format(
             fmt::runtime(rest_text), arg("force", n.axle_force()), arg("guiding", guiding_text(n)),
             arg("friction", n.friction),
             arg("speed", curve ? fmt::format("speed = {:g}               # mm/s\n", 1e3 * n.speed) : ""),
             arg("swept", swept_text(n)), arg("from", curve ? 3 : -2), arg("lateral", curve ? 5 : 2),
             arg("low", 0.8 * n.load), arg("high", 1.2 * n.load), arg("scatter", 0.1 * n.load));
}

void require_curve(const NewScene& n) {
  for (const auto& [given, option, why] :
       {std::tuple{n.superelevation.has_value(), "--superelevation", "straight track has no outer rail"},
        {!n.inner_rail.empty(), "--inner-rail", "straight track has no inner rail"}})
    if (given && !n.is_curve())
      throw InputError(fmt::format("{} has no meaning here", option), why, "Give --curve RADIUS in m too.");
}

ExitCode run_new(const NewScene& asked) {
  if (asked.crossing.number > 0) {
    NewCrossing crossing = asked.crossing;
    crossing.wheel = asked.wheel;
    crossing.wheel_in_scene = name_in_scene(asked.wheel, asked.output);
    crossing.rail = asked.rail;
    crossing.output = asked.output;
    crossing.load = asked.load;
    crossing.friction = asked.friction;
    return write_crossing(crossing);
  }
  require_curve(asked);
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

/// They have no meaning beside those of a curve.
void add_crossing_options(CLI::App& line, NewCrossing& crossing) {
  CLI::Option* number =
      line.add_option("--crossing", crossing.number,
                      "N of a crossing's angle 1:N: a wing rail that leads away and a nose, as sections in a "
                      "folder beside the scene")
          ->check(CLI::Range(4.0, 40.0));
  for (const char* other : {"--curve", "--inner-rail", "--superelevation", "--force-y", "--yaw", "--speed"})
    number->excludes(line.get_option(other));
  line.add_option("--flangeway", crossing.flangeway, "Of a crossing: gap between nose and wing, mm")
      ->check(CLI::Range(30.0, 80.0))
      ->needs(number)
      ->capture_default_str();
  line.add_option("--nose-width", crossing.nose_width, "Of a crossing: where the nose begins, mm")
      ->check(CLI::Range(4.0, 39.0))
      ->needs(number)
      ->capture_default_str();
  line.add_option("--nose-drop", crossing.nose_drop, "Of a crossing: how much lower the nose begins, mm")
      ->check(CLI::Range(0.0, 15.0))
      ->needs(number)
      ->capture_default_str();
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
  line->add_option("--inner-rail", asked->inner_rail,
                   "Standard or profile file of the inner rail of a curve, if it is another one");
  line->add_option("--superelevation", asked->superelevation,
                   "Of the outer rail over the inner one, mm (default in a curve 100)")
      ->check(CLI::Range(-300.0, 300.0));
  line->add_option("--force-y", asked->force_y,
                   "Lateral force on the axle to the right, N; its displacement is found (default in a curve "
                   "an eighth of the axle's load)")
      ->check(CLI::Range(-1e9, 1e9));
  line->add_option("--yaw", asked->yaw,
                   "Yaw of the wheelset, front to the right, rad (default in a curve 0.003)")
      ->check(CLI::Range(-0.1, 0.1));
  add_output_option(*line, "-o,--output", asked->output, "The scene file; without it, standard output");
  add_crossing_options(*line, asked->crossing);
  line->footer(new_help);
  return {line, [asked] { return run_new(*asked); }};
}

} // namespace bem_contact::app
