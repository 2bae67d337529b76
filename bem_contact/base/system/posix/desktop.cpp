#include "bem_contact/base/system/desktop.hpp"

#include <array>
#include <cstdlib>
#include <fcntl.h>
#include <spawn.h>
#include <string>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace bem_contact::system {

bool has_desktop() {
  return std::getenv("DISPLAY") || std::getenv("WAYLAND_DISPLAY");
}

void show_page(const std::filesystem::path& page) {
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    posix_spawn_file_actions_addopen(&actions, stream, "/dev/null", O_RDWR, 0);
  std::string program = "xdg-open", file = page.string();
  std::array<char*, 3> words{program.data(), file.data(), nullptr};
  pid_t child = 0;
  if (posix_spawnp(&child, words[0], &actions, nullptr, words.data(), environ) == 0)
    std::thread([child] { waitpid(child, nullptr, 0); }).detach(); // it may last as long as the browser
  posix_spawn_file_actions_destroy(&actions);
}

} // namespace bem_contact::system
