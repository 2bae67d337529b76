#include "bem_contact/base/file_lock.hpp"

#include "bem_contact/base/error.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

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

/// Whether the name still leads to the open file: who held the lock before may have removed it.
bool is_named(int handle, const std::filesystem::path& file) {
  struct stat open {
  }, named{};
  return fstat(handle, &open) == 0 && stat(file.c_str(), &named) == 0 && open.st_dev == named.st_dev &&
         open.st_ino == named.st_ino;
}

/// A lock of ours is empty. It is removed at the end, and so must not be the file of somebody else.
void require_empty(int handle, const std::filesystem::path& file) {
  struct stat open {};
  if (fstat(handle, &open) != 0 || !S_ISREG(open.st_mode) || open.st_size > 0)
    throw InputError(fmt::format("The file '{}' is no lock", file.string()),
                     "a lock is an empty file, and this one would be removed", "Give it another name.");
}

} // namespace

std::string lock_file(int handle, const std::filesystem::path& file, std::string_view if_in_use) {
  const auto until = std::chrono::steady_clock::now() + longest_wait;
  int locked = flock(handle, LOCK_EX | LOCK_NB);
  while (locked != 0 && errno == EWOULDBLOCK && std::chrono::steady_clock::now() < until) {
    std::this_thread::sleep_for(between_tries);
    locked = flock(handle, LOCK_EX | LOCK_NB);
  }
  if (locked == 0)
    return "";
  if (errno == EWOULDBLOCK)
    throw InputError(fmt::format("The file '{}' is in use", file.string()), "another process writes it",
                     std::string(if_in_use));
  return fmt::format("'{}' cannot be locked ({}; not every file system has locks), so a second run that "
                     "writes the same files would not be noticed: do not start one",
                     file.string(), std::strerror(errno));
}

LockFile::LockFile(std::filesystem::path file, std::string_view if_in_use) : file_(std::move(file)) {
  do {
    if (handle_ >= 0)
      close(handle_);
    handle_ = open(file_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK, 0666);
    if (handle_ < 0)
      throw InputError(fmt::format("The file '{}' cannot be made", file_.string()), std::strerror(errno),
                       "Give a folder in which you may write.");
    try {
      require_empty(handle_, file_);
      warning_ = lock_file(handle_, file_, if_in_use);
    } catch (...) {
      close(handle_);
      throw;
    }
  } while (!is_named(handle_, file_));
}

LockFile::~LockFile() {
  std::error_code ignored;
  std::filesystem::remove(file_, ignored); // before it is unlocked, so that nobody's new file is removed
  close(handle_);
}

} // namespace bem_contact
