#pragma once

#include "bem_contact/app/command.hpp"

namespace bem_contact::app {

/// `bem_contact fatigue SCENE`: shakedown, damage and stresses below the surface of each case of a sweep.
Command add_fatigue(CLI::App& program);

} // namespace bem_contact::app
