#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace bem_contact {

/// Locks an open file for this process until it is closed. Throws InputError where another process has
/// locked it; `if_in_use`: what to do then. Returns a warning where the file system has no locks, as some of
/// clusters; else "".
std::string lock_file(int handle, const std::filesystem::path& file, std::string_view if_in_use);

/// A file that is there while a process writes several others. It is empty, and removed with the object. A
/// killed process leaves it behind, unlocked.
class LockFile {
public:
  /// Throws what lock_file() does, and InputError where the file cannot be made.
  LockFile(std::filesystem::path file, std::string_view if_in_use);
  ~LockFile();
  LockFile(const LockFile&) = delete;
  LockFile& operator=(const LockFile&) = delete;

  const std::string& warning() const { return warning_; } ///< of lock_file()

private:
  std::filesystem::path file_;
  int handle_ = -1;
  std::string warning_;
};

} // namespace bem_contact
