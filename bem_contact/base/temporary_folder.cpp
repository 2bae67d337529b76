#include "bem_contact/base/temporary_folder.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/base/system/temporary.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <fstream>
#include <system_error>

namespace bem_contact {

TemporaryFolder::TemporaryFolder() {
  std::error_code problem;
  path_ = system::new_temporary_folder(problem);
  if (problem)
    throw Error("No temporary folder can be made", problem.message(),
                "Set TMPDIR to a folder that you may write to.");
  system::remove_at_signals(path_);
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
  system::keep_at_signals(path_);
}

std::filesystem::path TemporaryFolder::write(const std::filesystem::path& name,
                                             const std::string& text) const {
  if (name.is_absolute() || std::ranges::find(name, "..") != name.end())
    throw InputError(fmt::format("'{}' cannot be the name of a copy", name.string()),
                     "it leads out of the folder of the copies", "Copy the file that names it again.");
  constexpr std::size_t longest_name = 255; // NAME_MAX
  if (std::ranges::any_of(name, [&](const auto& part) { return part.string().size() > longest_name; }))
    throw InputError(fmt::format("'{}' cannot be the name of a copy", name.string()), "it is too long",
                     "Copy the file that names it again.");
  std::filesystem::path file = path_ / name;
  std::error_code problem;
  std::filesystem::create_directories(file.parent_path(), problem);
  std::ofstream out(file, std::ios::binary);
  out << text;
  out.close();
  if (!out)
    throw Error(fmt::format("The file '{}' cannot be written", file.string()),
                problem ? problem.message() : "the disk may be full",
                "Make room, or set TMPDIR to another folder.");
  return file;
}

} // namespace bem_contact
