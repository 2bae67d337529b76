#include "bem_contact/base/child_process.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/base/system/windows/handle.hpp"
#include "bem_contact/base/system/windows/start_program.hpp"

#include <array>
#include <cstdlib>
#include <cwchar>
#include <fmt/format.h>
#include <map>
#include <utility>
#include <windows.h>

namespace bem_contact {

namespace {

namespace fs = std::filesystem;
using system::Handle;

/// Names of variables have no case there. The block ends with an empty text.
std::wstring environment_with(const ChildWork& work) {
  std::map<std::wstring, std::wstring> lines;
  const auto add = [&](std::wstring_view line) {
    std::wstring name(line.substr(0, line.find(L'=', 1)));
    for (wchar_t& letter : name)
      letter = static_cast<wchar_t>(std::towupper(letter));
    lines[name] = line;
  };
  wchar_t* all = GetEnvironmentStringsW();
  for (const wchar_t* line = all; line && *line; line += std::wcslen(line) + 1)
    add(line);
  FreeEnvironmentStringsW(all);
  for (const auto& [name, value] : work.variables)
    add(fs::path(name + "=" + value).native());
  std::wstring out;
  for (const auto& [name, line] : lines)
    out += line + L'\0';
  return out + L'\0';
}

/// Standard streams of a child, which alone it inherits.
struct Streams {
  Handle input, output, errors, messages; ///< `messages`: what is read of `errors`

  explicit Streams(const fs::path& text) {
    SECURITY_ATTRIBUTES inherited{sizeof inherited, nullptr, TRUE};
    HANDLE from = nullptr, to = nullptr;
    input.take(CreateFileW(L"NUL", GENERIC_READ, FILE_SHARE_READ | FILE_SHARE_WRITE, &inherited,
                           OPEN_EXISTING, 0, nullptr));
    output.take(
        CreateFileW(text.c_str(), GENERIC_WRITE, FILE_SHARE_READ, &inherited, CREATE_ALWAYS, 0, nullptr));
    if (output.get() == INVALID_HANDLE_VALUE || !CreatePipe(&from, &to, &inherited, 0))
      throw Error("No other process can be started", system::last_error(), "Look at the folder's rights.");
    messages.take(from);
    errors.take(to);
    SetHandleInformation(from, HANDLE_FLAG_INHERIT, 0);
  }
};

/// Whoever is in it ends when it is closed, also by the end of this process.
HANDLE new_job() {
  HANDLE job = CreateJobObjectW(nullptr, nullptr);
  JOBOBJECT_EXTENDED_LIMIT_INFORMATION limits{};
  limits.BasicLimitInformation.LimitFlags = JOB_OBJECT_LIMIT_KILL_ON_JOB_CLOSE;
  SetInformationJobObject(job, JobObjectExtendedLimitInformation, &limits, sizeof limits);
  return job;
}

} // namespace

struct ChildProcess::Started {
  Handle process, job, messages;
  std::string why_not;
};

ChildProcess::ChildProcess(const fs::path& text, const ChildWork& work)
    : started_(std::make_unique<Started>()) {
  std::fflush(stdout);
  Streams streams(text);
  std::wstring line = system::line_of(work.words), environment = environment_with(work);
  STARTUPINFOW how{};
  how.cb = sizeof how;
  how.dwFlags = STARTF_USESTDHANDLES;
  how.hStdInput = streams.input.get();
  how.hStdOutput = streams.output.get();
  how.hStdError = streams.errors.get();
  PROCESS_INFORMATION made{};
  started_->job.take(new_job());
  if (!CreateProcessW(nullptr, line.data(), nullptr, nullptr, TRUE,
                      CREATE_SUSPENDED | CREATE_UNICODE_ENVIRONMENT, environment.data(), nullptr, &how,
                      &made)) {
    started_->why_not = system::last_error();
    return;
  }
  started_->process.take(made.hProcess);
  const Handle thread(made.hThread);
  AssignProcessToJobObject(started_->job.get(), made.hProcess);
  ResumeThread(thread.get());
  started_->messages.take(streams.messages.release());
}

ChildProcess::~ChildProcess() {
  if (started_->process.get()) {
    TerminateJobObject(started_->job.get(), 1);
    WaitForSingleObject(started_->process.get(), INFINITE);
  }
}

const std::string& ChildProcess::why_not_started() const {
  return started_->why_not;
}

/// Nobody can wait for such a pipe, so that it is looked into now and then.
ChildProcess::Read ChildProcess::read_more(int patience) {
  constexpr int pause = 10; // ms
  const HANDLE from = started_->messages.get();
  DWORD there = 0, count = 0;
  for (int waited = 0; patience >= 0; waited += pause) {
    if (!PeekNamedPipe(from, nullptr, 0, nullptr, &there, nullptr))
      return Read::end;
    if (there > 0)
      break;
    if (waited >= patience)
      return Read::nothing_yet;
    Sleep(pause);
  }
  std::array<char, 4096> bytes{};
  if (!ReadFile(from, bytes.data(), static_cast<DWORD>(bytes.size()), &count, nullptr) || count == 0)
    return Read::end;
  rest_.append(bytes.data(), count);
  return Read::bytes;
}

int ChildProcess::wait(std::string& how) {
  if (!started_->process.get()) {
    how = "it cannot be started: " + started_->why_not;
    return -1;
  }
  DWORD code = 0;
  WaitForSingleObject(started_->process.get(), INFINITE);
  GetExitCodeProcess(started_->process.get(), &code);
  started_->process.close();
  constexpr DWORD of_systems = 0xC0000000; // a fault that ends a process, such as 0xC0000005
  if (code < of_systems)
    return static_cast<int>(code);
  how = fmt::format("the system's code {:#x}", code);
  return -1;
}

void become_program(const std::vector<std::string>& words) {
  DWORD code = 0;
  if (system::run(words, GetStdHandle(STD_OUTPUT_HANDLE), code))
    std::_Exit(static_cast<int>(code));
}

bool run_and_wait(const std::vector<std::string>& words, std::string& why) {
  DWORD code = 0;
  const bool started = system::run(words, GetStdHandle(STD_ERROR_HANDLE), code);
  why = started ? "" : system::last_error();
  return started && code == 0;
}

void set_variable(const char* name, const fs::path& value) {
  _wputenv_s(fs::path(name).c_str(), value.c_str());
}

fs::path this_program() {
  std::array<wchar_t, 32768> name{};
  const DWORD size = GetModuleFileNameW(nullptr, name.data(), static_cast<DWORD>(name.size()));
  return std::wstring(name.data(), size);
}

fs::path program_named(std::string_view name) {
  const std::wstring file = fs::path(std::string(name) + ".exe").native();
  const wchar_t* bin = _wgetenv(L"CONFORMAL_BIN");
  const wchar_t* path = _wgetenv(L"PATH");
  std::wstring folders = std::wstring(bin ? bin : L"") + L";" + this_program().parent_path().native() + L";" +
                         (path ? path : L"");
  std::array<wchar_t, 32768> found{};
  const DWORD size = SearchPathW(folders.c_str(), file.c_str(), nullptr, static_cast<DWORD>(found.size()),
                                 found.data(), nullptr);
  return size > 0 && size < found.size() ? fs::path(std::wstring(found.data(), size)) : fs::path();
}

} // namespace bem_contact
