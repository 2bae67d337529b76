#include "bem_contact/base/temporary_folder.hpp"

#include "bem_contact/base/error.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <fmt/format.h>
#include <fstream>
#include <system_error>

namespace bem_contact {

TemporaryFolder::TemporaryFolder() {
  std::error_code problem;
  std::string name = (std::filesystem::temp_directory_path(problem) / "bem_contact_XXXXXX").string();
  if (!problem && mkdtemp(name.data()) == nullptr)
    problem.assign(errno, std::generic_category());
  if (problem)
    throw Error("No temporary folder can be made", problem.message(),
                "Set TMPDIR to a folder that you may write to.");
  path_ = name;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

std::filesystem::path TemporaryFolder::write(const std::filesystem::path& name,
                                             const std::string& text) const {
  if (name.is_absolute() || std::ranges::find(name, "..") != name.end())
    throw InputError(fmt::format("'{}' cannot be the name of a copy", name.string()),
                     "it leads out of the folder of the copies", "Copy the file that names it again.");
  std::filesystem::path file = path_ / name;
  std::filesystem::create_directories(file.parent_path());
  std::ofstream out(file, std::ios::binary);
  out << text;
  out.close();
  if (!out)
    throw Error(fmt::format("The file '{}' cannot be written", file.string()), "the disk may be full",
                "Make room, or set TMPDIR to another folder.");
  return file;
}

} // namespace bem_contact
