#include "bem_contact/base/system/files.hpp"

#include <fcntl.h>
#include <glob.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/vfs.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>

namespace bem_contact::system {

namespace {

constexpr auto proc_file_system = 0x9fa0; // PROC_SUPER_MAGIC of linux/magic.h

bool same(const struct stat& a, const struct stat& b) {
  return a.st_dev == b.st_dev && a.st_ino == b.st_ino;
}

} // namespace

int open_file(const std::filesystem::path& file, OpenFor what) {
  switch (what) {
  case OpenFor::reading:
    return open(file.c_str(), O_RDONLY | O_CLOEXEC);
  case OpenFor::changing:
    return open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
  case OpenFor::appending:
    return open(file.c_str(), O_WRONLY | O_APPEND | O_NOFOLLOW | O_CLOEXEC);
  case OpenFor::locking:
    return open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK, 0666);
  }
  return -1;
}

void close_file(int file) {
  close(file);
}

bool write_all(int file, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t n = write(file, bytes.data(), bytes.size());
    if (n < 0 && errno == EINTR)
      continue;
    if (n <= 0)
      return false;
    bytes.remove_prefix(static_cast<std::size_t>(n));
  }
  return true;
}

bool set_size(int file, std::uint64_t bytes) {
  return ftruncate(file, static_cast<off_t>(bytes)) == 0 && lseek(file, 0, SEEK_END) >= 0;
}

bool read_begin(int file, std::span<char> bytes) {
  return pread(file, bytes.data(), bytes.size(), 0) == static_cast<ssize_t>(bytes.size());
}

bool reserve(int file, std::uint64_t from, std::uint64_t bytes) {
  const int failed = posix_fallocate(file, static_cast<off_t>(from), static_cast<off_t>(bytes));
  if (failed != 0)
    errno = failed;
  return failed == 0;
}

bool put_on_disk(const std::filesystem::path& file) {
  const int open = open_file(file, OpenFor::reading);
  if (open < 0)
    return true;
  const bool failed = fsync(open) != 0 && errno != EINVAL && errno != ENOSYS;
  const int why = errno;
  close(open);
  errno = why;
  return !failed;
}

Locked lock(int file) {
  if (flock(file, LOCK_EX | LOCK_NB) == 0)
    return Locked::here;
  return errno == EWOULDBLOCK ? Locked::elsewhere : Locked::nowhere;
}

bool is_empty_file(int file) {
  struct stat open {};
  return fstat(file, &open) == 0 && S_ISREG(open.st_mode) && open.st_size == 0;
}

bool is_named(int file, const std::filesystem::path& name) {
  struct stat open {
  }, named{};
  return fstat(file, &open) == 0 && stat(name.c_str(), &named) == 0 && same(open, named);
}

void remove_locked(int file, const std::filesystem::path& name) {
  std::error_code ignored;
  std::filesystem::remove(name, ignored);
  close(file);
}

bool is_standard_output(const std::filesystem::path& name) {
  return is_named(STDOUT_FILENO, name);
}

bool is_standard_error(const std::filesystem::path& name) {
  return is_named(STDERR_FILENO, name);
}

bool standard_error_is_terminal() {
  return isatty(STDERR_FILENO) == 1;
}

bool stands_for_something_open(const std::filesystem::path& link) {
  const std::filesystem::path folder = link.has_parent_path() ? link.parent_path() : ".";
  struct statfs system {};
  return statfs(folder.c_str(), &system) == 0 && system.f_type == proc_file_system;
}

bool may_write(const std::filesystem::path& file) {
  return access(file.c_str(), W_OK) == 0;
}

bool may_write_into(const std::filesystem::path& folder) {
  return access(folder.c_str(), W_OK | X_OK) == 0;
}

bool is_held_elsewhere(const std::filesystem::path&) {
  return false;
}

std::vector<std::string> files_like(const std::string& pattern) {
  glob_t found = {};
  std::vector<std::string> out;
  if (glob(pattern.c_str(), 0, nullptr, &found) == 0)
    out.assign(found.gl_pathv, found.gl_pathv + found.gl_pathc);
  globfree(&found);
  return out;
}

int this_process() {
  return getpid();
}

bool is_running(int process) {
  return kill(process, 0) == 0 || errno != ESRCH;
}

} // namespace bem_contact::system
