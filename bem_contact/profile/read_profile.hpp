#pragma once

#include "bem_contact/profile/measured/outliers.hpp"
#include "bem_contact/profile/measured/profile_noise.hpp"
#include "bem_contact/profile/profile_curve.hpp"
#include "bem_contact/profile/profile_kind.hpp"
#include "bem_contact/profile/profile_reading.hpp"
#include "bem_contact/profile/worn/worn_nominal.hpp"

#include <cmath>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace bem_contact {

/// What the warnings of a profile file advise to give: keys of [rail] and [wheel].
struct ReadingAdvice {
  std::string nominal =
      {};               ///< the standard from which it may be worn: it keeps more than smoothing; "": none
  double smoothing = 0; ///< mm; 0: no noise that matters
  std::optional<bool> mirror = {};
  std::string noise_text = {}, mirror_text = {}; ///< the warnings that advise it
};

/// A profile file, and what was found out about it on the way.
struct MeasuredProfile {
  ProfileCurve curve;
  std::size_t points = 0;  ///< that the curve goes through
  ProfileNoise noise;      ///< of the points as measured
  double smoothing = 0;    ///< shortest wavelength kept, mm; 0: not smoothed; the longest of several
  double removed_rms = 0;  ///< by smoothing, mm
  double removed_most = 0; ///< mm
  std::optional<WornNominal> worn = {}; ///< if reading.nominal is given
  std::vector<Outlier> outliers = {};   ///< of the points as measured
  ReadingAdvice advice = {};
  /// What smoothing may remove if it removes noise alone, mm (root mean square).
  double largest_noise_removed() const;
  /// Whether more is removed, by a wavelength longer than what is advised: then it is shape.
  bool takes_shape_away() const;
  /// Returns the scatter of the curve about the true profile, mm: that of the points, where it goes through
  /// all of them and their noise is known; else 0.
  double scatter_left() const {
    return smoothing > 0 || worn || noise.coarse ? 0 : std::hypot(noise.scatter, noise.waves);
  }
};

/// Reads a profile file: Simpack .prr/.prw, MiniProf .ban/.whl/.mpt, Vampire .rai/.whe (told by their
/// contents), else plain columns "y z". The curve's frame is that of ProfileCurve: mm, y to the right (rail:
/// 0 where the file has it, wheel: 0 at the tape circle), z down. `part`: which profile of a file with
/// several, from 1; 0: the only one.
///
/// Points may come in either walking order. Repaired, with a warning (spdlog): metres for millimetres, z
/// upward, a wheel's flange at y > 0, a wheel's y measured from the back of its flange, shuffled points,
/// doubled or crowded points (nearer than 0.01 mm), single points that zig-zag, loops shorter than 1 mm,
/// marks of missing values, dense scans that run back and forth, a closed outline of a rail, a rail that is
/// measured from the track's centre and lies at y < 0. Warned of: a rail worn on its field side alone, a
/// flange back off its place. `reading` says what the file does not. Noise that would show in pressures gives
/// a warning with the smoothing to use, and with the standard profile from which the measured one may be
/// worn.
///
/// Throws InputError: no such file, empty, truncated, not a number, a size that no rail or wheel has, a file
/// of the other kind, a shape that can be read either way up, a nominal profile that is not near, smoothing
/// asked for by the file (approx.smooth), zig-zag and loops beyond repair.
MeasuredProfile measured_profile(const std::filesystem::path& file, ProfileKind kind,
                                 const ProfileReading& reading = {}, int part = 0);
MeasuredProfile parse_measured_profile(std::string_view text, std::string_view source_name, ProfileKind kind,
                                       const ProfileReading& reading = {}, int part = 0);

/// Says of which kind a file is by its ending (.prr, .ban, .rai; .prw, .whl, .whe), if that says it.
std::optional<ProfileKind> kind_of_ending(const std::filesystem::path& file);

/// A standard profile by its name; of a body file (*.toml) the contact curve of the body; else a profile
/// file, where "FILE#2" is the second of several profiles in it. Relative paths start in `folder`; `reading`
/// is for profile files alone. Throws InputError where a standard or a body is of the other kind (upper
/// bodies are wheels); and names the nearest standards where there is no such file.
ProfileCurve named_profile(std::string_view name_or_file, ProfileKind kind,
                           const std::filesystem::path& folder = {}, const ProfileReading& reading = {});

/// Does the same and returns what was found out on the way; of a standard or a body it returns the curve
/// alone.
MeasuredProfile described_profile(const std::string& name_or_file, ProfileKind kind,
                                  const ProfileReading& reading = {});

/// Rail or wheel: `kind` ("rail" or "wheel") if it is given, else a standard by its name or a file by its
/// ending. Throws InputError where neither says it.
ProfileKind kind_of_profile(const std::string& name_or_file, const std::string& kind = "");

/// "8", or "21 .. 50" where the shortest wavelength kept is not the same everywhere, mm.
std::string wavelength_text(const MeasuredProfile& profile);

/// The file of a profile's name, and the number behind its "#", 0 without.
struct ProfileFileName {
  std::filesystem::path file;
  int part = 0;
};
ProfileFileName profile_file_name(std::string_view name, const std::filesystem::path& folder = {});

} // namespace bem_contact
