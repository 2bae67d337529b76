#include "bem_contact/profile/worn/like_standard.hpp"

#include "bem_contact/profile/standard_profiles.hpp"
#include "bem_contact/profile/worn/head_symmetry.hpp"
#include "bem_contact/profile/worn/settings.hpp"
#include "bem_contact/profile/worn/worn_nominal.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace bem_contact {

namespace {

/// mm. Noise says which nominal profile would help if the points lie this near to it. Chosen.
constexpr double farthest_advised = 3.0;
/// mm. A standard is not like a profile that has more steel outside it: flow of the steel makes lips of some
/// tenths.
constexpr double farthest_added_steel = 1.0;
/// 1. Points of a measured curve by which it is compared with the standards: closer than 1 mm. Chosen.
constexpr int like_points = 200;
/// 1. How unlike a standard is: the steel outside it and this share of the whole depth, root mean squares.
/// Wear of 2 mm then weighs as much as 0.1 mm of steel that nothing can have added. Chosen.
constexpr double worn_share = 0.1;
/// 1. A second standard that is not more unlike than this is named too. Chosen: a 60E2 with its top worn
/// evenly lies as well on 60E1.
constexpr double like_tie = 1.5;
/// 1 (share of the points). A standard on which less of a profile lies is not like it. New wheels of seven
/// other shapes lie on S1002 by 0.05 to 0.16, S1002 worn by 2 mm on the whole tread by 0.33.
constexpr double least_unworn_share = 0.25;
/// 1. A rail whose top is worn all over is told by its flanks: this share of each of them must lie on the
/// standard,
constexpr double least_flanks_share = 0.5;
/// 1. and this share of the whole head. Chosen: heads of other widths have no place for both flanks.
constexpr double least_share_with_flanks = 0.1;
/// 1. On the standard from which it is worn more lies. Chosen.
constexpr double surely_like_share = 0.5;
/// rad. Inclinations by a standard and by symmetry that differ by more do not belong together: 1 mm off the
/// top and 0.6 mm off the gauge corner move that by symmetry by 4 mrad (46E3), and 49E1 lies on 54E1 turned
/// by 6 mrad and more.
constexpr double symmetry_slack = 0.005;
/// rad. A rail that is turned by this or more was measured as it lies in the track: half of 1:40, the
/// smallest inclination in use.
constexpr double least_inclination = 0.0125;
/// rad. Heads turn by 160 degrees from side to side; a running surface that turns by less is another thing.
constexpr double least_head_turn = 1.0;

struct Candidate {
  std::string name;
  NominalFit fit;
  double unlike = 0; ///< mm
};

std::vector<Point2> points_along(const ProfileCurve& curve) {
  std::vector<Point2> out;
  for (int i = 0; i <= like_points; ++i)
    out.push_back(curve.at(curve.s_begin() + (curve.s_end() - curve.s_begin()) * i / like_points).position);
  return out;
}

/// By the symmetry of a rail's head, if that tells it.
std::optional<double> turn_of(const ProfileCurve& curve, ProfileKind kind) {
  const std::optional<HeadTurn> turn = kind == ProfileKind::rail ? turn_by_symmetry(curve) : std::nullopt;
  return turn ? std::optional(turn->angle) : std::nullopt;
}

/// Standards from which the curve may be worn, the most like first. `turn`: of a rail, by its symmetry.
std::vector<Candidate> candidates(const ProfileCurve& curve, ProfileKind kind, std::optional<double> turn,
                                  double scatter) {
  const std::vector<Point2> points = points_along(curve);
  std::vector<Candidate> near;
  for (const StandardEntry& entry : standard_entries()) {
    if (!entry.usual || entry.kind != kind)
      continue;
    const std::string& name = entry.name;
    const ProfileCurve standard = standard_profile(name);
    const std::vector<UnwornPlace> places = unworn_places(standard, points, scatter);
    const double least_share = kind == ProfileKind::rail ? least_share_with_flanks : least_unworn_share;
    if (places.empty() || places.front().share < least_share)
      continue;
    const NominalFit fit = fit_at(places.front().place, standard, points, scatter);
    const bool turned = kind == ProfileKind::wheel
                            ? std::abs(fit.place.angle) > largest_wheel_turn
                            : turn && std::abs(fit.place.angle - *turn) > symmetry_slack;
    const bool lies_on = fit.share >= (fit.flanks >= least_flanks_share ? least_share : least_unworn_share);
    if (fit.near && !turned && lies_on && fit.outside <= most_outside && -fit.least <= farthest_added_steel)
      near.push_back({name, fit, fit.added_rms + worn_share * fit.rms});
  }
  std::ranges::sort(near, {}, &Candidate::unlike);
  return near;
}

bool ties(const Candidate& other, const Candidate& best) {
  return other.unlike < like_tie * best.unlike;
}

/// The turn of a rail by standards, if those that are about as like agree.
std::optional<double> turn_by_standards(const std::vector<Candidate>& near) {
  if (near.empty())
    return std::nullopt;
  const double turn = near[0].fit.place.angle;
  const bool agree = std::ranges::all_of(near, [&](const Candidate& c) {
    return !ties(c, near[0]) || std::abs(c.fit.place.angle - turn) <= symmetry_slack;
  });
  return agree ? std::optional(turn) : std::nullopt;
}

} // namespace

std::optional<LikeStandard> like_standard(const ProfileCurve& curve, ProfileKind kind, double scatter) {
  std::vector<Candidate> near = candidates(curve, kind, turn_of(curve, kind), scatter);
  std::erase_if(near, [](const Candidate& c) { return c.fit.largest > farthest_advised; });
  if (near.empty())
    return std::nullopt;
  const auto& [name, fit, unlike] = near.front();
  return LikeStandard{name, fit.least, fit.largest, fit.place.angle,
                      near.size() > 1 && ties(near[1], near[0]) ? near[1].name : ""};
}

double rail_turn(const ProfileCurve& rail, double scatter) {
  if (rail.at(rail.s_end()).delta - rail.at(rail.s_begin()).delta < least_head_turn)
    return 0;
  const std::optional<HeadTurn> head = turn_by_symmetry(rail);
  const std::optional<double> by_symmetry = head ? std::optional(head->angle) : std::nullopt;
  const auto as_laid = [](double turn) { return std::abs(turn) >= least_inclination ? turn : 0; };
  if (head && (head->whole || std::abs(head->angle) < least_inclination - symmetry_slack))
    return as_laid(head->angle);
  std::vector<Candidate> near = candidates(rail, ProfileKind::rail, by_symmetry, scatter);
  if (by_symmetry) // a standard on which most of the head lies tells more precisely
    std::erase_if(near, [](const Candidate& c) { return c.fit.share < surely_like_share; });
  const std::optional<double> by_standards = turn_by_standards(near);
  const double turn = by_standards ? *by_standards : by_symmetry.value_or(0);
  return as_laid(turn);
}

std::string inclination_text(double turn) {
  return fmt::format("about 1:{:.0f}", 1 / std::tan(std::abs(turn)));
}

} // namespace bem_contact
