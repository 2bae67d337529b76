#include "bem_contact/app/commands/start_python.hpp"

#include "bem_contact/base/child_process.hpp"
#include "bem_contact/base/error.hpp"
#include "bem_contact/base/input_file.hpp"
#include "bem_contact/base/program.hpp"

#include <cstdio>
#include <cstdlib>
#include <fmt/format.h>

namespace bem_contact::app {

namespace {

namespace fs = std::filesystem;

/// Beside the program's folder in a build, in an installed tree, and around it in what pip installs.
fs::path folder_of_package(const fs::path& bin) {
  for (const fs::path& folder : {bin / "../python", bin / ".." / CONFORMAL_PYTHON_DIR, bin / "../.."})
    if (std::error_code unknown; fs::is_directory(folder / "bem_contact/plotting", unknown))
      return folder.lexically_normal();
  throw InputError(
      "The Python package bem_contact was not found",
      fmt::format("it is neither beside '{}' nor where it is installed", bin.string()),
      "Call bem_contact report, which draws result files on a page and needs no Python, or install "
      "the Debian package conformal-contact, or build the target bem_contact_python.");
}

void put_first(const char* variable, const fs::path& folder) {
  const char* others = std::getenv(variable);
  const std::string all = others && *others ? fmt::format("{}:{}", folder.string(), others) : folder.string();
  set_variable(variable, all);
}

} // namespace

void become_python(const fs::path& python, const std::string& module,
                   const std::vector<std::string>& arguments) {
  if (!file_exists(python))
    throw InputError("No picture can be drawn", fmt::format("there is no '{}'", python.string()),
                     "Call bem_contact report, which draws result files on a page and needs no Python, or on "
                     "Debian: sudo apt-get install python3 python3-h5py python3-matplotlib");
  const fs::path bin = this_program().parent_path();
  put_first("PYTHONPATH", folder_of_package(bin));
  set_variable("CONFORMAL_BIN", bin);
  std::vector<std::string> words{python.string(), "-m", module};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::fflush(nullptr);
  become_program(words);
  throw Error("Python cannot be started", fmt::format("'{}' is no program that runs here", python.string()),
              "Install the Debian package python3 again.");
}

} // namespace bem_contact::app
