#include "bem_contact/base/error.hpp"
#include "bem_contact/explore/explore.hpp"

namespace bem_contact::explore {

/// On Windows, until the server is there.
void explore(const Start&, const ExploreOptions&) {
  throw InputError("bem_contact explore is not there on Windows", "its server is written for Linux",
                   "Use it in WSL2, or the page with the solver inside, which needs a browser alone.");
}

} // namespace bem_contact::explore
