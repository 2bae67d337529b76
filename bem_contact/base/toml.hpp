#pragma once

/// toml++ asserts what wrong files do not fulfil (a line that is "[" alone), and says itself what is wrong. A
/// build with assertions must refuse these files, too.
#define TOML_ASSERT(expression) static_assert(true)
#include <toml++/toml.h>
