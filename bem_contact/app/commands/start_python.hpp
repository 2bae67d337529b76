#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace bem_contact::app {

/// The Python of Debian, for which the package bem_contact is built.
inline constexpr const char* system_python = "/usr/bin/python3";

/// This process becomes `python -m module arguments`, so that what the module prints and its exit code are
/// the program's. Python finds the package bem_contact of this program's build or installed tree, and the
/// package finds this program. Returns only by an exception: InputError if `python` or the package is
/// missing.
[[noreturn]] void become_python(const std::filesystem::path& python, const std::string& module,
                                const std::vector<std::string>& arguments);

} // namespace bem_contact::app
