#include "bem_contact/profile/read_profile.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/base/input_file.hpp"
#include "bem_contact/profile/formats/profile_formats.hpp"
#include "bem_contact/profile/measured/profile_repair.hpp"
#include "bem_contact/profile/measured/profile_smoothing.hpp"
#include "bem_contact/profile/measured/worn_side.hpp"
#include "bem_contact/profile/messages.hpp"
#include "bem_contact/profile/settings.hpp"
#include "bem_contact/profile/standard_profiles.hpp"
#include "bem_contact/profile/worn/like_standard.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>
#include <span>
#include <utility>
#include <vector>

namespace bem_contact {

namespace {

/// 1. What is removed may exceed the noise by this factor. More is shape.
constexpr double removed_over_noise = 2.0;
/// mm. Less removed shape does not matter. Chosen: below it no pressure moved by 1 %.
constexpr double least_removed = 5e-4;
/// 1 (share of the advised smoothing). Less leaves noise that shows: its pressure grows by half.
constexpr double least_smoothing_share = 0.85;

/// A wheel that comes with its own distance of the tape circle from the flange back.
void require_tape_circle(std::string_view name, double its, const ProfileReading& reading) {
  if (its != reading.tape_circle)
    throw InputError(fmt::format("The tape circle of {} is {:g} mm from its flange back", name, its),
                     fmt::format("position.tape_circle is {:g} mm", reading.tape_circle),
                     fmt::format("Give position.tape_circle = {:g} with this wheel.", its));
}

/// The material of its body lies below.
bool faces_up(const ProfileCurve& curve) {
  return std::cos(curve.at((curve.s_begin() + curve.s_end()) / 2).delta) > 0;
}

/// Of a body file: that of a rail has its material below. Nothing: it is none, or a wrong one.
std::optional<ProfileKind> kind_of_body(const std::filesystem::path& file) {
  try {
    return faces_up(body_profile(read_body_file(file))) ? ProfileKind::rail : ProfileKind::wheel;
  } catch (const InputError&) {
    return std::nullopt;
  }
}

/// The contact curve of a body file; a rail is walked towards +y, a wheel towards -y.
ProfileCurve profile_of_body(const std::filesystem::path& file, ProfileKind kind,
                             const ProfileReading& reading) {
  const BodyFile body = read_body_file(file);
  if (kind == ProfileKind::wheel && body.body.kind != BodyKind::outline)
    require_tape_circle(file.string(), body.body.reading.tape_circle, reading);
  if (body.body.profile.ends_with(".toml"))
    throw InputError(
        fmt::format("{} names the body file {} as its profile", file.string(), body.body.profile),
        "the profile of a body is a standard or a file of points", "Name that.");
  ProfileCurve curve = body_profile(body);
  if (faces_up(curve) != (kind == ProfileKind::rail))
    throw InputError(fmt::format("The body in {} is {} body", file.string(),
                                 kind == ProfileKind::rail ? "an upper" : "a lower"),
                     fmt::format("a {} is asked for", name_of(kind)),
                     "Walk its contact surface the other way round, the material on the other side.");
  if (kind == ProfileKind::rail && body.body.kind == BodyKind::outline && body.body.reference_radius > 0)
    throw InputError(
        fmt::format("The body in {} is no rail: it is curved along x, about an axle {:g} mm above",
                    file.string(), body.body.reference_radius),
        "the distance of the surfaces is that to a straight rail",
        "Use kind = \"patch\": gap.a has the curvatures along x, and influence files of rings serve there.");
  return curve;
}

std::string file_name(const std::string& source) {
  return std::filesystem::path(source).filename().string();
}

std::string waves_text(const ProfileNoise& noise) {
  return noise.waves > 0 ? fmt::format(", and have waves of 2 to 10 mm, {:.2g} um high", 1e3 * noise.waves)
                         : "";
}

/// Advises the standard that it is like as nominal, else smoothing alone.
void warn_of_noise(const std::string& source, const MeasuredProfile& p, ProfileKind kind,
                   ReadingAdvice& advice) {
  const std::optional<LikeStandard> like = like_standard(p.curve, kind, p.scatter_left());
  const std::string better =
      like ? fmt::format("; as it looks like {} worn by {:.2g} .. {:.2g} mm, nominal = \"{}\" keeps more of "
                         "its shape",
                         like->name, like->least_depth, like->largest_depth, like->name)
           : "";
  advice.nominal = like ? like->name : "";
  advice.smoothing = p.noise.smoothing;
  advice.noise_text = fmt::format(
      "{}: its points scatter by {:.2g} um, {:.2g} mm apart{}: a curve through all of them bends to radii of "
      "{:.2g} mm, which moves pressures between steel bodies by some {:.0f} MPa and may split patches "
      "(smoothing = {:.2g} removes it{})",
      source, 1e3 * p.noise.scatter, p.noise.spacing, waves_text(p.noise), 1 / p.noise.bending,
      p.noise.pressure, p.noise.smoothing, better);
  say_warning("{}", advice.noise_text);
}

void warn_of_outliers(const std::string& source, const std::vector<Outlier>& outliers) {
  for (std::size_t i = 0; i < std::min(outliers.size(), most_named_outliers); ++i)
    say_warning("{}: the point y = {:.4g}, z = {:.4g} lies {:.2g} mm off the line of its neighbours: a curve "
                "through it has a bump there (dirt, or a fault of the measurement?) Take the point out.",
                source, outliers[i].point.y, outliers[i].point.z, outliers[i].distance);
  if (outliers.size() > most_named_outliers)
    say_warning("{}: and {} more such points", source, outliers.size() - most_named_outliers);
}

void warn_of_worn_side(const std::string& source, std::span<const Point2> points, bool mirror,
                       ReadingAdvice& advice) {
  const double worn = more_worn_at_larger_y(points);
  if (worn <= 0)
    return;
  advice.mirror = !mirror;
  advice.mirror_text = fmt::format(
      "{}: its field side (y > 0) is worn by some {:.2g} mm more than its gauge side, and rails wear on "
      "the gauge side: does y of the file point there? (mirror = {} turns it)",
      source, worn, !mirror);
  say_warning("{}", advice.mirror_text);
}

/// The nominal profile that `reading` names.
ProfileCurve nominal_profile(const std::string& name, ProfileKind kind, const std::string& source) {
  if (is_standard_profile(name) && kind_of_standard(name) == kind)
    return standard_profile(name);
  throw InputError(fmt::format("{}: nominal = \"{}\" is not known", source, name),
                   fmt::format("it is the standard profile from which a {} was made", name_of(kind)),
                   advice_on_name(name, kind) + " Or leave out nominal and give smoothing.");
}

void report_smoothing(const std::string& source, const MeasuredProfile& p) {
  say_info("{}: smoothed, waves shorter than {} mm removed: {:.2g} um root mean square, {:.2g} um at most",
           source, wavelength_text(p), 1e3 * p.removed_rms, 1e3 * p.removed_most);
}

void warn_of_smoothing(const std::string& source, const MeasuredProfile& p) {
  if (p.smoothing < least_smoothing_share * p.noise.smoothing)
    say_warning("{}: smoothing = {:g} leaves noise: for {} use {:.2g}", source, p.smoothing,
                p.noise.waves > 0 ? fmt::format("waves of {:.2g} um", 1e3 * p.noise.waves)
                                  : fmt::format("a scatter of {:.2g} um", 1e3 * p.noise.scatter),
                p.noise.smoothing);
  if (p.takes_shape_away())
    say_warning(
        "{}: smoothing = {:g} takes shape away: it moved points by {:.2g} um (root mean square), and their "
        "noise is {:.2g} um: use {}",
        source, p.smoothing, 1e3 * p.removed_rms, 1e3 * std::hypot(p.noise.scatter, p.noise.waves),
        p.noise.smoothing > 0 ? fmt::format("{:.2g}", p.noise.smoothing) : "none");
}

/// Smoothed as `reading` asks; something is asked.
MeasuredProfile smoothed_profile(const std::string& source, std::span<const Point2> points,
                                 const ProfileNoise& noise, ProfileKind kind, const ProfileReading& reading) {
  if (reading.nominal.empty()) {
    SmoothedProfile smooth = smoothed(points, reading.smoothing);
    return {ProfileCurve::through_points(file_name(source), smooth.points, smooth.kinks),
            smooth.points.size(),
            noise,
            reading.smoothing,
            smooth.rms,
            smooth.largest};
  }
  WornNominal worn = worn_from_nominal(nominal_profile(reading.nominal, kind, source), points, noise.as_white,
                                       reading.smoothing, source);
  say_info("{}: {}", source, worn_text(worn));
  if (!worn.doubt.empty())
    say_warning(
        "{}: {} does not fit ({}). Name the profile from which it was made, or leave out nominal and give "
        "smoothing.",
        source, worn.nominal, worn.doubt);
  MeasuredProfile out{worn.curve, worn.points, noise, worn.longest_wave, worn.removed_rms, worn.removed_most};
  out.worn = std::move(worn);
  return out;
}

/// A standard's name means the standard, whatever lies in the folder.
void warn_of_hidden_file(const std::string& name, const std::filesystem::path& folder) {
  if (const std::filesystem::path file = folder / name; file_exists(file))
    say_warning("{} is the standard profile; the file {} of this name is not read (\"./{}\" reads it)", name,
                file.string(), name);
}

} // namespace

MeasuredProfile parse_measured_profile(std::string_view text, std::string_view source_name, ProfileKind kind,
                                       const ProfileReading& reading, int part) {
  const std::string source(source_name);
  if (text.starts_with("\x89HDF"))
    throw InputError(fmt::format("{} is no profile", source),
                     "it is an HDF5 file, and a profile is a table of points",
                     fmt::format("If it is an influence file, give it as {}.influence.", name_of(kind)));
  if (text.starts_with("\xef\xbb\xbf")) // a byte order mark
    text.remove_prefix(3);
  if (std::ranges::count(text, '\n') > most_points)
    throw InputError(fmt::format("The profile {} has more than {} points", source, most_points),
                     "a measured profile has some thousands", "Take fewer of its points.");
  MeasuredPoints measured = points_of(text, source, kind, part, reading);
  ProfileReading how = reading;
  how.mirror = reading.mirror && !is_vampire(text); // there it has chosen the left profile, mirrored
  const std::vector<Point2> points = repaired(std::move(measured), source, kind, how);
  ReadingAdvice advice;
  if (kind == ProfileKind::rail && !reading.keep_origin)
    warn_of_worn_side(source, points, reading.mirror, advice);
  const ProfileNoise noise = measure_noise(points);
  if (noise.coarse)
    say_warning("{}: {} points, {:.2g} mm apart: too few for a curved profile (arcs of rails and wheels have "
                "radii down to 13 mm). Give points at most {:g} mm apart.",
                source, points.size(), noise.spacing, coarsest_spacing);
  std::vector<Outlier> off = outliers(points, noise.scatter);
  warn_of_outliers(source, off);
  if (reading.smoothing == 0 && reading.nominal.empty()) {
    MeasuredProfile out{ProfileCurve::through_points(file_name(source), points), points.size(), noise};
    out.outliers = std::move(off);
    if (noise.smoothing > 0)
      warn_of_noise(source, out, kind, advice);
    out.advice = std::move(advice);
    return out;
  }
  MeasuredProfile out = smoothed_profile(source, points, noise, kind, reading);
  out.outliers = std::move(off);
  out.advice = std::move(advice);
  report_smoothing(source, out);
  if (reading.smoothing > 0)
    warn_of_smoothing(source, out);
  return out;
}

double MeasuredProfile::largest_noise_removed() const {
  const double along_and_across = worn ? 1 : std::sqrt(2.0); // a depth alone; or along y and along z
  return std::max(removed_over_noise * along_and_across * std::hypot(noise.scatter, noise.waves),
                  least_removed);
}

bool MeasuredProfile::takes_shape_away() const {
  return smoothing * least_smoothing_share > noise.smoothing && removed_rms > largest_noise_removed();
}

std::optional<ProfileKind> kind_of_ending(const std::filesystem::path& file) {
  const std::string ending = lower_ending(file);
  if (ending == ".prw" || ending == ".whl" || ending == ".whe")
    return ProfileKind::wheel;
  if (ending == ".prr" || ending == ".ban" || ending == ".rai")
    return ProfileKind::rail;
  return std::nullopt;
}

MeasuredProfile measured_profile(const std::filesystem::path& file, ProfileKind kind,
                                 const ProfileReading& reading, int part) {
  if (const auto its = kind_of_ending(file); its && *its != kind)
    say_warning("{}: read as the profile of a {}, but {} is the ending of {} profiles", file.string(),
                name_of(kind), file.extension().string(), name_of(*its));
  return parse_measured_profile(read_text_file(file.string(), "profile file"), file.string(), kind, reading,
                                part);
}

std::string wavelength_text(const MeasuredProfile& p) {
  return p.worn && p.worn->shortest_wave < p.worn->longest_wave
             ? fmt::format("{:.2g} .. {:.2g}", p.worn->shortest_wave, p.worn->longest_wave)
             : fmt::format("{:g}", p.smoothing);
}

ProfileFileName profile_file_name(std::string_view name, const std::filesystem::path& folder) {
  const std::filesystem::path whole = folder / std::filesystem::path(name); // an absolute path stays itself
  const auto hash = name.rfind('#');
  if (hash == std::string_view::npos || file_exists(whole))
    return {whole};
  int part = 0;
  const char* end = name.data() + name.size();
  const auto [stop, problem] = std::from_chars(name.data() + hash + 1, end, part);
  if (problem != std::errc{} || stop != end || part < 1)
    return {whole};
  return {folder / std::filesystem::path(name.substr(0, hash)), part};
}

ProfileCurve named_profile(std::string_view name, ProfileKind kind, const std::filesystem::path& folder,
                           const ProfileReading& reading) {
  if (is_standard_profile(name)) {
    if (const ProfileKind its_kind = kind_of_standard(name); its_kind != kind)
      throw InputError(fmt::format("{} is the profile of a {}", name, name_of(its_kind)),
                       fmt::format("a {} is asked for", name_of(kind)),
                       kind == ProfileKind::rail ? "Use for instance 60E1." : "Use for instance S1002.");
    if (kind == ProfileKind::wheel)
      require_tape_circle(name, flange_back_to_tape_circle, reading);
    warn_of_hidden_file(std::string(name), folder);
    return standard_profile(name);
  }
  const auto [file, part] = profile_file_name(name, folder);
  if (!file_exists(file)) {
    throw InputError(fmt::format("Unknown profile '{}'", name),
                     fmt::format("it is no standard's name and there is no file {}", file.string()),
                     advice_on_name(name));
  }
  return file.extension() == ".toml" ? profile_of_body(file, kind, reading)
                                     : measured_profile(file, kind, reading, part).curve;
}

MeasuredProfile described_profile(const std::string& name, ProfileKind kind, const ProfileReading& reading) {
  const auto [file, part] = profile_file_name(name);
  if (is_standard_profile(name) || file.extension() == ".toml" || !file_exists(file))
    return {.curve = named_profile(name, kind), .noise = {}}; // it says what is wrong with a name
  return measured_profile(file, kind, reading, part);
}

ProfileKind kind_of_profile(const std::string& name, const std::string& kind) {
  if (!kind.empty())
    return kind == "wheel" ? ProfileKind::wheel : ProfileKind::rail;
  if (is_standard_profile(name))
    return kind_of_standard(name);
  const std::filesystem::path file = profile_file_name(name).file;
  if (const auto its = kind_of_ending(file))
    return *its;
  if (!file_exists(file))
    named_profile(name, ProfileKind::rail); // it says that there is no such file
  if (const auto its = file.extension() == ".toml" ? kind_of_body(file) : std::nullopt)
    return *its;
  throw InputError(
      fmt::format("'{}' is the profile of a rail or of a wheel", name),
      "neither its name nor its ending says which",
      file.extension() == ".toml"
          ? "Say --kind rail or --kind wheel (Python: kind=\"rail\"); if it is a scene, solve it "
            "first (-o R.h5)."
          : "Say --kind rail or --kind wheel (Python: kind=\"rail\").");
}

} // namespace bem_contact
