#include "bem_contact/base/system/sockets.hpp"

#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

namespace bem_contact::system {

namespace {

int number(Socket socket) {
  return static_cast<int>(socket);
}

bool wait_for(short what, Socket socket, int milliseconds) {
  pollfd ready{.fd = number(socket), .events = what, .revents = 0};
  return poll(&ready, 1, milliseconds) == 1;
}

} // namespace

bool wait_to_receive(Socket socket, int milliseconds) {
  return wait_for(POLLIN, socket, milliseconds);
}

bool wait_to_send(Socket socket, int milliseconds) {
  return wait_for(POLLOUT, socket, milliseconds);
}

std::ptrdiff_t receive(Socket socket, char* to, std::size_t size) {
  return recv(number(socket), to, size, 0);
}

std::ptrdiff_t send(Socket socket, const char* from, std::size_t size) {
  return ::send(number(socket), from, size, MSG_NOSIGNAL);
}

void end_connection(Socket socket) {
  shutdown(number(socket), SHUT_RDWR);
}

void close_socket(Socket socket) {
  close(number(socket));
}

void let_wait(Socket socket, int connections) {
  listen(number(socket), connections);
}

void have_port_alone(Socket socket) { // not SO_REUSEPORT, by which two programs share a port
  const int yes = 1;
  setsockopt(number(socket), SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
}

} // namespace bem_contact::system
