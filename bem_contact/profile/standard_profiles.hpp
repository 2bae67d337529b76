#pragma once

#include "bem_contact/profile/bodies/body_file.hpp"
#include "bem_contact/profile/profile_curve.hpp"
#include "bem_contact/profile/profile_kind.hpp"

#include <span>
#include <string>
#include <string_view>

namespace bem_contact {

/// 60E1, 60E2, 54E1, 46E3 (EN 13674-1, head down to the under-head fillet) and S1002
/// (EN 13715, flange tip at y = -55). Throws InputError for any other name, with the nearest ones.
///
/// S1002: tangent and curvature are exactly the standard's in each zone. At the zones' joints the standard's
/// formulas jump in z, by 1.2e-4 mm at y = -35, 3.7e-5 mm at y = -26 and less than 1e-6 mm elsewhere; each
/// zone is translated to the end of the one before it (from the tread outwards), so positions deviate from
/// the formulas by up to 8.2e-5 mm beyond y = -26 and by nothing on the tread.
ProfileCurve standard_profile(std::string_view name);
bool is_standard_profile(std::string_view name);
std::span<const std::string> standard_profile_names();
/// Rail or wheel, of one of these names.
ProfileKind kind_of_standard(std::string_view name);

/// The contact curve of a body, in its section's frame.
///   rail, wheel: the profile named (a standard or a file)
///   disc:  the lower half of a circle about the origin, walked as an upper body: s = 0 at (0, radius)
///          where delta = pi, curvature +1/radius
///   bore:  the lower half of a circle about the origin, walked as a lower body: s = 0 at (0, radius) where
///          delta = 0, curvature -1/radius; the material lies outside the circle
///   block: the line z = 0 from y = -size to size, material below
///   outline: its contact pieces (own_outline.hpp)
ProfileCurve body_profile(const BodyFile& body);
/// Throws InputError unless the strip lies on the profile, but for rounding.
void require_strip_on_profile(const BodyFile::Strip& strip, const ProfileCurve& profile);

/// The profile file that a body names; empty where it names a standard or nothing.
std::filesystem::path profile_file_of(const BodyFile& body);

/// The standard whose body carries a profile that comes from a file: 60E1 or S1002 unless said.
/// Throws InputError for a standard of the other kind.
std::string graft_base(const BodyFile::Body& body);

/// The part of the body that is held: [body] held, or the default of its kind.
std::string held_part(const BodyFile::Body& body);

/// Name of the body for meshes, reports and influence files; says what of it is representative only.
std::string body_name(const BodyFile& body);

} // namespace bem_contact
