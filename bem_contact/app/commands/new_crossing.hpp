#pragma once

#include "bem_contact/app/command.hpp"

#include <string>

namespace bem_contact::app {

/// A crossing without a drawing: a wing rail that leads away and a nose beside it, by angles.
struct NewCrossing {
  std::string wheel, rail, output;
  std::string wheel_in_scene; ///< its name as seen from the scene's folder
  double number = 0;          ///< N of the crossing's angle 1:N; 0: no crossing
  double flangeway = 44;      ///< mm, between nose and wing
  double nose_width = 10;     ///< mm, where the nose begins
  double full_width = 40;     ///< mm, where its top reaches the height of the rail
  double nose_drop = 4;       ///< mm, how much lower it begins
  double load = 8e4;          ///< N, of the wheel
  double friction = 0.3;
};

/// Writes a scene and, beside it, a folder of profile files for its [[rail.sections]]. Throws InputError for
/// outputs that exist, for measures that make no crossing and for a rail that is not deep enough.
ExitCode write_crossing(const NewCrossing& asked);

} // namespace bem_contact::app
