#include "bem_contact/base/loaded_library.hpp"
#include "bem_contact/explore/server.hpp"

namespace bem_contact::explore {

std::unique_ptr<Server> open_server(std::vector<Route> routes, std::string page, int port) {
  static constexpr LoadedLibrary http(CONFORMAL_HTTP_LIBRARY);
  static constinit const LoadedFunction<OpenServer> open(http, open_server_name);
  return std::unique_ptr<Server>(open(std::move(routes), std::move(page), port));
}

} // namespace bem_contact::explore
