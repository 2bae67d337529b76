#pragma once

#include <cstddef>
#include <cstdint>

/// What a server does with its sockets beside what cpp-httplib does.
namespace bem_contact::system {

using Socket = std::uintptr_t; ///< a file's number, or a handle

/// False: nothing came, or nothing could be sent, within `milliseconds`.
bool wait_to_receive(Socket socket, int milliseconds);
bool wait_to_send(Socket socket, int milliseconds);

/// Bytes; 0: the other side has ended it; negative: it failed.
std::ptrdiff_t receive(Socket socket, char* to, std::size_t size);
std::ptrdiff_t send(Socket socket, const char* from, std::size_t size);

void end_connection(Socket socket); ///< whoever waits for it waits no longer
void close_socket(Socket socket);
void let_wait(Socket socket, int connections); ///< until they are accepted

/// Its port may have been another program's a moment ago, but is no other program's now.
void have_port_alone(Socket socket);

} // namespace bem_contact::system
