#include "bem_contact/profile/profile_findings.hpp"

#include "bem_contact/profile/standard_profiles.hpp"

#include <fmt/format.h>

namespace bem_contact {

namespace {

/// mm. Points by which a standard is laid on a measured profile. Chosen.
constexpr double placing_step = 0.2;

std::optional<HeadWear> wear_of(const MeasuredProfile& rail, const std::optional<LikeStandard>& like) {
  if (rail.worn)
    return head_wear(rail.curve, standard_profile(rail.worn->nominal), rail.worn->place);
  if (!like)
    return std::nullopt;
  std::vector<Point2> points;
  for (const CurvePoint& p : points_along(rail.curve, placing_step))
    points.push_back(p.position);
  const ProfileCurve nominal = standard_profile(like->name);
  return head_wear(rail.curve, nominal, place_nominal(nominal, points, rail.scatter_left()));
}

} // namespace

ProfileFindings findings_of(const MeasuredProfile& profile, ProfileKind kind, const ProfileReading& reading) {
  ProfileFindings out;
  const bool measured = profile.points > 0, rail = kind == ProfileKind::rail;
  if (measured)
    out.like = like_standard(profile.curve, kind, profile.scatter_left());
  if (measured && rail) {
    out.turn = rail_turn(profile.curve, profile.scatter_left());
    out.wear = wear_of(profile, out.like);
  }
  if (!rail && !reading.keep_origin)
    out.flange = flange_numbers(profile.curve, reading.tape_circle);
  return out;
}

std::string leans_outwards(double turn) {
  return turn > 0 ? fmt::format("the rail leans away from the track's centre in its file ({}), and rails are "
                                "inclined towards it: does its y point to the field side? (mirror turns it)",
                                inclination_text(turn))
                  : "";
}

} // namespace bem_contact
