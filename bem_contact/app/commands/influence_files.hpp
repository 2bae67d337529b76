#pragma once

#include <functional>

namespace CLI {
class App;
}

namespace bem_contact::app {

/// Adds `influence list`, `get` and `pack`. Returns what runs the one that the line has; false: it has none.
std::function<bool()> add_influence_files(CLI::App& influence);

} // namespace bem_contact::app
