#pragma once

#include "bem_contact/base/enum_names.hpp"
#include "bem_contact/base/schema.hpp"

#include <optional>
#include <string>
#include <vector>

namespace bem_contact {

/// The length unit of a profile file. found: by the width of the profile, mm or m.
enum class ProfileUnit { found, mm, cm, m, inch };
template <> struct EnumNames<ProfileUnit> {
  static constexpr std::array<std::string_view, 5> names{"found", "mm", "cm", "m", "inch"};
};

/// Where z of a profile file points. as_stated: as the format says (Simpack), else found by the shape.
enum class ProfileZ { as_stated, up, down };
template <> struct EnumNames<ProfileZ> {
  static constexpr std::array<std::string_view, 3> names{"as stated", "up", "down"};
};

/// Distance of the tape circle from the back of the flange, mm (EN 13715: the profile's y = -70).
inline constexpr double flange_back_to_tape_circle = 70.0;

/// How a profile file is read, beyond what the file says itself. The defaults read a file as it stands.
struct ProfileReading {
  /// Shortest wavelength kept, mm (profile_smoothing.hpp); 0: every point is kept as it is.
  double smoothing = 0;
  /// The standard profile from which it was made; "": not said. Then only the depth worn off it is smoothed
  /// (worn_nominal.hpp), and smoothing = 0 finds the wavelength from the points.
  std::string nominal = {};
  ProfileUnit unit = ProfileUnit::found;
  ProfileZ profile_z = ProfileZ::as_stated;
  /// y of the file points the other way. Of a Vampire file: its left profile, as seen from the other end.
  bool mirror = false;
  /// Wheel: y of the back of its flange in the file, mm. Empty: y = 0 is at the tape circle, unless the
  /// flange lies so that y = 0 can only be its back.
  std::optional<double> flange_back = {};
  /// Wheel: distance of its tape circle from the back of its flange, mm.
  double tape_circle = flange_back_to_tape_circle;
  /// y and z keep the file's origin, whatever lies there: for bodies that are placed by their coordinates.
  bool keep_origin = false;

  bool operator==(const ProfileReading&) const = default;
};

/// Declares smoothing, nominal, unit, profile_z and mirror below `table` ("rail").
void add_profile_reading(Schema& schema, const std::string& table, ProfileReading& reading,
                         const std::vector<std::string>& kinds);
/// Declares flange_back.
void add_flange_back(Schema& schema, const std::string& table, ProfileReading& reading,
                     const std::vector<std::string>& kinds);
/// Declares tape_circle.
void add_tape_circle(Schema& schema, const std::string& table, double& tape_circle,
                     const std::vector<std::string>& kinds);

/// Which of these keys the file gives a value that is not the default: "rail.smoothing", ...
std::vector<std::string> given_reading(const Schema& schema, const std::string& table);

} // namespace bem_contact
