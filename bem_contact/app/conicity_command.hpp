#pragma once

#include "bem_contact/app/command.hpp"

namespace bem_contact::app {

/// `bem_contact conicity [SCENE]`.
Command add_conicity(CLI::App& program);

} // namespace bem_contact::app
