#include "bem_contact/scene/warnings.hpp"

#include "bem_contact/profile/profile_findings.hpp"
#include "bem_contact/profile/wheel_datum.hpp"
#include "bem_contact/scene/friction_laws.hpp"
#include "bem_contact/scene/settings.hpp"

#include <cmath>
#include <fmt/format.h>
#include <optional>
#include <utility>

namespace bem_contact {

namespace {

/// 1. A friction coefficient above this is probably a mistake: wheels and rails stay below 0.8, dry and
/// sanded.
constexpr double highest_friction = 1.0;
/// N. A wheel load below this is probably in kN: an empty wagon has 20 kN on a wheel, a roller rig of 1/5
/// scale some 500 N.
constexpr double least_wheel_load = 300.0;
/// MPa. A Young's modulus above this is probably one in another unit: somewhat above diamond.
constexpr double stiffest_modulus = 1.3e6;
/// 1. A spin times the wheel's radius above this is probably in 1/m: a wheel that rolls on a vertical face of
/// its flange has 1.
constexpr double largest_spin = 10.0;
/// mm. The thinnest flange of a wheel in service (EN 15313): with it the wheelset moves farthest until the
/// other wheel's flange meets its rail.
constexpr double thinnest_flange = 22.0;
/// mm. A wheel radius above this is probably a diameter: the largest of railways in service is 625 mm.
constexpr double largest_wheel_radius = 750.0;
/// 1. A velocity above this share of the speed, or a rolling radius that differs from the wheel's by more, is
/// probably in another unit.
constexpr double largest_motion_share = 0.3;
/// mm. A curve with a smaller radius is probably one in m: trams have some 15 m.
constexpr double least_curve_radius = 1e4;
/// mm. Contact this near to the height of a flange's tip is contact on the tip.
constexpr double flange_tip_depth = 2.0;

/// `on_rail`: wheels and rails are not as soft as patches may be.
void look_at_materials(const SceneFile& scene, bool on_rail, Warnings& out) {
  for (const auto& [key, body] :
       {std::pair{"rail.material", &scene.rail}, std::pair{"wheel.material", &scene.wheel}}) {
    const double young = body->material.young();
    if (young > stiffest_modulus)
      out.add(WarningKind::unlikely_value,
              fmt::format("{}: a Young's modulus of {:.3g} MPa is above that of diamond (the unit is MPa)",
                          key, young),
              key);
    if (on_rail && young < softest_modulus)
      out.add(
          WarningKind::unlikely_value,
          fmt::format("{}: a Young's modulus of {:g} MPa is below that of hard plastics (the unit is MPa)",
                      key, young),
          key);
  }
}

/// The other wheel is not computed: does its flange stand on its rail?
void look_at_lateral(const SceneFile& scene, Warnings& out) {
  const SceneFile::Position& p = scene.position;
  const double away =
      p.side == WheelSide::left ? p.lateral : -p.lateral; // of this wheel's flange from its rail
  const double room = (p.gauge - p.back_to_back) / 2 - thinnest_flange;
  if (by_gauge_and_flange(scene) && away > room)
    out.add(
        WarningKind::unlikely_value,
        fmt::format("position.lateral = {:g} mm moves this wheel's flange away from its rail, and the other "
                    "wheel's flange over its own: between gauge and flange backs there are {:.3g} mm at "
                    "most (+ is to the right)",
                    p.lateral, room),
        "position.lateral");
}

void look_at_motion(const SceneFile& scene, double rolling_radius, Warnings& out) {
  const SceneFile::Motion& m = scene.motion;
  const double radius = scene.position.wheel_radius;
  const auto unlike = [&](double r) { return std::abs(r - radius) > largest_motion_share * radius; };
  if (m.pitch_rate && unlike(rolling_radius))
    out.add(WarningKind::unlikely_value,
            fmt::format("motion.speed over motion.pitch_rate is a rolling radius of {:.4g} mm on a wheel of "
                        "{:g} mm: it slides (the unit of the speed is mm/s)",
                        rolling_radius, radius),
            "motion.pitch_rate");
  else if (m.rolling_radius && unlike(*m.rolling_radius))
    out.add(WarningKind::unlikely_value,
            fmt::format("motion.rolling_radius is {:g} mm on a wheel of {:g} mm: it slides",
                        *m.rolling_radius, radius),
            "motion.rolling_radius");
  if (const double speed = m.roller_speed.value_or(0) * scene.rail.roller_radius.value_or(0);
      m.speed && speed > 0 && std::abs(speed - *m.speed) > largest_motion_share * *m.speed)
    out.add(
        WarningKind::unlikely_value,
        fmt::format("motion.roller_speed moves the roller's surface with {:.4g} mm/s, and motion.speed is "
                    "{:g} mm/s: the wheel slides",
                    speed, *m.speed),
        "motion.roller_speed");
  if (std::abs(m.phi) * radius > largest_spin)
    out.add(WarningKind::unlikely_value,
            fmt::format("motion.phi = {:g} per mm is the spin of a radius of {:.3g} mm (the unit is 1/mm)",
                        m.phi, 1 / std::abs(m.phi)),
            "motion.phi");
  for (const auto& [key, velocity] : {std::pair{"lateral_velocity", m.lateral_velocity},
                                      std::pair{"vertical_velocity", m.vertical_velocity}})
    if (m.speed && std::abs(velocity) > largest_motion_share * *m.speed)
      out.add(WarningKind::unlikely_value,
              fmt::format("motion.{} is {:.3g} times motion.speed (the unit of both is mm/s)", key,
                          std::abs(velocity) / *m.speed),
              key);
}

void look_at_track(const SceneFile::Track& track, Warnings& out) {
  if (track.curve_radius && std::abs(*track.curve_radius) < least_curve_radius)
    out.add(WarningKind::unlikely_value,
            fmt::format("track.curve_radius = {:g} mm is a curve of {:.3g} m (the unit is mm)",
                        *track.curve_radius, std::abs(*track.curve_radius) / 1000),
            "track.curve_radius");
}

/// The flange's tip; the wheel's section as its table has it.
std::optional<Point2> flange_tip_of(const TabulatedProfile& wheel) {
  std::vector<Point2> points;
  for (const TabulatedProfile::Node& node : wheel.nodes())
    points.push_back(node.position);
  return flange_tip(points);
}

/// Where the tip of the flange is, if the wheel stands on it.
std::optional<Point2> flange_tip_below(const WheelRailGeometry& placed) {
  const TabulatedProfile& wheel = placed.pair.wheel;
  const auto depth = [](const TabulatedProfile::Node& node) { return node.position.z; };
  const double deepest = depth(std::ranges::max(wheel.nodes(), {}, depth));
  if (wheel.at(placed.touch.front().wheel_s).position.z <= deepest - flange_tip_depth)
    return std::nullopt;
  return flange_tip_of(wheel);
}

} // namespace

bool by_gauge_and_flange(const SceneFile& scene) {
  return scene.rail.place == BodyPlace::gauge && scene.wheel.place == BodyPlace::gauge;
}

std::string no_play(const WheelsetPosition& position, const TabulatedProfile& wheel) {
  const std::optional<Point2> tip = flange_tip_of(wheel);
  if (!tip)
    return "";
  // The flank of the flange where the gauge is measured, or at half its height if it is as low as that.
  const double depth = std::min(position.gauge_height, tip->z / 2);
  const double tape_circle = position.back_to_back / 2 + position.tape_circle;
  double flank = tip->y;
  for (const TabulatedProfile::Node& node : wheel.nodes())
    if (node.position.z < depth && node.position.y > tip->y)
      flank = node.position.y; // walked towards the flange: the last one counts
  const double play = position.gauge / 2 - (tape_circle + flank);
  if (play >= 0)
    return "";
  return fmt::format(
      "there is no play: at lateral displacement 0 the flange stands {:.1f} mm beyond the gauge face, {:g} "
      "mm below "
      "the top of the rail, and so does that of the other wheel: the wheelset stands on both flanges (check "
      "position.gauge and position.back_to_back, and with wheel.flange_back where the file's y = 0 is)",
      -play, depth);
}

void warn_of_kilonewtons(const char* key, double force, int wheels, Warnings& warnings) {
  if (force > 0 && force < wheels * least_wheel_load)
    warnings.add(WarningKind::unlikely_value,
                 fmt::format("{} looks like kN ({:g} N on {}). Give it in N.", key, force,
                             wheels == 1 ? "a wheel" : "an axle"),
                 key);
}

std::string inclined_twice(const RailInclination& rail, double given) {
  if (given == 0 || rail.get() == 0) // then nobody need look for the other one
    return "";
  if (rail.get() > 0)
    return leans_outwards(rail.get());
  return fmt::format("the rail's file is already inclined ({}), and position.rail_inclination = {:g} "
                     "inclines it again: give "
                     "position.rail_inclination = 0 with it",
                     inclination_text(rail.get()), given);
}

Warnings input_warnings(const SceneFile& scene, const ContactSetup& setup) {
  Warnings out;
  for (const Warning& unused : scene.unused)
    out.add(unused);
  look_at_materials(scene, setup.wheel_rail() != nullptr, out);
  if (!scene.motion.frictionless && scene.motion.friction_table.empty() &&
      scene.motion.friction > highest_friction)
    out.add(WarningKind::unlikely_value,
            fmt::format("motion.friction = {:g}: hardly any bodies have more than {:g} (it is no percentage)",
                        scene.motion.friction, highest_friction),
            "motion.friction");
  const Motion& motion = setup.motion;
  const FrictionCoefficients& c = motion.coefficients;
  const bool speed_counts = asked_law(c) || motion.temperature.flash;
  if (motion.tangential && speed_counts && motion.speed < least_speed)
    out.add(WarningKind::unlikely_value,
            fmt::format("motion.speed = {:g} mm/s is below walking pace: give it in mm/s", motion.speed),
            "motion.speed");
  if (const WheelRailGeometry* placed = setup.wheel_rail()) {
    if (setup.load.kind == LoadKind::force)
      warn_of_kilonewtons("load.force", setup.load.force, 1, out);
    if (std::string twice = inclined_twice(placed->rail_inclination, scene.position.rail_inclination);
        !twice.empty())
      out.add(WarningKind::inclined_twice, std::move(twice));
    look_at_lateral(scene, out);
    if (std::string none = by_gauge_and_flange(scene) ? no_play(scene.position, placed->pair.wheel) : "";
        !none.empty())
      out.add(WarningKind::no_play, std::move(none));
    look_at_motion(scene, setup.motion.creepage.rolling_radius, out);
    look_at_track(scene.track, out);
    if (scene.position.wheel_radius > largest_wheel_radius)
      out.add(WarningKind::unlikely_value,
              fmt::format("position.wheel_radius = {:g} mm: the radius is asked for, not the diameter",
                          scene.position.wheel_radius),
              "position.wheel_radius");
    if (const auto tip = flange_tip_below(*placed))
      out.add(
          WarningKind::flange_tip,
          fmt::format(
              "the wheel stands on the tip of its flange, y = {:.1f} mm of its profile: it has left the "
              "track (position.lateral, position.gauge, position.back_to_back), or the profile's y = 0 is "
              "not at the tape circle (wheel.flange_back)",
              tip->y));
  }
  return out;
}

} // namespace bem_contact
