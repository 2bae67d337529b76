#pragma once

#include "bem_contact/explore/start.hpp"

namespace bem_contact::explore {

struct ExploreOptions {
  int port = 0;             ///< 0: any that is free
  bool open_browser = true; ///< where there is a desktop
};

/// Serves the page on this machine alone, and prints its address. Returns after Ctrl-C, SIGTERM, or when the
/// terminal is closed. Throws InputError if the port is taken, or if this build has no plotting library.
void explore(const Start& start, const ExploreOptions& options);

} // namespace bem_contact::explore
