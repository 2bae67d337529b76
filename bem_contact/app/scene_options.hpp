#pragma once

#include "bem_contact/app/command.hpp"

#include <string>
#include <vector>

namespace bem_contact::app {

/// The table of a scene file that has the options of a command: "creep_curves" for creep-curves.
std::string table_name(std::string command);

/// Gives the parsed `command` the options that its table in the scene file holds and its line does not: the
/// key of --most-points is most_points. Throws InputError, with file and line, for a value that the option
/// refuses, and for a key in the table of any command of `all` that neither is one of its options nor has
/// another meaning in a scene.
void take_options_of_scene(const Command& command, const std::vector<Command>& all);

} // namespace bem_contact::app
