#include "bem_contact/base/system/sockets.hpp"

#include <algorithm>
#include <climits>
#include <winsock2.h>

namespace bem_contact::system {

namespace {

bool wait_for(short what, Socket socket, int milliseconds) {
  WSAPOLLFD ready{};
  ready.fd = socket;
  ready.events = what;
  return WSAPoll(&ready, 1, milliseconds) == 1;
}

int at_most(std::size_t size) {
  return static_cast<int>(std::min<std::size_t>(size, INT_MAX));
}

} // namespace

bool wait_to_receive(Socket socket, int milliseconds) {
  return wait_for(POLLRDNORM, socket, milliseconds);
}

bool wait_to_send(Socket socket, int milliseconds) {
  return wait_for(POLLWRNORM, socket, milliseconds);
}

std::ptrdiff_t receive(Socket socket, char* to, std::size_t size) {
  return recv(socket, to, at_most(size), 0);
}

std::ptrdiff_t send(Socket socket, const char* from, std::size_t size) {
  return ::send(socket, from, at_most(size), 0);
}

void end_connection(Socket socket) {
  shutdown(socket, SD_BOTH);
}

void close_socket(Socket socket) {
  closesocket(socket);
}

void let_wait(Socket socket, int connections) {
  listen(socket, connections);
}

void have_port_alone(Socket socket) { // by SO_REUSEADDR two programs share a port there
  const BOOL yes = TRUE;
  setsockopt(socket, SOL_SOCKET, SO_EXCLUSIVEADDRUSE, reinterpret_cast<const char*>(&yes), sizeof yes);
}

} // namespace bem_contact::system
