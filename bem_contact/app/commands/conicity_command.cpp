#include "bem_contact/app/command.hpp"
#include "bem_contact/app/commands/conicity_maps.hpp"
#include "bem_contact/app/output/output_names.hpp"
#include "bem_contact/app/output/print_answer.hpp"
#include "bem_contact/base/argument_error.hpp"
#include "bem_contact/base/error.hpp"
#include "bem_contact/base/input_file.hpp"
#include "bem_contact/base/output_file.hpp"
#include "bem_contact/base/progress.hpp"
#include "bem_contact/profile/read_profile.hpp"
#include "bem_contact/profile/standard_profiles.hpp"
#include "bem_contact/record/csv.hpp"
#include "bem_contact/record/file_kinds.hpp"
#include "bem_contact/record/hdf5.hpp"
#include "bem_contact/scene/network.hpp"
#include "bem_contact/sequence/conformity_record.hpp"
#include "bem_contact/sequence/scene_record.hpp"
#include "bem_contact/uses/conicity/wheelset_conicity.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fmt/format.h>
#include <iterator>
#include <memory>
#include <ostream>
#include <string>
#include <tuple>

namespace bem_contact::app {

namespace {

constexpr const char* conicity_help =
    R"(A rigid wheelset is moved sideways on its track: where do its wheels touch, how much do their rolling radii differ, and
which cone would run with the same wavelength (EN 15302)? Profiles and track come from a scene, from options, or from
both; load, motion, and the displacement, roll and yaw of the scene's [position] do not count. Example:
    bem_contact conicity --wheel S1002 --rail 60E1 --rail-inclination 0.025
You should see the contact points for each millimetre from -12 to 12 mm and, for an amplitude of 3 mm, a conicity of
0.1741 and a wavelength of 8.844 m. "none": no motion has this amplitude.

With --wheels, --rails, --gauges or --noise the answer is a map: a line for each wheel on each rail at each gauge, and, with
--noise, how far the conicity scatters where the points of the profiles do (seeded draws, smoothed as the program advises):
    bem_contact conicity --wheels S1002 LMA --rails 60E1 --rail-inclination 0.025 --gauges 1433:1437:3 --noise 0.01

More, and how to draw it: data/tutorial/conicity.md.)";

struct ConicityArguments {
  std::string scene, csv, output;
  std::vector<SceneChange> changes;
  LeftProfiles left;
  Amplitudes amplitudes;
  MapArguments map;
  bool rolls = false, json = false;
};

/// A profile's name as a scene understands it from any folder: files are given from the working directory.
std::string from_here(const std::string& name) {
  const ProfileFileName given = profile_file_name(name);
  if (is_standard_profile(name) || !file_exists(given.file))
    return name;
  const std::string file = std::filesystem::absolute(given.file).string();
  return given.part > 0 ? fmt::format("{}#{}", file, given.part) : file;
}

/// The scene of the file and the options. Without a file its text has all keys.
GivenScene given_scene(const ConicityArguments& arguments) {
  if (!arguments.scene.empty())
    return read_given_scene(arguments.scene, "", arguments.changes);
  for (const auto& [key, option, example] :
       {std::tuple{"wheel.profile", "--wheel", "S1002"}, {"rail.profile", "--rail", "60E1"}})
    if (std::ranges::count(arguments.changes, key, &SceneChange::key) == 0)
      throw InputError(
          fmt::format("{} is not given", option), "without a scene it says what touches",
          fmt::format("Give a standard or a profile file, for instance {} {}.", option, example));
  const SceneFile scene = scene_without_file(arguments.changes);
  return {{scene_with_defaults(scene), "options"}, "", scene, {}};
}

std::vector<NamedFile> left_files(const LeftProfiles& left) {
  std::vector<NamedFile> files = files_of_key("left_rail.profile", left.rail, {});
  std::ranges::move(files_of_key("left_wheel.profile", left.wheel, {}), std::back_inserter(files));
  return files;
}

bool is_whole(double millimetres) {
  return std::abs(millimetres - std::round(millimetres)) < 1e-9;
}

std::string head(const WheelsetConicity& c, const WheelsetOnTrack& w, const SceneFile& scene) {
  std::string out = track_text(scene) + "\n";
  out += fmt::format("Wheelset: right {} on {}, left {} on {}\n", w.right_wheel.name(), w.right_rail.name(),
                     w.left_wheel.name(), w.left_rail.name());
  out +=
      fmt::format("  wheel radius {:g} mm, contact circles {:g} mm apart, rails inclined by {:g} rad{}; {}\n",
                  c.lengths.wheel_radius, c.lengths.contact_distance, w.position.rail_inclination,
                  w.position.rail_origin ? std::string()
                                         : fmt::format(", gauge {:g} mm ({:g} mm below the top)",
                                                       w.position.gauge, w.position.gauge_height),
                  w.rolls ? "rolls until both wheels stand" : "upright");
  return out;
}

/// What follows from both tables, a line each.
std::string rated_text(const WheelsetConicity& c) {
  const std::string play = std::isnan(c.play) ? "" : fmt::format(" (the play is {:.2f} mm)", c.play);
  std::string out =
      std::isnan(c.nonlinearity)
          ? fmt::format("nonlinearity: none, for there is no motion of both {:g} and {:g} mm{}\n",
                        c.rated_amplitude - 1, c.rated_amplitude + 1, play)
          : fmt::format("nonlinearity {:+.4f} /mm: of tan gamma from an amplitude of {:g} to {:g} mm{}\n",
                        c.nonlinearity, c.rated_amplitude - 1, c.rated_amplitude + 1, play);
  for (const Conformity& fit : c.conformity)
    out += conformity_text(
               fit, &fit == &c.conformity.front()
                        ? "the middle"
                        : fmt::format("the gauge corner (lateral displacement {:.3f} mm)", fit.lateral)) +
           "\n";
  return out;
}

/// Tables for people: the contact at whole millimetres of displacement, and the conicity by amplitude.
std::string conicity_text(const WheelsetConicity& c, const WheelsetOnTrack& w, const SceneFile& scene) {
  std::string out = head(c, w, scene);
  out += "Rolling radius difference and contact points, mm (y to the field side of each body)\n";
  out += "    lateral  difference   radius right   wheel y    rail y    radius left   wheel y    rail y\n";
  for (const WheelsetStand& s : c.stands)
    if (is_whole(s.lateral))
      out += fmt::format("  {:9.1f} {:11.4f} {:14.4f} {:9.2f} {:9.2f} {:14.4f} {:9.2f} {:9.2f}\n", s.lateral,
                         s.difference(), s.right.radius, s.right.wheel.y, s.right.rail.y, s.left.radius,
                         s.left.wheel.y, s.left.rail.y);
  out += "Equivalent conicity (EN 15302)\n  amplitude mm  tan gamma  wavelength m   from mm     to mm\n";
  for (const WheelsetConicity::Value& v : c.values)
    out += v.motion
               ? fmt::format("  {:12g} {:10.4f} {:13.3f} {:9.3f} {:9.3f}\n", v.amplitude, v.motion->tan_gamma,
                             1e-3 * v.motion->wavelength, v.motion->from, v.motion->to)
               : fmt::format("  {:12g} {:>10} {:>13}\n", v.amplitude, "none", "none");
  return out + rated_text(c);
}

/// Profiles of a map as inputs, "wheels.0001.profile" and so on.
std::vector<NamedFile> files_of(const ConicityMapRange& range, const std::filesystem::path& folder) {
  std::vector<NamedFile> out;
  for (const auto& [body, names] : {std::pair{"wheels", &range.wheels}, {"rails", &range.rails}})
    for (std::size_t k = 0; k < names->size(); ++k)
      std::ranges::move(files_of_key(fmt::format("{}.{:04}.profile", body, k + 1), (*names)[k], folder),
                        std::back_inserter(out));
  return out;
}

/// The options with the profiles of one pair; "": what the options say already.
ConicityArguments of_pair(ConicityArguments arguments, const std::string& wheel, const std::string& rail) {
  for (const auto& [key, name] : {std::pair{"wheel.profile", &wheel}, {"rail.profile", &rail}})
    if (!name->empty())
      arguments.changes.push_back({key, *name});
  return arguments;
}

/// What the map is of. Names of files hold from any folder; lists that are not given stay empty.
ConicityMapRange range_from_here(const ConicityArguments& arguments) {
  if (!arguments.left.wheel.empty() || !arguments.left.rail.empty())
    throw InputError("A map has no --left-wheel and no --left-rail",
                     "both sides have the same profiles there", "Leave them out, or ask for one wheelset.");
  ConicityMapRange range = map_range(arguments.map, arguments.rolls);
  for (std::vector<std::string>* names : {&range.wheels, &range.rails})
    std::ranges::transform(*names, names->begin(), from_here);
  return range;
}

ExitCode run_map(const ConicityArguments& arguments) {
  ConicityMapRange range = range_from_here(arguments);
  const auto first = [](const std::vector<std::string>& names) {
    return names.empty() ? std::string() : names.front();
  };
  GivenScene given = given_scene(of_pair(arguments, first(range.wheels), first(range.rails)));
  if (range.wheels.empty())
    range.wheels = {given.scene.wheel.profile};
  if (range.rails.empty())
    range.rails = {given.scene.rail.profile};
  if (!arguments.csv.empty())
    for (const auto& [what, names] : {std::pair{"wheel", &range.wheels}, {"rail", &range.rails}})
      for (const std::string& name : *names)
        record::require_cell(name, what);
  const std::vector<NamedFile> files = files_of(range, given.scene.folder);
  std::vector<std::filesystem::path> inputs = files_read(arguments.scene, given.scene);
  std::ranges::move(paths_of(files), std::back_inserter(inputs));
  require_named_outputs(inputs,
                        {{"--output", arguments.output, OutputForm::whole_file}, {"--csv", arguments.csv}});
  if (!arguments.output.empty())
    given.inputs = records_of(files);
  Progress progress("wheelsets",
                    range.wheels.size() * range.rails.size() * std::max<std::size_t>(1, range.gauges.size()));
  const ConicityMap map = conicity_map(
      range,
      [&](const std::string& wheel, const std::string& rail) {
        const std::vector<SceneChange> changes = of_pair(arguments, wheel, rail).changes;
        return arguments.scene.empty() ? scene_without_file(changes) : parse_scene_file(given.text, changes);
      },
      [&] { progress.step(); });
  progress.finish();
  if (!arguments.output.empty())
    record::write_hdf5(arguments.output,
                       headed(conicity_map_format, given, arguments.output).append(record_of(map)));
  if (!arguments.csv.empty())
    write_text(arguments.csv, [&](std::ostream& out) { write_map_csv(out, map); });
  print_answer(headed(conicity_map_format).append(record_of(map)), arguments.json,
               track_text(given.scene) + "\n" + map_text(map));
  return success;
}

ExitCode run(const ConicityArguments& arguments) {
  if (arguments.map.asked())
    return run_map(arguments);
  GivenScene given = given_scene(arguments);
  const std::vector<NamedFile> left = left_files(arguments.left);
  std::vector<std::filesystem::path> inputs = files_read(arguments.scene, given.scene);
  std::ranges::move(paths_of(left), std::back_inserter(inputs));
  require_named_outputs(inputs,
                        {{"--output", arguments.output, OutputForm::whole_file}, {"--csv", arguments.csv}});
  if (!arguments.output.empty()) {
    given.inputs = inputs_of(given.scene);
    std::ranges::move(records_of(left), std::back_inserter(given.inputs));
  }
  WheelsetOnTrack wheelset = wheelset_of(given.scene, arguments.left);
  wheelset.rolls = arguments.rolls;
  const WheelsetConicity conicity = wheelset_conicity(wheelset, arguments.amplitudes);
  if (!arguments.output.empty())
    record::write_hdf5(
        arguments.output,
        headed(conicity_format, given, arguments.output).append(record_of(conicity, wheelset)));
  if (!arguments.csv.empty())
    write_text(arguments.csv, [&](std::ostream& out) {
      record::write_csv(out, record::table_of("displacement", stand_columns(), conicity.stands));
    });
  print_answer(headed(conicity_format).append(record_of(conicity, wheelset)), arguments.json,
               conicity_text(conicity, wheelset, given.scene));
  return success;
}

/// Options that give a key of a scene.
void add_keys(CLI::App& line, const std::shared_ptr<ConicityArguments>& arguments) {
  const auto profile = [&](const char* option, const char* key, const char* what) {
    line.add_option_function<std::string>(
            option,
            [=](const std::string& name) {
              arguments->changes.push_back({key, from_here(name)});
            },
            what)
        ->configurable(false); // the scene has a key for it
  };
  profile("--wheel", "wheel.profile", "Standard or profile file of the wheels");
  profile("--rail", "rail.profile", "Standard or profile file of the rails");
  const auto number = [&](const char* option, const char* key, const char* what) {
    line.add_option_function<double>(
            option,
            [=](const double& value) {
              arguments->changes.push_back({key, value});
            },
            what)
        ->configurable(false)
        ->check([](const std::string& text) {
          const std::optional<double> fraction = fraction_of(text);
          return fraction ? fmt::format("{} is a fraction: write {:.6g}", text, *fraction) : std::string();
        });
  };
  number("--gauge", "position.gauge", "Track gauge, mm");
  number("--gauge-height", "position.gauge_height",
         "Depth below the top of the rail where the gauge is measured, mm");
  number("--rail-inclination,--cant", "position.rail_inclination",
         "Inclination of the rails towards the track's centre, rad (1:40 is 0.025)");
  number("--back-to-back", "position.back_to_back", "Distance of the flange backs, mm");
  number("--tape-circle", "position.tape_circle", "Distance of the tape circle from the flange back, mm");
  line.add_option_function<std::string>(
          "--network",
          [=](const std::string& name) {
            arguments->changes.push_back({"track.network", name});
          },
          "Whose gauge, flange backs and inclination are the defaults: UIC, GB, China, AREMA")
      ->configurable(false); // the scene has a key for it
  number("--wheel-radius", "position.wheel_radius", "At the tape circle, mm");
}

} // namespace

