#pragma once

#include <string>
#include <vector>
#include <windows.h>

namespace bem_contact::system {

/// What the system says of the last failure.
std::string last_error();

/// A program starts with one line, in which a word with spaces is quoted; within quotes, backslashes before a
/// quote are doubled.
std::wstring line_of(const std::vector<std::string>& words);

/// Starts a program with our standard streams, its output to `output`, and waits. False: it could not be
/// started.
bool run(const std::vector<std::string>& words, HANDLE output, DWORD& code);

} // namespace bem_contact::system
