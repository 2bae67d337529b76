#include "bem_contact/app/from_contact/profile_keys.hpp"

#include "bem_contact/base/input_file.hpp"
#include "bem_contact/profile/formats/profile_formats.hpp"
#include "bem_contact/profile/read_profile.hpp"
#include "bem_contact/profile/sections/slices_file.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <iterator>
#include <numbers>
#include <utility>
#include <vector>

namespace bem_contact::app::from_contact {

namespace {

/// The length unit that multiplies by `scale`; "": there is none.
std::string unit_of(double scale) {
  static constexpr std::pair<double, const char*> units[] = {
      {1, "mm"}, {10, "cm"}, {1000, "m"}, {25.4, "inch"}};
  const auto found = std::ranges::find(units, scale, &std::pair<double, const char*>::first);
  return found == std::end(units) ? "" : found->second;
}

/// Mean distance of the points of a file, mm.
double spacing_of(const MeasuredProfile& profile) {
  return (profile.curve.s_end() - profile.curve.s_begin()) /
         static_cast<double>(std::max<std::size_t>(2, profile.points) - 1);
}

} // namespace

ProfileKeys::ProfileKeys(const contact_input::Block& given, const std::filesystem::path& folder,
                         std::string body)
    : given_(given), body_(std::move(body)) {
  std::string name = given.text;
  std::ranges::replace(name, '\\', '/');
  file_ = (std::filesystem::absolute(folder) / name).lexically_normal();
}

bool ProfileKeys::is_simpack() const {
  const std::string ending = lower_ending(file_);
  return ending == ".prr" || ending == ".prw";
}

/// y of a MiniProf file counts the other way here (to the gauge side of a rail); CONTACT takes it as it
/// stands.
bool ProfileKeys::mirror() const {
  bool other_way = false;
  try {
    other_way = is_miniprof(read_text_file(file_.string(), "profile"));
  } catch (const InputError&) { // whoever reads the profile says so
  }
  return (given_["MIRRORY"] == 1) != other_way;
}

void ProfileKeys::add(ContactCase& out) const {
  out.set_text(body_ + ".profile", file_.generic_string());
  if (mirror())
    out.set(body_ + ".mirror", "true");
  if (const double z = given_.number("MIRRORZ", 0); z != 0)
    out.set_text(body_ + ".profile_z", z > 0 ? "up" : "down");
  const std::string unit = unit_of(given_["SCALE"]);
  if (unit.empty())
    out.refuse(fmt::format("SCALE = {} of the {}: no unit of length (1, 10, 25.4 and 1000 are)",
                           given_["SCALE"], body_));
  else
    out.set_text(body_ + ".unit", unit);
  add_smoothing(out);
  if (const double handling = given_.number("ERRHND", 0); handling != 0)
    out.leave(fmt::format("ERRHND of the {}: repairs are those of bem_contact profile", body_));
}

void ProfileKeys::add_smoothing(ContactCase& out) const {
  const double smooth = given_["SMOOTH"];
  if (smooth <= 0)
    return;
  if (given_.number("ISMOOTH", 0) >= 1) // there, too, a wave of this length keeps half of its height
    return out.set(body_ + ".smoothing", smooth);
  const std::optional<MeasuredProfile> profile = read(out);
  if (!profile)
    return;
  // A spline that minimises sum (x_i - f)^2 + lambda int f''^2 halves waves of 2 pi (lambda spacing)^(1/4).
  const double wave = 2 * std::numbers::pi * std::pow(smooth * spacing_of(*profile), 0.25);
  out.set(body_ + ".smoothing", fmt::format("{:.3g}", wave));
  out.leave(fmt::format(
      "LAMBDA = {} of the {}: the wavelength {:.3g} mm that it halves is {}.smoothing; shorter and longer "
      "waves are not damped quite as there",
      smooth, body_, wave, body_));
}

std::optional<MeasuredProfile> ProfileKeys::read(ContactCase& out) const {
  try {
    return measured_profile(
        is_of_sections() ? read_slices(file_).slices.front().profile : file_,
        body_ == "rail" ? ProfileKind::rail : ProfileKind::wheel,
        {.unit = value_named<ProfileUnit>(unit_of(given_["SCALE"])).value_or(ProfileUnit::found),
         .mirror = mirror(),
         .keep_origin = true});
  } catch (const InputError& error) {
    out.refuse(fmt::format("the {}'s profile cannot be read: {}", body_, error.what()));
    return std::nullopt;
  }
}

std::optional<GaugePoint> ProfileKeys::gauge_point(double cant, double height, ContactCase& out) const {
  const std::optional<MeasuredProfile> profile = read(out);
  if (!profile)
    return std::nullopt;
  constexpr int samples = 20000;
  const ProfileCurve& curve = profile->curve;
  std::vector<Point2> points;
  for (int k = 0; k <= samples; ++k) {
    const Point2 p = curve.at(curve.s_begin() + (curve.s_end() - curve.s_begin()) * k / samples).position;
    points.push_back(
        {p.y * std::cos(cant) + p.z * std::sin(cant), p.z * std::cos(cant) - p.y * std::sin(cant)});
  }
  const auto top = std::ranges::min_element(points, {}, &Point2::z);
  GaugePoint gauge{.y = top->y, .top = top->z, .on_face = false};
  for (auto at = std::make_reverse_iterator(top); at != points.rend() && !gauge.on_face; ++at) { // towards -y
    gauge.on_face = at->z - gauge.top >= height;
    gauge.y = std::min(gauge.y, at->y);
  }
  return gauge;
}

bool ProfileKeys::keeps_origin() const {
  return given_["MIRRORY"] != 0 || is_simpack();
}

bool ProfileKeys::is_of_sections() const {
  return names_slices(file_);
}

} // namespace bem_contact::app::from_contact
