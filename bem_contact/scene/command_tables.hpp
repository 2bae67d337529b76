#pragma once

#include "bem_contact/scene/scene_text.hpp"

#include <initializer_list>
#include <string>
#include <string_view>

namespace bem_contact {

/// Tables of a scene file that commands read. No scene depends on them: it is the same with and without. The
/// table [wear] is one of a scene (the wear map) and of a command.
inline constexpr std::string_view command_tables[] = {"sweep",   "table",   "creep_curves", "conicity",
                                                      "fatigue", "compare", "uncertainty",  "influence"};

/// The text of a scene without the tables of commands that are not `kept`, and without comments: what an
/// answer that uses these tables depends on. Each `left_out` ("wear.depth") is missing, too. A text that is
/// no TOML stays as it is.
std::string text_for(const SceneText& scene, std::initializer_list<std::string_view> kept,
                     std::initializer_list<std::string_view> left_out = {});

} // namespace bem_contact
