#include "bem_contact/base/system/temporary.hpp"

#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <fcntl.h>
#include <string>
#include <unistd.h>

#ifdef __linux__
#include <sys/syscall.h>
#endif

namespace bem_contact::system {

std::filesystem::path new_temporary_folder(std::error_code& problem) {
  std::string name = (std::filesystem::temp_directory_path(problem) / "bem_contact_XXXXXX").string();
  if (!problem && mkdtemp(name.data()) == nullptr)
    problem.assign(errno, std::generic_category());
  return name;
}

#ifdef SYS_getdents64

namespace {

// A signal that ends the program runs no destructor, and its handler may hardly call anything: it finds the
// paths here. Handlers are the process's own, so that this is too.
struct LivingFolder {
  std::atomic<const char*> path = nullptr;
  pid_t owner = 0; ///< not a child that was forked
};
std::array<LivingFolder, 16> living; ///< of more than these the later ones stay behind

/// As the kernel gives it (man 2 getdents).
struct FolderEntry {
  std::uint64_t inode;
  std::int64_t offset;
  unsigned short size;
  unsigned char kind;
  char name[1];
};

/// Removes what is in an open folder; by system calls alone, since a handler may not allocate.
void empty_folder(int folder, int depth) {
  constexpr int deepest = 8; // OpenMPI makes five
  alignas(FolderEntry) char bytes[2048];
  for (long read = 0; depth < deepest && (read = syscall(SYS_getdents64, folder, bytes, sizeof bytes)) > 0;)
    for (long at = 0; at < read;) {
      const auto& entry = *reinterpret_cast<const FolderEntry*>(bytes + at);
      at += entry.size;
      const char* name = entry.name;
      if (std::strcmp(name, ".") == 0 || std::strcmp(name, "..") == 0 || unlinkat(folder, name, 0) == 0)
        continue;
      if (const int inner = openat(folder, name, O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
          inner >= 0) {
        empty_folder(inner, depth + 1);
        close(inner);
        unlinkat(folder, name, AT_REMOVEDIR);
      }
    }
}

/// A child may make a file meanwhile, so that one try is not enough.
void remove_folder(const char* path) {
  constexpr int tries = 100;
  for (int k = 0; k < tries; ++k) {
    if (const int folder = open(path, O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC); folder >= 0) {
      empty_folder(folder, 0);
      close(folder);
    }
    if (rmdir(path) == 0 || errno == ENOENT)
      return;
    constexpr timespec millisecond{.tv_sec = 0, .tv_nsec = 1'000'000};
    nanosleep(&millisecond, nullptr);
  }
}

extern "C" void remove_folders_and_end(int signal) {
  const pid_t self = getpid();
  for (LivingFolder& folder : living)
    if (const char* path = folder.path; path && folder.owner == self)
      remove_folder(path);
  raise(signal); // its handler is the default again (SA_RESETHAND); it acts when this one returns
}

/// A host such as Python keeps its own handlers, and a signal that is ignored stays so.
void clean_up_at_signals() {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    struct sigaction now {};
    if (sigaction(signal, nullptr, &now) != 0 || (now.sa_flags & SA_SIGINFO) != 0 ||
        now.sa_handler != SIG_DFL)
      continue;
    struct sigaction action {};
    action.sa_handler = remove_folders_and_end;
    action.sa_flags = static_cast<int>(SA_RESETHAND);
    sigemptyset(&action.sa_mask);
    sigaction(signal, &action, nullptr);
  }
}

} // namespace

void remove_at_signals(const std::filesystem::path& path) {
  clean_up_at_signals();
  for (LivingFolder& folder : living)
    if (const char* none = nullptr; folder.path.compare_exchange_strong(none, path.c_str())) {
      folder.owner = getpid();
      return;
    }
}

void keep_at_signals(const std::filesystem::path& path) {
  for (LivingFolder& folder : living)
    if (folder.path == path.c_str())
      folder.path = nullptr;
}

#else
void remove_at_signals(const std::filesystem::path&) {}
void keep_at_signals(const std::filesystem::path&) {}
#endif

} // namespace bem_contact::system
