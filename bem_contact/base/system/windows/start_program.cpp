#include "bem_contact/base/system/windows/start_program.hpp"

#include <filesystem>
#include <system_error>

namespace bem_contact::system {

namespace {

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

} // namespace

std::string last_error() {
  std::string text = std::system_category().message(static_cast<int>(GetLastError()));
  while (!text.empty() && (text.back() == '\n' || text.back() == '\r' || text.back() == '.'))
    text.pop_back();
  return text;
}

std::wstring line_of(const std::vector<std::string>& words) {
  std::wstring out;
  for (const std::string& word : words)
    out += (out.empty() ? L"" : L" ") + quoted(std::filesystem::path(word).native());
  return out;
}

bool run(const std::vector<std::string>& words, HANDLE output, DWORD& code) {
  std::wstring line = line_of(words);
  STARTUPINFOW how{};
  how.cb = sizeof how;
  how.dwFlags = STARTF_USESTDHANDLES;
  how.hStdInput = GetStdHandle(STD_INPUT_HANDLE);
  how.hStdOutput = output;
  how.hStdError = GetStdHandle(STD_ERROR_HANDLE);
  PROCESS_INFORMATION made{};
  if (!CreateProcessW(nullptr, line.data(), nullptr, nullptr, TRUE, 0, nullptr, nullptr, &how, &made))
    return false;
  WaitForSingleObject(made.hProcess, INFINITE);
  GetExitCodeProcess(made.hProcess, &code);
  CloseHandle(made.hThread);
  CloseHandle(made.hProcess);
  return true;
}

} // namespace bem_contact::system
