#include "bem_contact/scene/network.hpp"

#include "bem_contact/base/enum_names.hpp"
#include "bem_contact/profile/standard_profiles.hpp"

#include <array>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <utility>
#include <vector>

namespace bem_contact {

namespace {

/// In the order of the enum.
constexpr std::array<NetworkTrack, EnumNames<Network>::names.size()> networks{{
    {1435, 14, 1360, 70, 1 / 40.0,
     "gauge and its height: EN 13848-1; flange backs: UIC 510-2; tape circle: EN 13715; inclination: 1:20 to "
     "1:40 by Regulation (EU) 1299/2014, of which 1:40 is taken"},
    {1435, 14, 1360, 70, 1 / 20.0,
     "gauge: Railway Group Standard GC/RT5021, 2.9.1.1; its height: EN 13848-1; wheels as UIC; inclination: "
     "the normal 1 in 20 of TRID 6563 (1946)"},
    {1435, 16, 1353, 70, 1 / 40.0,
     "gauge, its height and inclination: handbooks of track maintenance; flange backs: schienenweg.at, "
     "thread "
     "40339; tape circle: the profile LMA, whose flange back is at y = -70"},
    {1435.1, 15.9, 1355.7, std::nullopt, 1 / 40.0,
     "gauge of 56 1/2 in, TM 5-628; 5/8 in below the top, 49 CFR 213.53; flange backs: the 53 3/8 in of 49 "
     "CFR "
     "230.112; inclination: one of the two slopes of the survey of Railway Age (1 in 40)"},
}};

/// "1:40", or in rad where that is no whole number.
std::string slope_text(double inclination) {
  const double run = 1 / inclination;
  return std::abs(run - std::round(run)) < 1e-6 * std::abs(run) ? fmt::format("1:{:.0f}", run)
                                                                : fmt::format("{:g} rad", inclination);
}

std::string inclination_words(const SceneFile& scene) {
  if (const double inclination = scene.position.rail_inclination; inclination != 0)
    return "rail inclined by " + slope_text(inclination);
  return is_standard_profile(scene.rail.profile) // of a file it may be inclined: nobody has looked
             ? "rail not inclined: it stands upright (position.rail_inclination is 0)"
             : "rail as it stands in its file (position.rail_inclination is 0)";
}

} // namespace

const NetworkTrack& track_of(Network network) {
  return networks[static_cast<std::size_t>(network)];
}

void set_network(SceneFile& file, const Schema& schema) {
  if (!file.track.network)
    return;
  const NetworkTrack& its = track_of(*file.track.network);
  WheelsetPosition& p = file.position;
  const bool standard = is_standard_profile(file.wheel.profile); // it has a tape circle of its own
  const std::optional<double> tape_circle =
      standard || file.wheel.place == BodyPlace::absolute ? flange_back_to_tape_circle : its.tape_circle;
  if (!tape_circle && !schema.has("position.tape_circle"))
    schema.refuse("position.tape_circle",
                  fmt::format("no source confirms one for {}, and '{}' is no standard",
                              name_of(*file.track.network), file.wheel.profile),
                  "Give the distance of the wheel's tape circle from the back of its flange, in mm.");
  for (const auto& [key, member, value] :
       {std::tuple{"position.gauge", &p.gauge, its.gauge},
        {"position.gauge_height", &p.gauge_height, its.gauge_height},
        {"position.back_to_back", &p.back_to_back, its.back_to_back},
        {"position.tape_circle", &p.tape_circle, tape_circle.value_or(0)},
        {"position.rail_inclination", &p.rail_inclination, its.rail_inclination}})
    if (!schema.has(key))
      *member = value;
}

std::string track_text(const SceneFile& scene) {
  if (scene.kind != SceneKind::wheel_rail)
    return "";
  const WheelsetPosition& p = scene.position;
  std::vector<std::string> parts;
  if (scene.track.network)
    parts.emplace_back(name_of(*scene.track.network));
  if (scene.rail.place == BodyPlace::gauge)
    parts.push_back(fmt::format("gauge {:g} mm ({:g} mm below the top)", p.gauge, p.gauge_height));
  if (scene.wheel.place == BodyPlace::gauge)
    parts.push_back(fmt::format("flange backs {:g} mm apart, tape circle {:g} mm from the back",
                                p.back_to_back, p.tape_circle));
  parts.push_back(inclination_words(scene));
  return fmt::format("track: {}", fmt::join(parts, ", "));
}

} // namespace bem_contact
