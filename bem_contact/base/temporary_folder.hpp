#pragma once

#include <filesystem>
#include <string>

namespace bem_contact {

/// A new folder that is gone when its object is, and when Ctrl-C, SIGTERM or SIGHUP ends the program.
class TemporaryFolder {
public:
  /// Throws Error where none can be made.
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }
  std::filesystem::path operator/(const std::filesystem::path& name) const { return path_ / name; }
  /// Writes a file of that name, which may hold folders, and returns its path. Throws InputError for a name
  /// that leads out of the folder, Error where it cannot write.
  std::filesystem::path write(const std::filesystem::path& name, const std::string& text) const;

private:
  std::filesystem::path path_;
};

} // namespace bem_contact
