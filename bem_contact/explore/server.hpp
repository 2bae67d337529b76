#pragma once

#include "bem_contact/explore/answers.hpp"

#include <functional>
#include <string>

namespace bem_contact::explore {

/// Serves a page on 127.0.0.1, and the page's questions. Whoever asks must know a token that is new in each
/// run and part of every address.
class Server {
public:
  /// Opens the port; 0: any that is free. Throws InputError if it is taken. `answers` must outlive this.
  Server(Answers& answers, std::string page, int port);
  ~Server();
  Server(const Server&) = delete;
  Server& operator=(const Server&) = delete;

  const std::string& address() const; ///< http://127.0.0.1:PORT/TOKEN/
  /// Serves until stop().
  void serve();
  /// May be called by another thread, once serve() was called.
  void stop();

private:
  struct Impl; // the library's header is long
  std::unique_ptr<Impl> impl_;
};

} // namespace bem_contact::explore
