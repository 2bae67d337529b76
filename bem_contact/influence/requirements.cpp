#include "bem_contact/influence/requirements.hpp"

#include "bem_contact/influence/settings.hpp"

#include <cmath>
#include <fmt/format.h>

namespace bem_contact {

namespace {

/// 1 (share of the arc lengths). How far a patch may reach beyond the strip: rounding.
constexpr double strip_rounding = 1e-9;

} // namespace

void require_profile(const InfluenceDescription& f, const std::string& profile, std::uint64_t digest) {
  if (f.profile_digest != digest)
    throw InputError(
        fmt::format("The influence functions of '{}' do not belong to the profile '{}'", f.body, profile),
        fmt::format("they were computed for the profile '{}', whose geometry differs", f.profile),
        "Compute the influence functions of this profile, or name their own profile.");
}

void require_material(const InfluenceDescription& f, const Material& material) {
  if (!(f.material == material))
    throw InputError(fmt::format("The influence functions of '{}' do not belong to this material", f.body),
                     fmt::format("they hold for G = {:.9g} MPa, nu = {:.9g}, not G = {:.9g} MPa, nu = {:.9g}",
                                 f.material.shear_modulus, f.material.poisson, material.shear_modulus,
                                 material.poisson),
                     "Compute them for this material, or give the body theirs.");
}

bool lies_above(const InfluenceStrip& strip) {
  return std::cos(strip.stations[strip.stations.size() / 2].delta) < 0;
}

void require_order(const InfluenceStrip& lower, const InfluenceStrip& upper) {
  if (lies_above(lower) && !lies_above(upper))
    throw InputError("The two influence files are exchanged",
                     fmt::format("the material of '{}', which is given as the rail, lies above its surface; "
                                 "that of '{}', given as the wheel, below",
                                 lower.body, upper.body),
                     "Give the rail's (lower body's) file as the rail's and the wheel's as the wheel's.");
}

void require_strip(const InfluenceStrip& f, double s_from, double s_to) {
  const auto [from, to] = f.ends();
  const double rounding = strip_rounding * (std::abs(from) + std::abs(to) + f.station_width);
  // Negated, so that NaN is refused.
  if (!(s_from >= from - rounding && s_to <= to + rounding && s_from <= s_to))
    throw OffStripError(fmt::format("The patch from s = {:.9g} to {:.9g} mm leaves the contact strip of '{}'",
                                    s_from, s_to, f.body),
                        fmt::format("its influence functions cover s = {:.9g} to {:.9g} mm", from, to),
                        "Compute them for a wider strip, or move the patch.");
}

double shortest_dx(const InfluenceStrip& strip) {
  const double largest = strip.wavenumber.empty() ? 0.0 : strip.wavenumber.back();
  return largest > 0 ? 2 * least_half_element_phase / largest : 0.0;
}

} // namespace bem_contact
