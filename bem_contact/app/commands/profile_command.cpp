#include "bem_contact/app/command.hpp"
#include "bem_contact/app/commands/section_lines.hpp"
#include "bem_contact/app/output/output_names.hpp"
#include "bem_contact/app/output/placed_standard.hpp"
#include "bem_contact/app/output/profile_report.hpp"
#include "bem_contact/app/settings.hpp"
#include "bem_contact/base/argument_error.hpp"
#include "bem_contact/base/error.hpp"
#include "bem_contact/base/output_file.hpp"
#include "bem_contact/base/printable.hpp"
#include "bem_contact/profile/read_profile.hpp"
#include "bem_contact/profile/standard_profiles.hpp"
#include "bem_contact/record/file_kinds.hpp"
#include "bem_contact/record/json.hpp"
#include "bem_contact/report/report_page.hpp"
#include "bem_contact/scene/scene_file.hpp"
#include "bem_contact/sequence/conformity_record.hpp"
#include "bem_contact/sequence/profile_record.hpp"
#include "bem_contact/sequence/scene_record.hpp"

#include <CLI/CLI.hpp>
#include <cmath>
#include <filesystem>
#include <fmt/format.h>
#include <memory>
#include <ostream>
#include <utility>
#include <vector>

namespace bem_contact::app {

namespace {

constexpr const char* profile_help =
    R"(The file is read as a scene would read it; warnings say what was repaired. It is a measured profile (MiniProf, Simpack,
Vampire, or two columns y and z), the name of a standard (60E1, UIC60, "S1002 h28 e30.5 6.7%"; --list prints all) or a
body file (.toml). Of a slices file (.slcs, .slcw) or a scene with sections it says along which lines these are joined; --csv has
the lines, and --plot or bem_contact plot draws them from above and from the side. The options do what keys
of the same name do in [rail] and [wheel] of a scene (data/scenes/README.md). Example, with a worn wheel of this
project:
    bem_contact profile data/bodies/hollow_wheel.txt --kind wheel
You should see 307 points, 0.5 mm apart. Their noise of 0.05 um needs no smoothing. Then comes the mean radius of every
5 mm of the profile: -13.2 mm (concave) at the root of the flange, 20.0 mm (convex) on its face.

More, and how to draw it: data/tutorial/profile.md.)";

struct ProfileArguments {
  std::string name, kind, unit = "found", profile_z = "as stated", csv, plot, on, body, against;
  ProfileReading reading;
  double step = profile_csv_step;
  bool list = false, json = false;
};

template <NamedEnum E> E choice(const std::string& name) {
  return value_named<E>(name).value(); // it is one of choices()
}

template <NamedEnum E> std::vector<std::string> choices() {
  return {EnumNames<E>::names.begin(), EnumNames<E>::names.end()};
}

/// `depth`: worn off, at each point; none: no such column.
std::string profile_csv(const std::vector<CurvePoint>& points, const std::vector<double>& depth = {}) {
  std::string out = "s_mm,y_mm,z_mm,inclination_rad,curvature_per_mm";
  out += depth.empty() ? "\n" : ",depth_mm\n";
  for (std::size_t i = 0; i < points.size(); ++i) {
    const CurvePoint& p = points[i];
    out += fmt::format("{:.6f},{:.6f},{:.6f},{:.8f},{:.8g}", p.s, p.position.y, p.position.z, p.delta,
                       p.curvature);
    out += depth.empty() ? "\n" : fmt::format(",{:.6f}\n", depth[i]);
  }
  return out;
}

report::DrawnProfile drawn(std::string name, const std::vector<CurvePoint>& points) {
  report::DrawnProfile out{.name = std::move(name), .y = {}, .z = {}, .curvature = {}};
  for (const CurvePoint& p : points) {
    out.y.push_back(p.position.y);
    out.z.push_back(p.position.z);
    out.curvature.push_back(p.curvature);
  }
  return out;
}

