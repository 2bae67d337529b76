#pragma once

#include "bem_contact/app/command.hpp"
#include "bem_contact/scene/scene_text.hpp"

#include <string>
#include <vector>

namespace bem_contact::app {

/// The table of a scene file that has the options of a command: "creep_curves" for creep-curves.
std::string table_name(std::string command);

/// The type of options that name a file: in a table of a scene its name is seen from the scene's folder.
inline constexpr const char* file_option = "FILE";

/// Gives the parsed `command` the options that its table in the scene file holds and its line does not: the
/// key of --most-points is most_points. Throws InputError, with file and line, for a value that the option
/// refuses, and for a key in the table of any command of `all` that neither is one of its options nor has
/// another meaning in a scene.
void take_options_of_scene(const Command& command, const std::vector<Command>& all);

/// A scene may be anybody's, and must not start any program of this machine. Throws InputError where it names
/// one in `table`.`key` that the command line does not name, too (`repeated`, of the option --influence).
void require_repeated_program(const SceneText& scene, const char* table, const char* key,
                              const std::string& repeated);

} // namespace bem_contact::app
