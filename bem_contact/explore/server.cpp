#include "bem_contact/explore/server.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/base/system/sockets.hpp"
#include "bem_contact/explore/settings.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <fmt/format.h>
#include <httplib.h>
#include <memory>
#include <mutex>
#include <random>
#include <utility>
#include <vector>

namespace bem_contact::explore {

namespace {

using httplib::Request;
using httplib::Response;

/// 128 bits that nobody guesses.
std::string new_token() {
  std::random_device random; // of the system or the processor: it has no seed
  std::string token;
  for (int k = 0; k < 4; ++k)
    token += fmt::format("{:08x}", random());
  return token;
}

/// Takes the same time for any text of one length, so that no token is found letter by letter.
bool same(std::string_view a, std::string_view b) {
  unsigned differ = a.size() == b.size() ? 0 : 1;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
    differ |= static_cast<unsigned>(a[i] ^ b[i]);
  return differ == 0;
}

void refuse(Response& response, int status, const char* message) {
  response.status = status;
  response.set_content(std::string(message) + "\n", "text/plain; charset=utf-8");
}

/// The library compresses what it is given as a text. That takes ten times as long as a solution, and nothing
/// leaves this machine.
void send(Response& response, std::shared_ptr<const std::string> text, const std::string& type) {
  const std::size_t size = text->size();
  response.set_content_provider(
      size, type, [text = std::move(text)](std::size_t from, std::size_t length, httplib::DataSink& sink) {
        return sink.write(text->data() + from, length);
      });
}

/// Another page of the browser learns nothing of this one, and this one asks nobody else.
const httplib::Headers headers_of_all{
    {"Cache-Control", "no-store"},
    {"Content-Security-Policy",
     "default-src 'none'; script-src 'unsafe-inline' blob:; style-src 'unsafe-inline'; img-src data: blob:; "
     "connect-src 'self'; frame-ancestors 'none'; base-uri 'none'; form-action 'none'"},
    {"Cross-Origin-Resource-Policy", "same-origin"},
    {"Referrer-Policy", "no-referrer"},
    {"X-Content-Type-Options", "nosniff"},
    {"X-Frame-Options", "DENY"}};

using Clock = std::chrono::steady_clock;

/// One that is open, and how far it has come.
struct Connection {
  system::Socket socket;
  Clock::time_point until; ///< when the request that is being read must be here
  bool knows_token = false;
  std::array<char, read_at_once> received = {}; ///< by the system, and not read yet: those from `next` on
  std::size_t next = 0, end = 0;
};

/// What is read and written on a connection, each within its whole time: the library limits the time between
/// two bytes alone, so that a byte now and then would hold a thread for ever. It reads the head of a request
/// byte by byte: asking the system for each would take seconds by wine on a busy machine.
class TimedStream : public httplib::Stream {
public:
  explicit TimedStream(Connection& connection) : connection_(connection) {}

  bool is_readable() const override {
    if (connection_.next < connection_.end)
      return true;
    const int left = milliseconds_to(connection_.until);
    return left > 0 && system::wait_to_receive(connection_.socket, left);
  }
  bool is_writable() const override {
    const int left = milliseconds_to(writing_until());
    return left > 0 && system::wait_to_send(connection_.socket, left);
  }
  ssize_t read(char* to, std::size_t size) override {
    Connection& c = connection_;
    if (c.next == c.end) {
      const auto got = is_readable() ? system::receive(c.socket, c.received.data(), c.received.size()) : -1;
      if (got <= 0)
        return got;
      c.next = 0;
      c.end = static_cast<std::size_t>(got);
    }
    const std::size_t count = std::min(size, c.end - c.next);
    std::copy_n(c.received.data() + c.next, count, to);
    c.next += count;
    return static_cast<ssize_t>(count);
  }
  ssize_t write(const char* from, std::size_t size) override {
    return is_writable() ? system::send(connection_.socket, from, size) : -1;
  }
  void get_remote_ip_and_port(std::string& ip, int& port) const override { ip = "127.0.0.1", port = 0; }
  void get_local_ip_and_port(std::string& ip, int& port) const override { ip = "127.0.0.1", port = 0; }
  socket_t socket() const override { return static_cast<socket_t>(connection_.socket); }

private:
  Clock::time_point writing_until() const {
    if (writing_since_ == Clock::time_point())
      writing_since_ = Clock::now();
    return writing_since_ + to_be_written;
  }
  static int milliseconds_to(Clock::time_point until) {
    return static_cast<int>(
        std::chrono::duration_cast<std::chrono::milliseconds>(until - Clock::now()).count());
  }

  Connection& connection_;
  mutable Clock::time_point writing_since_ = {};
};

/// The connections of a server, each of which is cut off when the server ends.
class Connections {
public:
  /// Of this thread; null where it serves none.
  static Connection*& current() {
    thread_local Connection* connection = nullptr;
    return connection;
  }