/// The profile, then the same as measured if it is smoothed, then the standard that it resembles.
std::vector<report::DrawnProfile> drawn_profiles(const ProfileArguments& arguments,
                                                 const MeasuredProfile& profile,
                                                 const std::optional<LikeStandard>& like, ProfileKind kind) {
  const std::string name = std::filesystem::path(arguments.name).filename().string();
  std::vector<report::DrawnProfile> out{drawn(name, points_along(profile.curve, arguments.step))};
  if (profile.smoothing > 0 || profile.worn) {
    ProfileArguments raw = arguments;
    raw.reading.smoothing = 0;
    raw.reading.nominal.clear();
    out.push_back(drawn(name + ", as measured",
                        points_along(described_profile(raw.name, kind, raw.reading).curve, arguments.step)));
  }
  const std::string usual = kind == ProfileKind::wheel ? "S1002" : "60E1";
  const std::string standard = profile.worn ? arguments.reading.nominal : like ? like->name : usual;
  if (standard != standard_name(arguments.name))
    out.push_back(
        drawn(standard, profile.worn || like
                            ? placed_standard(standard_profile(standard), profile, arguments.step).points
                            : points_along(standard_profile(standard), arguments.step)));
  return out;
}

/// A standard where it lies on a measured profile.
ExitCode run_on(const ProfileArguments& arguments) {
  if (!is_standard_profile(arguments.name))
    throw InputError(fmt::format("'{}' is not laid on {}", arguments.name, arguments.on),
                     "only a standard profile is laid on a measured one", "Name a standard, as 60E1.");
  const ProfileKind kind = kind_of_standard(arguments.name);
  const PlacedStandard placed =
      placed_standard(standard_profile(arguments.name),
                      described_profile(arguments.on, kind, arguments.reading), arguments.step);
  if (!arguments.csv.empty())
    write_text(arguments.csv, [&](std::ostream& out) { out << profile_csv(placed.points, placed.depth); });
  print_out("{} on the unworn part of {}: moved by {:.3f} mm along y and {:.3f} mm along z and turned by "
            "{:.3f} degrees\n",
            arguments.name, std::filesystem::path(arguments.on).filename().string(), placed.place.shift.y,
            placed.place.shift.z, degrees(placed.place.angle));
  return success;
}

/// How the profile fits its counterpart, on a track with the defaults of [position].
std::string fit_text(const ProfileArguments& arguments, const MeasuredProfile& profile, ProfileKind kind) {
  const bool wheel = kind == ProfileKind::wheel;
  const TabulatedProfile own = profile.curve,
                         other =
                             named_profile(arguments.against, wheel ? ProfileKind::rail : ProfileKind::wheel);
  const TabulatedProfile &rail = wheel ? other : own, &running = wheel ? own : other;
  std::string out = fmt::format(
      "  on a track with gauge 1435 mm and flange backs 1360 mm apart, the rail as it is:\n  {}\n",
      conformity_text(conformity_at({}, rail, running), "the middle"));
  if (const auto flange = conformity_at_flange({}, rail, running))
    out += fmt::format(
        "  {}\n", conformity_text(*flange, fmt::format("the gauge corner (lateral displacement {:.3f} mm)",
                                                       flange->lateral)));
  return out;
}

ExitCode run_of_sections(const ProfileArguments& arguments, const SectionLines& lines) {
  if (arguments.json || !arguments.against.empty())
    throw InputError(fmt::format("'{}' holds many profiles", arguments.name),
                     "--json and --against are of one",
                     "Name one of them; --csv has the lines through all, and --plot draws them.");
  if (!arguments.csv.empty())
    write_text(arguments.csv, [&](std::ostream& out) { out << csv_of(lines); });
  if (!arguments.plot.empty())
    report::write_sections_page(std::filesystem::path(arguments.name).filename().string(), lines.words,
                                lines.points, arguments.plot);
  print_out("{}", lines.words);
  return success;
}

