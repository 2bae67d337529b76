#include "meshes/graft_fit.hpp"

#include "bem_contact/base/error.hpp"
#include "meshes/settings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>

namespace bem_contact::meshes {
namespace {

bool same(const GraftPlace& a, const GraftPlace& b) {
  return norm(a.at - b.at) < apart_distance && std::abs(a.angle - b.angle) < apart_angle;
}

void add_new(std::vector<GraftPlace>& places, const GraftPlace& place) {
  if (std::none_of(places.begin(), places.end(), [&](const auto& other) { return same(place, other); }))
    places.push_back(place);
}

/// Where the search begins: the file's own frame, and the profile's top laid on that of the body, with moves
/// to both sides; a wheel's top is its flange, that is its lowest place.
std::vector<GraftPlace> starts_of(std::span<const ProfileSample> samples, std::span<const Chord> outline) {
  const auto middle_and_top = [](const auto& points, auto position, bool lowest) {
    double left = 1e300, right = -1e300, top = lowest ? -1e300 : 1e300;
    for (const auto& point : points) {
      const Point2 p = position(point);
      top = lowest ? std::max(top, p.z) : std::min(top, p.z);
    }
    for (const auto& point : points)
      if (const Point2 p = position(point); std::abs(p.z - top) < top_reach) {
        left = std::min(left, p.y);
        right = std::max(right, p.y);
      }
    return Point2{(left + right) / 2, top};
  };
  const bool wheel = samples[samples.size() / 2].tangent.y < 0;
  const Point2 mine = middle_and_top(
      samples, [](const ProfileSample& s) { return s.position; }, wheel);
  const Point2 its = middle_and_top(
      outline, [](const Chord& e) { return e.from; }, wheel);
  std::vector<GraftPlace> starts;
  for (const double angle : start_angles) {
    starts.push_back({{0, 0}, angle});
    for (const double side : start_sides)
      starts.push_back({mine + Point2{side, 0} - its, angle});
  }
  return starts;
}

std::string words(const GraftPlace& place) {
  return fmt::format("graft_at = [{:.3f}, {:.3f}], graft_angle = {:.5f}", place.at.y, place.at.z,
                     place.angle);
}

/// Places to which the starts lead, with few samples and long chords.
std::vector<GraftPlace> places_near(const ProfileCurve& measured, const Loop& base) {
  const auto few = samples_of(measured, coarse_samples);
  const auto coarse = chords(base, coarse_chord);
  std::vector<GraftPlace> places;
  for (GraftPlace place : starts_of(few, coarse)) {
    bool good = true;
    for (const double width : search_widths)
      good = good && refine(place, few, coarse, width, search_steps);
    if (good)
      add_new(places, place);
  }
  return places;
}

std::vector<GraftPlace> settled(const std::vector<GraftPlace>& places, std::span<const ProfileSample> samples,
                                std::span<const Chord> outline) {
  std::vector<GraftPlace> found;
  for (GraftPlace place : places)
    if (settle(place, samples, outline))
      add_new(found, place);
  return found;
}

} // namespace

GraftPlace find_graft(const ProfileCurve& measured, const Loop& base, const std::string& base_name) {
  const std::string problem =
      fmt::format("no place for the body of {} can be found on the profile {}", base_name, measured.name());
  constexpr const char* advice =
      "Give [body] graft_at and graft_angle, or take another body with graft_onto.";
  const auto many = samples_of(measured, fine_samples);
  const auto fine = chords(base, fine_chord);
  std::vector<GraftPlace> found = settled(places_near(measured, base), many, fine);
  std::sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.share > b.share; });
  if (found.empty() || found.front().share < least_unworn_share)
    throw InputError(problem,
                     fmt::format("at most {:.0f} % of it lie within {} mm of that body's outline",
                                 found.empty() ? 0 : 100 * found.front().share, unworn_distance),
                     advice);
  if (const double stiffness = stiffness_at(found.front(), many, fine); stiffness < least_stiffness)
    throw InputError(problem,
                     fmt::format("its unworn part is an arc or a straight line, along which the body slides "
                                 "(stiffness {:.4f} where {} is needed)",
                                 stiffness, least_stiffness),
                     advice);
  if (found.size() > 1 && found[1].share > rival_share * found[0].share)
    throw InputError(problem, fmt::format("two are as good: {}; {}", words(found[0]), words(found[1])),
                     advice);
  return found.front();
}

} // namespace bem_contact::meshes
