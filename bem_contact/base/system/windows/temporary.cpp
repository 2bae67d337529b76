#include "bem_contact/base/system/temporary.hpp"

#include <random>
#include <string>

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

/// There is no such signal.
void remove_at_signals(const std::filesystem::path&) {}
void keep_at_signals(const std::filesystem::path&) {}

} // namespace bem_contact::system