Command add_conicity(CLI::App& program) {
  const auto arguments = std::make_shared<ConicityArguments>();
  CLI::App* line =
      program.add_subcommand("conicity", "Rolling radius difference and equivalent conicity of a wheelset");
  line->add_option("scene", arguments->scene, "Scene file (TOML) with profiles and track");
  add_keys(*line, arguments);
  const auto left = [&](const char* option, std::string LeftProfiles::*member, const char* what) {
    line->add_option_function<std::string>(
            option, [=](const std::string& name) { arguments->left.*member = from_here(name); }, what)
        ->configurable(false);
  };
  left("--left-wheel", &LeftProfiles::wheel,
       "The left wheel, if it has another profile (y to the field side)");
  left("--left-rail", &LeftProfiles::rail, "The left rail, if it has another profile");
  line->add_flag("--roll", arguments->rolls, "Let the wheelset roll until both wheels stand on their rails");
  line->add_option("--to", arguments->amplitudes.largest, "Largest amplitude, mm")->capture_default_str();
  line->add_option("--step", arguments->amplitudes.step, "Step of the amplitudes, mm")->capture_default_str();
  add_map_options(*line, arguments->map);
  add_json(*line, arguments->json);
  add_output_option(*line, "--csv", arguments->csv,
                    "Write radius difference and contact points over the displacement; of a map, its lines");
  add_output_option(*line, "-o,--output", arguments->output, "Write all results (HDF5)");
  line->footer(conicity_help);
  return {line, [arguments] { return run(*arguments); }};
}

} // namespace bem_contact::app
