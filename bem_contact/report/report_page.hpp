#pragma once

#include <filesystem>

namespace bem_contact::report {

/// Reads a file that bem_contact wrote (a result, a comparison, a sweep, creep curves, conicity, a wheelset
/// or wear) and writes its page to `output`, whole or not at all: HTML that needs no other file and no
/// network. Throws InputError for any other file, where `output` is `file` or cannot be written, and if this
/// build has no plotting library.
void write_report(const std::filesystem::path& file, const std::filesystem::path& output);

} // namespace bem_contact::report
