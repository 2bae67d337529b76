#pragma once

#include <filesystem>
#include <system_error>
#include <utility>

namespace bem_contact {

/// The name of a file that is gone when this object is. Nothing is left to remove where it got another name.
struct TemporaryFile {
  std::filesystem::path name;

  explicit TemporaryFile(std::filesystem::path file) : name(std::move(file)) {}
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  ~TemporaryFile() {
    std::error_code ignored;
    std::filesystem::remove(name, ignored);
  }
};

} // namespace bem_contact
