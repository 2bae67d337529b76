#include "bem_contact/profile/worn/like_standard.hpp"

#include "bem_contact/profile/standard_profiles.hpp"
#include "bem_contact/profile/worn/settings.hpp"
#include "bem_contact/profile/worn/worn_nominal.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace bem_contact {

namespace {

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

double inclination_of(const NominalFit& fit, ProfileKind kind) {
  const bool told = kind == ProfileKind::rail && fit.added_rms <= most_added_steel;
  return told && -fit.place.angle >= least_inclination ? -fit.place.angle : 0;
}

} // namespace

std::optional<LikeStandard> like_standard(const ProfileCurve& curve, ProfileKind kind) {
  const std::vector<Point2> points = points_along(curve);
  std::vector<Candidate> near;
  for (const std::string& name : standard_profile_names()) {
    if (kind_of_standard(name) != kind)
      continue;
    const NominalFit fit = fit_nominal(standard_profile(name), points, 0);
    if (fit.near && fit.largest <= farthest_advised && -fit.least <= farthest_added_steel)
      near.push_back({name, fit, fit.added_rms + worn_share * fit.rms});
  }
  if (near.empty())
    return std::nullopt;
  std::ranges::sort(near, {}, &Candidate::unlike);
  const auto& [name, fit, unlike] = near.front();
  const bool tie = near.size() > 1 && near[1].unlike < like_tie * unlike;
  return LikeStandard{name,
                      fit.least,
                      fit.largest,
                      fit.place.angle,
                      tie ? near[1].name : "",
                      tie ? 0 : inclination_of(fit, kind)};
}

std::string inclination_text(double inclination) {
  return fmt::format("about 1:{:.0f}", 1 / std::tan(inclination));
}

} // namespace bem_contact
