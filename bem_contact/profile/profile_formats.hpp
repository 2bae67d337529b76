#pragma once

#include "bem_contact/profile/read_profile.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace bem_contact {

/// What the readers of the formats hand to the repairs; `source` names the file in messages.

/// Simpack .prr/.prw: the flags are applied in the order the file numbers them: 1 point.dist.min, 2 shift,
/// 3 rotate (about x, from y towards z), 4 bound (where min < max), 5 mirror, 6 inversion, 7 units. Points of
/// weight 0 do not count. mm, z down.
bool is_simpack(std::string_view text);
std::vector<Point2> simpack_points(std::string_view text, const std::string& source, ProfileKind kind);

/// MiniProf .ban/.whl with "Key=Value" lines, or the older "#MINIWHEELPROF" variant. y is mirrored back; z is
/// left as it stands, for both signs are met.
bool is_miniprof(std::string_view text);
std::vector<Point2> miniprof_points(std::string_view text, const std::string& source);

/// Two columns "y z"; comment lines start with #, !, % or //; one line of column names may come first.
std::vector<Point2> plain_points(std::string_view text, const std::string& source);

/// Brings points into the frame, order and shape that ProfileCurve::through_points needs.
std::vector<Point2> repaired(std::vector<Point2> points, const std::string& source, ProfileKind kind);

/// Text tools of the readers.
std::vector<std::string_view> lines_of(std::string_view text);
std::string_view trimmed(std::string_view text);
/// The numbers of a line, separated by blanks, commas or semicolons; empty when any token is not a number.
/// "nan" and "inf" are numbers here, so that require_finite can refuse them by name.
std::vector<double> numbers_of(std::string_view line);
/// Throws InputError naming the line.
void require_finite(const std::vector<double>& values, const std::string& source, std::size_t line);

} // namespace bem_contact
