#include "bem_contact/base/system/temporary.hpp"

#include <mutex>
#include <random>
#include <string>
#include <vector>
#include <windows.h>

namespace bem_contact::system {

std::filesystem::path new_temporary_folder(std::error_code& problem) {
  const std::filesystem::path among = std::filesystem::temp_directory_path(problem);
  std::random_device random;
  constexpr int tries = 100;
  for (int k = 0; !problem && k < tries; ++k) {
    std::filesystem::path folder = among / ("bem_contact_" + std::to_string(random()));
    if (std::filesystem::create_directory(folder, problem))
      return folder;
  }
  if (!problem)
    problem = std::make_error_code(std::errc::file_exists);
  return {};
}

namespace {

/// A handler is the process's own and runs on a thread of its own.
struct LivingFolders {
  std::mutex mutex;
  std::vector<std::filesystem::path> paths;
};

LivingFolders& living() {
  static LivingFolders folders;
  return folders;
}

BOOL WINAPI remove_folders(DWORD) {
  const std::lock_guard lock(living().mutex);
  for (const std::filesystem::path& folder : living().paths) {
    std::error_code in_use; // a file that is open stays
    std::filesystem::remove_all(folder, in_use);
  }
  return FALSE; // and then what would have been done otherwise
}

} // namespace

/// Ctrl-C, and the end of the window.
void remove_at_signals(const std::filesystem::path& folder) {
  const std::lock_guard lock(living().mutex);
  if (living().paths.empty())
    SetConsoleCtrlHandler(remove_folders, TRUE);
  living().paths.push_back(folder);
}

void keep_at_signals(const std::filesystem::path& folder) {
  const std::lock_guard lock(living().mutex);
  std::erase(living().paths, folder);
  if (living().paths.empty())
    SetConsoleCtrlHandler(remove_folders, FALSE);
}

} // namespace bem_contact::system
