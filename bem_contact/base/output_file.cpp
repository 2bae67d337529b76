#include "bem_contact/base/output_file.hpp"

#include "bem_contact/base/error.hpp"

#include <unistd.h>

#include <fstream>
#include <string>
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

void write_whole(const std::filesystem::path& file, const std::function<void(std::ostream&)>& write) {
  std::filesystem::path temporary = file;
  temporary += ".tmp" + std::to_string(getpid());
  std::error_code failed;
  std::ofstream out(temporary, std::ios::binary);
  const bool opened = static_cast<bool>(out);
  if (opened)
    write(out);
  out.close();
  const bool written = static_cast<bool>(out);
  if (written)
    std::filesystem::rename(temporary, file, failed);
  if (written && !failed)
    return;
  std::error_code ignored;
  std::filesystem::remove(temporary, ignored);
  throw InputError("The file '" + file.string() + "' cannot be written",
                   failed    ? failed.message()
                   : !opened ? "it cannot be created"
                             : "writing stopped early",
                   "Check that its folder exists, that you may write there, and that the disk is not full.");
}

} // namespace bem_contact
