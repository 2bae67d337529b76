#pragma once

#include "bem_contact/base/toml.hpp"
#include "bem_contact/scene/scene_text.hpp"

#include <initializer_list>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace bem_contact {

/// Tables of a scene file that commands read. No scene depends on them: it is the same with and without. The
/// table [wear] is one of a scene (the wear map) and of a command.
inline constexpr std::string_view command_tables[] = {"sweep",     "table",     "creep_curves", "conicity",
                                                      "fatigue",   "shakedown", "compare",      "uncertainty",
                                                      "influence", "replay",    "fit",          "passage"};

/// Keys of such a table, or of [wear], that are options of the command of its name; none of a table that has
/// none, or is read elsewhere. Lists of [table] are axes.
std::span<const std::string_view> option_keys(std::string_view table);

/// Throws InputError, with `source` and line, for a key that the table of this name does not have.
void require_known_options(const toml::table& values, std::string_view table, const std::string& source);
/// Does so for all of these tables. A text that is no TOML passes: whoever reads it says what is wrong.
void require_known_options(const SceneText& scene);

/// What keys of scenes begin with, each once: "rail", "load", "derivatives" ...
std::vector<std::string> first_names_of_scenes();

/// Throws InputError for a table that no scene has and whose name is like `section`, a table with lists,
/// which is not there.
void require_no_misspelt_section(const SceneText& text, std::string_view section);

/// The files that such a table names, as texts or in lists of texts, and that are there.
std::vector<std::string> files_of_table(const SceneText& scene, std::string_view table);

/// The text of a scene without the tables of commands that are not `kept`, and without comments: what an
/// answer that uses these tables depends on. Each `left_out` ("wear.depth") is missing, too. A text that is
/// no TOML stays as it is.
std::string text_for(const SceneText& scene, std::initializer_list<std::string_view> kept,
                     std::initializer_list<std::string_view> left_out = {});

} // namespace bem_contact
