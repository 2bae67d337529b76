#include "bem_contact/explore/explore.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/base/printable.hpp"
#include "bem_contact/base/temporary_folder.hpp"
#include "bem_contact/explore/answers.hpp"
#include "bem_contact/explore/computer.hpp"
#include "bem_contact/explore/explore_page.hpp"
#include "bem_contact/explore/server.hpp"

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <fcntl.h>
#include <filesystem>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace bem_contact::explore {

namespace {

// A handler may do hardly anything: it writes one byte here, and somebody waits at the other end. Handlers
// are the process's own, so that this is too.
int to_waiting = -1;

extern "C" void note_signal(int) {
  const int before = errno;
  static_cast<void>(!write(to_waiting, "x", 1));
  errno = before;
}

/// While the object lives, the signals that end a program are waited for instead.
class EndingSignals {
public:
  EndingSignals() {
    if (pipe2(pipe_.data(), O_CLOEXEC) != 0)
      throw Error("The page cannot be served", "the system opens no more files", "Close other programs.");
    to_waiting = pipe_[1];
    struct sigaction action {};
    action.sa_handler = note_signal;
    sigemptyset(&action.sa_mask);
    for (std::size_t i = 0; i < signals.size(); ++i)
      sigaction(signals[i], &action, &before_[i]);
  }
  ~EndingSignals() {
    for (std::size_t i = 0; i < signals.size(); ++i)
      sigaction(signals[i], &before_[i], nullptr);
    for (const int end : pipe_)
      close(end);
  }
  EndingSignals(const EndingSignals&) = delete;
  EndingSignals& operator=(const EndingSignals&) = delete;

  void wait() const {
    char byte = 0;
    while (read(pipe_[0], &byte, 1) < 0 && errno == EINTR) {
    }
  }

private:
  static constexpr std::array signals{SIGINT, SIGTERM, SIGHUP};
  std::array<int, 2> pipe_{-1, -1};
  std::array<struct sigaction, signals.size()> before_{};
};

/// A page that leads to the address. All users of a machine see the words of a command, and with them the
/// token would be everybody's; the folder of this file is its user's alone.
std::filesystem::path page_that_leads_to(const std::string& address, const TemporaryFolder& folder) {
  return folder.write("explore.html",
                      fmt::format("<!doctype html><meta charset=utf-8><meta http-equiv=refresh "
                                  "content=\"0;url={0}\"><a href=\"{0}\">bem_contact explore</a>\n",
                                  address));
}

/// Without a desktop or a browser nothing happens: the address is printed.
void show_in_browser(const std::string& address, const TemporaryFolder& folder) {
  if (!std::getenv("DISPLAY") && !std::getenv("WAYLAND_DISPLAY"))
    return;
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    posix_spawn_file_actions_addopen(&actions, stream, "/dev/null", O_RDWR, 0);
  std::string program = "xdg-open", page = page_that_leads_to(address, folder).string();
  std::array<char*, 3> words{program.data(), page.data(), nullptr};
  pid_t child = 0;
  if (posix_spawnp(&child, words[0], &actions, nullptr, words.data(), environ) == 0)
    std::thread([child] { waitpid(child, nullptr, 0); }).detach(); // it may last as long as the browser
  posix_spawn_file_actions_destroy(&actions);
}

} // namespace

void explore(const Start& start, const ExploreOptions& options) {
  const std::unique_ptr<Computer> computer = program_computer();
  Answers answers(start, computer.get());
  std::vector<Route> routes;
  for (const Asked& one : all_asked)
    routes.push_back({std::string(one.name), [&answers, reply = one.reply](const std::string& question) {
                        return (answers.*reply)(question);
                      }});
  const std::unique_ptr<Server> server = open_server(std::move(routes), explore_page(start), options.port);
  const EndingSignals signals;
  print_out("Open this address in a browser on this machine:\n    {}\nCtrl-C ends it.\n", server->address());
  if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0)
    throw Error("The page is not served", "its address could not be printed, so that nobody would find it",
                "Look where standard output goes.");
  const TemporaryFolder folder;
  std::thread serving([&] { server->serve(); });
  if (options.open_browser)
    show_in_browser(server->address(), folder);
  signals.wait();
  answers.end();
  server->stop();
  serving.join();
}

} // namespace bem_contact::explore
