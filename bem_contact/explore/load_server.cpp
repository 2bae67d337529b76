#include "bem_contact/base/error.hpp"
#include "bem_contact/explore/server.hpp"

#include <dlfcn.h>

namespace bem_contact::explore {

std::unique_ptr<Server> open_server(std::vector<Route> routes, std::string page, int port) {
  // Never unloaded: its server and what it throws live on. It lies where the program looks for its libraries.
  void* library = dlopen(CONFORMAL_HTTP_LIBRARY, RTLD_NOW);
  void* function = library ? dlsym(library, open_server_name) : nullptr;
  if (!function) {
    const char* why = dlerror();
    throw Error("The page cannot be served", why ? why : "its library lacks a function",
                "Install this program again, with all of its libraries.");
  }
  return std::unique_ptr<Server>(
      reinterpret_cast<OpenServer*>(function)(std::move(routes), std::move(page), port));
}

} // namespace bem_contact::explore
