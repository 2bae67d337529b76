#pragma once

#include "bem_contact/uses/wheelset/solve_wheelset.hpp"

#include <fmt/format.h>

#include <string>

namespace bem_contact {

/// Wheels that are cones of 1:40 on rail heads of radius 300 mm; `more`: lines of TOML with dotted keys.
inline SceneFile cones(const std::string& more) {
  const std::string folder = CONFORMAL_SOURCE_DIR "/tools/examples/";
  return parse_scene_file(
      fmt::format("rail = {{ profile = '{0}coned_rail.toml', place = 'absolute', y = 750 }}\n"
                  "wheel = {{ profile = '{0}coned_wheel.toml', place = 'absolute', y = 750 }}\n"
                  "solver.model = 'halfspace'\nwheelset.force = 1e5\n"
                  "grid = {{ dx = 0.8, ds = 0.8 }}\n{1}",
                  folder, more));
}

/// S1002 on 60E1, inclined 1:40.
inline SceneFile standard(const std::string& more) {
  return parse_scene_file(
      "rail.profile = '60E1'\nwheel.profile = 'S1002'\nsolver.model = 'halfspace'\n"
      "position.rail_inclination = 0.025\nwheelset.force = 2e5\ngrid = { dx = 0.8, ds = 0.6 }\n" +
      more);
}

} // namespace bem_contact
