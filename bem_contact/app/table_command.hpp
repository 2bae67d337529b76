#pragma once

#include "bem_contact/app/command.hpp"

namespace bem_contact::app {

/// `bem_contact table SCENE`, `bem_contact table --creep-forces`, and values of such a table.
Command add_table(CLI::App& program);

} // namespace bem_contact::app