  /// False where the server ends.
  bool add(Connection& connection) {
    const std::scoped_lock lock(mutex_);
    if (ending_)
      return false;
    open_.push_back(&connection);
    return true;
  }
  /// Before it is closed, so that its number is nobody else's yet.
  void remove(Connection& connection) {
    const std::scoped_lock lock(mutex_);
    std::erase(open_, &connection);
  }
  void knows_token(Connection& connection) {
    const std::scoped_lock lock(mutex_);
    connection.knows_token = true;
  }
  /// A new one has come: where no thread is free, the oldest that has not shown the token ends.
  void make_room() {
    const std::scoped_lock lock(mutex_);
    if (open_.size() < most_connections)
      return;
    const auto oldest = std::ranges::find_if(open_, [](const Connection* one) { return !one->knows_token; });
    if (oldest != open_.end())
      system::end_connection((*oldest)->socket);
  }
  void end_all() {
    const std::scoped_lock lock(mutex_);
    ending_ = true;
    for (const Connection* one : open_)
      system::end_connection(one->socket);
  }

private:
  std::mutex mutex_;
  std::vector<Connection*> open_; ///< the oldest first
  bool ending_ = false;
};

/// The library's threads.
class Threads : public httplib::ThreadPool {
public:
  explicit Threads(Connections& connections) : ThreadPool(most_connections), connections_(connections) {}
  void enqueue(std::function<void()> work) override {
    connections_.make_room();
    ThreadPool::enqueue(std::move(work));
  }

private:
  Connections& connections_;
};

/// The library's server, with limits on the time of whole requests.
class TimedServer : public httplib::Server {
public:
  Connections& connections() { return connections_; }
  /// The library lets five wait.
  void let_more_wait() const {
    system::let_wait(static_cast<system::Socket>(svr_sock_.load()), most_waiting);
  }

private:
  bool process_and_close_socket(socket_t socket) override {
    Connection connection{static_cast<system::Socket>(socket), Clock::now() + to_show_token};
    bool closed = !connections_.add(connection);
    Connections::current() = &connection;
    while (!closed) {
      TimedStream stream(connection);
      if (!stream.is_readable())
        break;
      if (connection.knows_token) // else the time since it came counts
        connection.until = Clock::now() + to_be_read;
      closed = !process_request(stream, false, closed, nullptr) || closed || !connection.knows_token;
      connection.until = Clock::now() + keep_open;
    }
    Connections::current() = nullptr;
    connections_.remove(connection);
    system::end_connection(connection.socket);
    system::close_socket(connection.socket);
    return true;
  }

  Connections connections_;
};

class HttpServer : public Server {
public:
  HttpServer(std::vector<Route> routes, std::string text, int port)
      : routes_(std::move(routes)), page_(std::make_shared<const std::string>(std::move(text))) {
    open(port);
    prepare();
  }

  const std::string& address() const override { return address_; }
  void serve() override { server_.listen_after_bind(); }
  void stop() override {
    server_.connections().end_all();
    server_.stop();
  }

private:
  void open(int wanted) {
    server_.set_socket_options(
        [](socket_t socket) { system::have_port_alone(static_cast<system::Socket>(socket)); });
    const int port = wanted == 0                                 ? server_.bind_to_any_port("127.0.0.1")
                     : server_.bind_to_port("127.0.0.1", wanted) ? wanted
                                                                 : -1;
    if (port < 0)
      throw InputError(fmt::format("Port {} cannot be used", wanted), "another program may use it",
                       "Name another one with --port, or leave --port out.");
    server_.let_more_wait();
    host_ = fmt::format("127.0.0.1:{}", port);
    address_ = fmt::format("http://{}/{}/", host_, token_);
  }

  /// Whether somebody else than our page asks; then the response says so.
  bool refused(const Request& request, Response& response) const {
    const std::string& path = request.path;
    const std::size_t end = path.find('/', 1);
    if (path.empty() || end == std::string::npos || !same(path.substr(1, end - 1), token_))
      refuse(response, 404,
             "There is nothing here (the address is not the one that bem_contact explore printed)");
    else if (request.get_header_value("Host") != host_ || request.get_header_value_count("Host") != 1)
      refuse(response, 403,
             "This page is for its own machine alone (the host of the request is another one)");
    else if (request.has_header("Origin") && request.get_header_value("Origin") != "http://" + host_)
      refuse(response, 403, "This page answers itself alone (the request comes from another page)");
    else if (request.method != "GET" && request.method != "HEAD" && request.method != "POST")
      refuse(response, 405, "Only GET and POST are answered here");
    else if (request.method == "POST" && request.get_header_value("Content-Type") != "application/json")
      refuse(response, 415, "A question is application/json");
    else
      return false;
    return true;
  }

  void add_routes() {
    const std::string at = "/" + token_ + "/";
    server_.Get(at, [this](const Request&, Response& response) {
      send(response, page_, "text/html; charset=utf-8");
    });
    for (const Route& one : routes_)
      server_.Post(at + one.name, [&one](const Request& request, Response& response) {
        Reply reply = one.reply(request.body);
        send(response, std::make_shared<const std::string>(std::move(reply.body)), reply.type);
      });
  }

  void prepare() {
    server_.new_task_queue = [this] { return new Threads(server_.connections()); }; // the library deletes it
    server_.set_tcp_nodelay(true); // or each answer waits 40 ms
    server_.set_payload_max_length(largest_request);
    server_.set_default_headers(headers_of_all);
    server_.set_pre_routing_handler([this](const Request& request, Response& response) {
      if (refused(request, response))
        return httplib::Server::HandlerResponse::Handled;
      if (Connection* connection = Connections::current()) {
        server_.connections().knows_token(*connection);
        connection->until = Clock::now() + to_be_read;
      }
      return httplib::Server::HandlerResponse::Unhandled;
    });
    server_.set_exception_handler([](const Request&, Response& response, const std::exception_ptr&) {
      refuse(response, 500, "Something this program did not foresee");
    });
    add_routes();
  }

  std::vector<Route> routes_;
  std::shared_ptr<const std::string> page_;
  std::string token_ = new_token(), host_, address_;
  TimedServer server_;
};

} // namespace

} // namespace bem_contact::explore

/// By its name in the library (OpenServer).
extern "C" __attribute__((visibility("default"))) bem_contact::explore::Server*
bem_contact_open_server(std::vector<bem_contact::explore::Route> routes, std::string page, int port) {
  return new bem_contact::explore::HttpServer(std::move(routes), std::move(page), port);
}
