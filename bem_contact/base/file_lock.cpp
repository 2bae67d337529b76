#include "bem_contact/base/file_lock.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/base/system/files.hpp"

#include <cerrno>
#include <chrono>
#include <cstring>
#include <fmt/format.h>
#include <thread>
#include <utility>

namespace bem_contact {

namespace {

/// How long a lock is waited for: processes that a killed run has started end within this, and hold it till
/// then.
constexpr std::chrono::milliseconds longest_wait{1000};
constexpr std::chrono::milliseconds between_tries{20};

/// A lock of ours is empty. It is removed at the end, and so must not be the file of somebody else.
void require_empty(int handle, const std::filesystem::path& file) {
  if (!system::is_empty_file(handle))
    throw InputError(fmt::format("The file '{}' is no lock", file.string()),
                     "a lock is an empty file, and this one would be removed", "Give it another name.");
}

} // namespace

std::string lock_file(int handle, const std::filesystem::path& file, std::string_view if_in_use) {
  const auto until = std::chrono::steady_clock::now() + longest_wait;
  system::Locked locked = system::lock(handle);
  while (locked == system::Locked::elsewhere && std::chrono::steady_clock::now() < until) {
    std::this_thread::sleep_for(between_tries);
    locked = system::lock(handle);
  }
  if (locked == system::Locked::here)
    return "";
  if (locked == system::Locked::elsewhere)
    throw InputError(fmt::format("The file '{}' is in use", file.string()), "another process writes it",
                     std::string(if_in_use));
  return fmt::format("'{}' cannot be locked ({}; not every file system has locks), so a second run that "
                     "writes the same files would not be noticed: do not start one",
                     file.string(), std::strerror(errno));
}

LockFile::LockFile(std::filesystem::path file, std::string_view if_in_use) : file_(std::move(file)) {
  do {
    if (handle_ >= 0)
      system::close_file(handle_);
    handle_ = system::open_file(file_, system::OpenFor::locking);
    if (handle_ < 0)
      throw InputError(fmt::format("The file '{}' cannot be made", file_.string()), std::strerror(errno),
                       "Give a folder in which you may write.");
    try {
      require_empty(handle_, file_);
      warning_ = lock_file(handle_, file_, if_in_use);
    } catch (...) {
      system::close_file(handle_);
      throw;
    }
  } while (!system::is_named(handle_, file_));
}

LockFile::~LockFile() {
  system::remove_locked(handle_, file_);
}

} // namespace bem_contact
