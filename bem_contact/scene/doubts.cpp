#include "bem_contact/scene/doubts.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace bem_contact {

namespace {

constexpr double highest_friction = 2; // clean metals in air stay below
constexpr double stiffest = 1.3e6;     // MPa, somewhat above diamond
constexpr double largest_wheel = 750;  // mm; of railways in service: 625
constexpr double largest_share = 0.3;  // of the forward speed; also of the wheel radius
constexpr double flange = 10, tip = 2; // mm: a flange stands out so much; its tip is so deep

void doubt_material(const Material& material, const char* key, std::vector<std::string>& out) {
  if (material.young() > stiffest)
    out.push_back(
        fmt::format("{}: a Young's modulus of {:.3g} MPa is above that of diamond (the unit is MPa)", key,
                    material.young()));
}

void doubt_motion(const SceneFile& scene, const WheelRailScene& placed, std::vector<std::string>& out) {
  const SceneFile::Motion& m = scene.motion;
  const double radius = scene.position.wheel_radius;
  const auto unlike = [&](double r) { return std::abs(r - radius) > largest_share * radius; };
  if (m.pitch_rate && unlike(placed.rolling_radius))
    out.push_back(
        fmt::format("motion.speed over motion.pitch_rate is a rolling radius of {:.4g} mm on a wheel of "
                    "{:g} mm: it slides (the unit of the speed is mm/s)",
                    placed.rolling_radius, radius));
  else if (m.rolling_radius && unlike(*m.rolling_radius))
    out.push_back(fmt::format("motion.rolling_radius is {:g} mm on a wheel of {:g} mm: it slides",
                              *m.rolling_radius, radius));
  for (const auto& [key, velocity] : {std::pair{"lateral_velocity", m.lateral_velocity},
                                      std::pair{"vertical_velocity", m.vertical_velocity}})
    if (m.speed && std::abs(velocity) > largest_share * *m.speed)
      out.push_back(fmt::format("motion.{} is {:.3g} times motion.speed (the unit of both is mm/s)", key,
                                std::abs(velocity) / *m.speed));
}

void doubt_position(const SceneFile& scene, const WheelRailScene& placed, std::vector<std::string>& out) {
  if (scene.position.wheel_radius > largest_wheel)
    out.push_back(fmt::format("position.wheel_radius = {:g} mm: the radius is asked for, not the diameter",
                              scene.position.wheel_radius));
  const TabulatedProfile& wheel = placed.pair.wheel;
  std::vector<double> depths;
  constexpr int steps = 400;
  for (int i = 0; i <= steps; ++i)
    depths.push_back(wheel.at(wheel.s_begin() + (wheel.s_end() - wheel.s_begin()) * i / steps).position.z);
  const double deepest = std::ranges::max(depths);
  std::ranges::nth_element(depths, depths.begin() + steps / 2);
  const double here = wheel.at(placed.touch.front().wheel_s).position.z;
  if (deepest - depths[steps / 2] > flange && here > deepest - tip)
    out.push_back("the wheel stands on the tip of its flange: it has left the track (position.lateral, "
                  "position.gauge, position.back_to_back)");
}

} // namespace

std::vector<std::string> doubts(const SceneFile& scene, const WheelRailScene* placed) {
  std::vector<std::string> out = scene.unused;
  doubt_material(scene.rail.material, "rail.material", out);
  doubt_material(scene.wheel.material, "wheel.material", out);
  if (!scene.motion.frictionless && scene.motion.friction_table.empty() &&
      scene.motion.friction > highest_friction)
    out.push_back(
        fmt::format("motion.friction = {:g}: hardly any bodies have more than {:g} (it is no percentage)",
                    scene.motion.friction, highest_friction));
  if (placed) {
    doubt_motion(scene, *placed, out);
    doubt_position(scene, *placed, out);
  }
  return out;
}

} // namespace bem_contact