ExitCode run(ProfileArguments arguments) {
  if (arguments.list) {
    if (!arguments.name.empty()) // for scripts: which standard is it?
      print_out("{}\n", standard_profile(arguments.name).name());
    else
      print_out("{}", standards_text());
    return success;
  }
  if (arguments.name.empty())
    throw InputError("No profile is named", "`bem_contact profile` describes one",
                     "Name a file or a standard, or give --list for the names of all standards.");
  if (!arguments.body.empty()) {
    write_whole(arguments.body,
                [text = standard_body_file(arguments.name)](std::ostream& out) { out << text; });
    return success;
  }
  arguments.reading.unit = choice<ProfileUnit>(arguments.unit);
  arguments.reading.profile_z = choice<ProfileZ>(arguments.profile_z);
  const std::string& file = arguments.on.empty() ? arguments.name : arguments.on;
  require_named_outputs(paths_of(files_of_key("file.profile", file, {})),
                        {{"--csv", arguments.csv}, {"--plot", arguments.plot}});
  if (!arguments.on.empty())
    return run_on(arguments);
  if (const auto scene = scene_of_sections(arguments.name, arguments.reading)) {
    require_named_outputs(input_files(*scene), {{"--csv", arguments.csv}, {"--plot", arguments.plot}});
    if (const auto lines = section_lines(*scene, arguments.name))
      return run_of_sections(arguments, *lines);
  }
  const ProfileKind kind = kind_of_profile(arguments.name, arguments.kind);
  const MeasuredProfile profile = described_profile(arguments.name, kind, arguments.reading);
  if (!arguments.csv.empty())
    write_text(arguments.csv,
               [&](std::ostream& out) { out << profile_csv(points_along(profile.curve, arguments.step)); });
  const ProfileFindings found = findings_of(profile, kind, arguments.reading);
  const std::string words = to_text(profile, found, kind);
  if (!arguments.plot.empty())
    report::write_profile_page(std::filesystem::path(arguments.name).filename().string(), words,
                               drawn_profiles(arguments, profile, found.like, kind), arguments.plot);
  if (arguments.json) {
    print_out("{}\n", record::to_json(
                          headed(profile_format).append(record_of(profile, found, kind, arguments.step))));
    return success;
  }
  print_out("{}{}", words, arguments.against.empty() ? "" : fit_text(arguments, profile, kind));
  return success;
}

} // namespace

Command add_profile(CLI::App& program) {
  const auto arguments = std::make_shared<ProfileArguments>();
  CLI::App* line =
      program.add_subcommand("profile", "Describe a profile file: noise, radii, what was repaired");
  line->add_option("file", arguments->name, "Measured profile, name of a standard, or body file");
  line->add_flag(
      "--list", arguments->list,
      "Print the names of all standards that are built in, a line each; with a name: which one it is");
  add_output_option(*line, "--body", arguments->body,
                    "Of a standard: write the body file (TOML) of its influence functions, and nothing else");
  line->add_option(
      "--against", arguments->against,
      "The other profile of a pair: say how closely they fit, in the middle of the track and with the "
      "flange root at the gauge corner (another track: bem_contact check SCENE)");
  line->add_option("--kind", arguments->kind,
                   "rail or wheel; needed where neither the file nor its ending says it")
      ->check(CLI::IsMember({"rail", "wheel"}));
  line->add_option(
          "--smoothing", arguments->reading.smoothing,
          "Remove waves shorter than this, mm; 0, the default: remove nothing, or with --nominal find the "
          "length from the points")
      ->check(CLI::Range(0.0, 50.0));
  line->add_option(
      "--nominal", arguments->reading.nominal,
      "Standard profile from which it was made (S1002, 60E1): only the depth worn off it is smoothed");
  line->add_option("--unit", arguments->unit,
                   "Unit of the file; found, the default: by the size of the profile")
      ->check(CLI::IsMember(choices<ProfileUnit>()));
  line->add_option("--profile-z", arguments->profile_z,
                   "Where z of the file points; 'as stated', the default: what its format says")
      ->check(CLI::IsMember(choices<ProfileZ>()));
  line->add_flag("--mirror", arguments->reading.mirror,
                 "y of the file points to the gauge side: turn it, y is to point to the field side");
  line->add_option("--flange-back", arguments->reading.flange_back,
                   "Wheel: y of the back of the flange in the file, mm. It places the wheel laterally");
  line->add_flag("--keep-origin", arguments->reading.keep_origin,
                 "Keep y and z as the file has them (a scene: place = \"absolute\")");
  line->add_option("--on", arguments->on,
                   "A measured profile: lay the standard that is named on its unworn part; the table gets a "
                   "column with the depth worn off the standard along its normal");
  add_output_option(*line, "--csv", arguments->csv,
                    "Write arc length, y, z, inclination and curvature to this file");
  add_output_option(*line, "--plot", arguments->plot,
                    "Write a page (HTML) that draws outline and curvature, with the standard beside them; of "
                    "sections the lines along which they are joined");
  line->add_option("--step", arguments->step, "Longest step of table and page, mm")
      ->check(CLI::Range(1e-3, 100.0));
  add_json(*line, arguments->json);
  line->footer(profile_help);
  return {line, [arguments] { return run(*arguments); }};
}

} // namespace bem_contact::app
