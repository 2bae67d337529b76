#include "bem_contact/influence/requirements.hpp"

#include "bem_contact/influence/settings.hpp"

#include <cmath>
#include <sstream>

namespace bem_contact {
namespace {

template <class... Parts> std::string text(const Parts&... parts) {
  std::ostringstream out;
  out.precision(9);
  (out << ... << parts);
  return out.str();
}

} // namespace

void require_profile(const InfluenceFunction& f, const std::string& profile, std::uint64_t digest) {
  if (f.profile_digest != digest)
    throw InputError(
        text("The influence functions of '", f.body, "' do not belong to the profile '", profile, "'"),
        text("they were computed for the profile '", f.profile, "', whose geometry differs"),
        "Compute the influence functions of this profile, or name their own profile.");
}

void require_material(const InfluenceFunction& f, const Material& material) {
  if (!(f.material == material))
    throw InputError(text("The influence functions of '", f.body, "' do not belong to this material"),
                     text("they hold for G = ", f.material.shear_modulus, " MPa, nu = ", f.material.poisson,
                          ", not G = ", material.shear_modulus, " MPa, nu = ", material.poisson),
                     "Compute them for this material, or give the body theirs.");
}

void require_order(const InfluenceFunction& lower, const InfluenceFunction& upper) {
  const auto faces_down = [](const InfluenceFunction& f) { // its material above
    return std::cos(f.stations[f.stations.size() / 2].delta) < 0;
  };
  if (faces_down(lower) && !faces_down(upper))
    throw InputError("The two influence files are exchanged",
                     text("the material of '", lower.body,
                          "', which is given as the rail, lies above its surface; "
                          "that of '",
                          upper.body, "', given as the wheel, below"),
                     "Give the rail's (lower body's) file as the rail's and the wheel's as the wheel's.");
}

void require_strip(const InfluenceFunction& f, double s_from, double s_to) {
  const auto [from, to] = f.strip();
  const double rounding = strip_rounding * (std::abs(from) + std::abs(to) + f.station_width);
  // Negated, so that NaN is refused.
  if (!(s_from >= from - rounding && s_to <= to + rounding && s_from <= s_to))
    throw OffStripError(
        text("The patch from s = ", s_from, " to ", s_to, " mm leaves the contact strip of '", f.body, "'"),
        text("its influence functions cover s = ", from, " to ", to, " mm"),
        "Compute them for a wider strip, or move the patch.");
}

double shortest_dx(const InfluenceFunction& function) {
  const double largest = function.wavenumber.empty() ? 0.0 : function.wavenumber.back();
  return largest > 0 ? 2 * least_half_element_phase / largest : 0.0;
}

} // namespace bem_contact
