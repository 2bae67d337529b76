#pragma once

#include "bem_contact/app/command.hpp"

namespace bem_contact::app {

/// Both wheels of a wheelset: sums given, roll and the share of each wheel found.
Command add_wheelset(CLI::App& program);

} // namespace bem_contact::app
