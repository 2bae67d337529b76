#include "bem_contact/base/output_file.hpp"

#include "bem_contact/base/error.hpp"

#include <system_error>

namespace bem_contact {

namespace {

bool same_file(const std::filesystem::path& a, const std::filesystem::path& b) {
  std::error_code ignored;
  return std::filesystem::equivalent(a, b, ignored) ||
         std::filesystem::weakly_canonical(a, ignored) == std::filesystem::weakly_canonical(b, ignored);
}

} // namespace

void refuse_overwriting(const std::filesystem::path& output, std::span<const std::filesystem::path> taken) {
  for (const std::filesystem::path& file : taken)
    if (!output.empty() && !file.empty() && same_file(output, file))
      throw InputError("The output '" + output.string() + "' would overwrite '" + file.string() + "'",
                       "it is an input or another output of this run", "Give the output another name.");
}

} // namespace bem_contact
