#pragma once

#include "bem_contact/app/command.hpp"

namespace bem_contact::app {

/// `bem_contact wear SCENE`: profiles wear under a load collective.
Command add_wear(CLI::App& program);

} // namespace bem_contact::app
