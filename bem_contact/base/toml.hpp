#pragma once

/// toml++ asserts what wrong files do not fulfil (a line that is "[" alone), and says itself what is wrong. A
/// build with assertions must refuse these files, too.
#define TOML_ASSERT(expression) static_assert(true)
#include <toml++/toml.h>

#include <string_view>

namespace bem_contact {

/// toml::parse(), which all of this project call by this name. Throws toml::parse_error also for keys and
/// tables that are nested so deep (a.a.a. ...) that the library would run out of stack.
toml::table parse_toml(std::string_view text, std::string_view source = {});

} // namespace bem_contact
