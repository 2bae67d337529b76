#include "bem_contact/explore/server.hpp"

#include <utility>

extern "C" bem_contact::explore::Server*
bem_contact_open_server(std::vector<bem_contact::explore::Route> routes, std::string page, int port);

namespace bem_contact::explore {

/// Where the server is part of the program.
std::unique_ptr<Server> open_server(std::vector<Route> routes, std::string page, int port) {
  return std::unique_ptr<Server>(bem_contact_open_server(std::move(routes), std::move(page), port));
}

} // namespace bem_contact::explore
