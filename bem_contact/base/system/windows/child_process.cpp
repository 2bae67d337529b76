#include "bem_contact/base/child_process.hpp"

#include "bem_contact/base/error.hpp"

#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <io.h>
#include <process.h>
#include <windows.h>

namespace bem_contact {

namespace {

/// A process starts with one line, in which a word with spaces is quoted; within quotes, backslashes before a
/// quote are doubled.
std::wstring quoted(const std::wstring& word) {
  if (!word.empty() && word.find_first_of(L" \t\"") == word.npos)
    return word;
  std::wstring out = L"\"";
  std::size_t slashes = 0;
  for (const wchar_t c : word) {
    if (c == L'"')
      out.append(slashes + 1, L'\\');
    slashes = c == L'\\' ? slashes + 1 : 0;
    out += c;
  }
  return out.append(slashes, L'\\') + L'"';
}

/// Starts it and waits. -1: it could not be started, and errno says why.
std::intptr_t run(const std::vector<std::string>& words) {
  std::vector<std::wstring> wide;
  for (const std::string& word : words)
    wide.push_back(std::filesystem::path(word).native());
  std::vector<std::wstring> line;
  for (const std::wstring& word : wide)
    line.push_back(quoted(word));
  std::vector<const wchar_t*> pointers;
  for (const std::wstring& word : line)
    pointers.push_back(word.c_str());
  pointers.push_back(nullptr);
  return _wspawnvp(_P_WAIT, wide.front().c_str(), pointers.data());
}

} // namespace

/// There is no copy of a process, which could go on with `work`.
ChildProcess::ChildProcess(const std::filesystem::path&, const std::function<int()>&) {
  throw InputError("This is not there on Windows", "it needs child processes of a kind that Windows lacks",
                   "Use it on Linux, or in WSL2.");
}

ChildProcess::~ChildProcess() = default;

std::optional<std::string> ChildProcess::next_line(const std::atomic<bool>*, const std::function<void()>&) {
  return std::nullopt;
}

int ChildProcess::wait(std::string&) {
  return -1;
}

ProgramLine::ProgramLine(std::vector<std::string> words) : words_(std::move(words)) {}

/// The other program runs, and this process ends with it.
void ProgramLine::become() const {
  if (const std::intptr_t code = run(words_); code != -1)
    std::_Exit(static_cast<int>(code));
}

bool run_and_wait(const std::vector<std::string>& words, std::string& why) {
  const int output = _dup(1);
  _dup2(2, 1); // what it prints goes to standard error
  const std::intptr_t code = run(words);
  why = code == -1 ? std::strerror(errno) : "";
  _dup2(output, 1);
  _close(output);
  return code == 0;
}

void set_variable(const char* name, const std::filesystem::path& value) {
  _wputenv_s(std::filesystem::path(name).c_str(), value.c_str());
}

std::filesystem::path this_program() {
  std::array<wchar_t, 32768> name{};
  const DWORD size = GetModuleFileNameW(nullptr, name.data(), static_cast<DWORD>(name.size()));
  return std::wstring(name.data(), size);
}

std::filesystem::path program_named(std::string_view name) {
  const std::filesystem::path file = this_program().parent_path() / (std::string(name) + ".exe");
  std::error_code unknown;
  return std::filesystem::is_regular_file(file, unknown) ? file : std::filesystem::path();
}

} // namespace bem_contact
