#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace bem_contact::explore {

/// What goes back to the page.
struct Reply {
  std::string type; ///< of the content: "application/json"
  std::string body;
};

/// A kind of question, by the last part of its address.
struct Route {
  std::string name;
  std::function<Reply(const std::string& question)> reply;
};

/// Serves a page on 127.0.0.1, and the page's questions. Whoever asks must know a token that is new in each
/// run and part of every address.
class Server {
public:
  Server() = default;
  virtual ~Server() = default;
  Server(const Server&) = delete;
  Server& operator=(const Server&) = delete;

  virtual const std::string& address() const = 0; ///< http://127.0.0.1:PORT/TOKEN/
  /// Serves until stop().
  virtual void serve() = 0;
  /// May be called by another thread, once serve() was called.
  virtual void stop() = 0;
};

/// Opens the port; 0: any that is free. Throws InputError if it is taken, and what LoadedLibrary does: what
/// serves is a library that is opened here.
std::unique_ptr<Server> open_server(std::vector<Route> routes, std::string page, int port);

/// What that library gives: a Server that the caller owns.
using OpenServer = Server*(std::vector<Route> routes, std::string page, int port);
inline constexpr const char* open_server_name = "bem_contact_open_server";

} // namespace bem_contact::explore
