#pragma once

#include "bem_contact/profile/bodies/body_file.hpp"
#include "bem_contact/profile/profile_curve.hpp"
#include "bem_contact/profile/profile_kind.hpp"
#include "bem_contact/profile/standards/standard_tables.hpp"

#include <optional>
#include <string>
#include <string_view>

namespace bem_contact {

/// The contact curve of a standard rail or wheel. Its arcs, lines and polynomials come from data/standards,
/// whose README says which profiles there are and from where; a rail's curve ends at its under-head fillets.
/// Names are understood as people say them: "60E1" or "uic 60", "S1002 h28 e30.5 6.7%" (a wheel of EN 13715).
/// Throws InputError for any other name, with the nearest ones.
///
/// Tangent and curvature are exactly the standard's in each piece. Where a standard's pieces do not quite
/// meet, each is moved to the end of the one before it, from the piece at y = 0 outwards. S1002: its formulas
/// jump in z, by 1.2e-4 mm at y = -35, 3.7e-5 mm at y = -26 and less than 1e-6 mm elsewhere, so positions
/// deviate from them by up to 8.2e-5 mm beyond y = -26 and by nothing on the tread.
ProfileCurve standard_profile(std::string_view name);
bool is_standard_profile(std::string_view name);
/// Rail or wheel, of such a name.
ProfileKind kind_of_standard(std::string_view name);
/// The profile of this name in data/standards; of a wheel of EN 13715 the usual one; nullptr if there is
/// none.
const StandardEntry* find_standard(std::string_view name);
/// The name that data/standards has, or "S1002 h28 e30.5 6.7%"; what is no standard's name is returned as it
/// is.
std::string standard_name(std::string_view name);
/// What to do about an unknown name: the nearest ones (of `kind`, if it is given), and where all are listed.
std::string advice_on_name(std::string_view name, std::optional<ProfileKind> kind = std::nullopt);
/// All names of data/standards, a line each, with standard, other names and remark.
std::string standards_text();

/// The body file of a standard rail or wheel: its own section, or the representative rim, web and hub that
/// all wheels have, and the usual strip as far as the profile reaches. Throws InputError for an unknown name,
/// and for a rail of which the tables have the head alone.
std::string standard_body_file(std::string_view name);

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
/// Throws InputError for a standard of the other kind, and for a rail without a known web and foot.
std::string graft_base(const BodyFile::Body& body);

/// The part of the body that is held: [body] held, or the default of its kind.
std::string held_part(const BodyFile::Body& body);

/// Name of the body for meshes, reports and influence files; says what of it is representative only.
std::string body_name(const BodyFile& body);

} // namespace bem_contact
