#include "meshes/graft_fit.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/profile/standard_profiles.hpp"
#include "bem_contact/profile/worn/settings.hpp"
#include "bem_contact/profile/worn/worn_nominal.hpp"

#include <fmt/format.h>

namespace bem_contact::meshes {
namespace {

/// 1 (share of the profile). Less unworn profile finds no place.
constexpr double least_grafted_share = 0.33;
/// 1. A second place with more than this share of the best one's is as good: then nobody can choose.
constexpr double rival_share = 0.9;
/// 1. How much a unit move of the unworn part is felt at right angles to the surface, squared, at least. On
/// less, an arc or a line, the body slides.
constexpr double least_stiffness = 0.004;
/// 1. Points of the profile.
constexpr int graft_samples = 300;

std::string words(const NominalPlace& place) {
  return fmt::format("graft_at = [{:.3f}, {:.3f}], graft_angle = {:.5f}", place.shift.y, place.shift.z,
                     place.angle);
}

std::vector<Point2> samples_of(const ProfileCurve& curve, int count) {
  std::vector<Point2> samples;
  for (int i = 0; i < count; ++i)
    samples.push_back(
        curve.at(curve.s_begin() + (curve.s_end() - curve.s_begin()) * (i + 0.5) / count).position);
  return samples;
}

} // namespace

GraftPlace find_graft(const ProfileCurve& measured, const std::string& base) {
  const std::string problem =
      fmt::format("no place for the body of {} can be found on the profile {}", base, measured.name());
  constexpr const char* advice =
      "Give [body] graft_at and graft_angle, or take another body with graft_onto.";
  const ProfileCurve standard = standard_profile(base);
  const std::vector<Point2> samples = samples_of(measured, graft_samples);
  const std::vector<UnwornPlace> found = unworn_places(standard, samples, 0);
  if (found.empty() || found.front().share < least_grafted_share)
    throw InputError(problem,
                     fmt::format("at most {:.0f} % of it lie within {} mm of that body's outline",
                                 found.empty() ? 0 : 100 * found.front().share, unworn_distance),
                     advice);
  const UnwornPlace& best = found.front();
  if (best.stiffness < least_stiffness)
    throw InputError(problem,
                     fmt::format("its unworn part is an arc or a straight line, along which the body slides "
                                 "(stiffness {:.4f} where {} is needed)",
                                 best.stiffness, least_stiffness),
                     advice);
  if (found.size() > 1 && found[1].share > rival_share * best.share)
    throw InputError(
        problem, fmt::format("two are as good: {}; {}", words(best.place), words(found[1].place)), advice);
  return {best.place, best.share, not_worn_from(standard, fit_at(best.place, standard, samples, 0))};
}

} // namespace bem_contact::meshes
