#include "bem_contact/base/system/files.hpp"

#include <fcntl.h>
#include <io.h>
#include <process.h>
#include <share.h>
#include <sys/stat.h>
#include <windows.h>

#include <algorithm>
#include <cerrno>
#include <climits>
#include <cstdio>

namespace bem_contact::system {

namespace {

HANDLE handle_of(int file) {
  return reinterpret_cast<HANDLE>(_get_osfhandle(file));
}

/// Locks keep others from reading what they cover, so that this byte lies behind all others.
OVERLAPPED locked_byte() {
  OVERLAPPED at{};
  at.OffsetHigh = 0x7fffffff;
  return at;
}

bool same(HANDLE a, HANDLE b) {
  BY_HANDLE_FILE_INFORMATION one{}, other{};
  return GetFileInformationByHandle(a, &one) && GetFileInformationByHandle(b, &other) &&
         one.dwVolumeSerialNumber == other.dwVolumeSerialNumber &&
         one.nFileIndexHigh == other.nFileIndexHigh && one.nFileIndexLow == other.nFileIndexLow;
}

bool leads_to(const std::filesystem::path& name, HANDLE open) {
  const HANDLE named = CreateFileW(name.c_str(), 0, FILE_SHARE_READ | FILE_SHARE_WRITE | FILE_SHARE_DELETE,
                                   nullptr, OPEN_EXISTING, FILE_FLAG_BACKUP_SEMANTICS, nullptr);
  if (named == INVALID_HANDLE_VALUE)
    return false;
  const bool is = same(named, open);
  CloseHandle(named);
  return is;
}

} // namespace

int open_file(const std::filesystem::path& file, OpenFor what) {
  const int flags = what == OpenFor::reading     ? _O_RDONLY
                    : what == OpenFor::appending ? _O_WRONLY | _O_APPEND
                                                 : _O_RDWR | _O_CREAT;
  return _wsopen(file.c_str(), flags | _O_BINARY | _O_NOINHERIT, _SH_DENYNO, _S_IREAD | _S_IWRITE);
}

void close_file(int file) {
  _close(file);
}

bool write_all(int file, std::string_view bytes) {
  while (!bytes.empty()) {
    const int n =
        _write(file, bytes.data(), static_cast<unsigned>(std::min<std::size_t>(bytes.size(), INT_MAX)));
    if (n <= 0)
      return false;
    bytes.remove_prefix(static_cast<std::size_t>(n));
  }
  return true;
}

bool set_size(int file, std::uint64_t bytes) {
  const int failed = _chsize_s(file, static_cast<long long>(bytes));
  if (failed != 0)
    errno = failed;
  return failed == 0 && _lseeki64(file, 0, SEEK_END) >= 0;
}

bool read_begin(int file, std::span<char> bytes) {
  return _lseeki64(file, 0, SEEK_SET) == 0 &&
         _read(file, bytes.data(), static_cast<unsigned>(bytes.size())) == static_cast<int>(bytes.size());
}

bool reserve(int file, std::uint64_t from, std::uint64_t bytes) {
  const auto wanted = static_cast<long long>(from + bytes);
  const int failed = _filelengthi64(file) >= wanted ? 0 : _chsize_s(file, wanted);
  if (failed != 0)
    errno = failed;
  return failed == 0;
}

bool put_on_disk(const std::filesystem::path& file) {
  const int open = open_file(file, OpenFor::changing);
  if (open < 0)
    return true;
  const bool done = _commit(open) == 0;
  const int why = errno;
  _close(open);
  errno = why;
  return done;
}

Locked lock(int file) {
  OVERLAPPED at = locked_byte();
  if (LockFileEx(handle_of(file), LOCKFILE_EXCLUSIVE_LOCK | LOCKFILE_FAIL_IMMEDIATELY, 0, 1, 0, &at))
    return Locked::here;
  const DWORD why = GetLastError();
  errno = EACCES;
  return why == ERROR_LOCK_VIOLATION || why == ERROR_IO_PENDING ? Locked::elsewhere : Locked::nowhere;
}

bool is_empty_file(int file) {
  return GetFileType(handle_of(file)) == FILE_TYPE_DISK && _filelengthi64(file) == 0;
}

bool is_named(int file, const std::filesystem::path& name) {
  return leads_to(name, handle_of(file));
}

void remove_locked(int file, const std::filesystem::path& name) {
  _close(file); // an open file cannot be removed; where another process has opened it by now, it stays
  std::error_code ignored;
  std::filesystem::remove(name, ignored);
}

bool is_standard_output(const std::filesystem::path& name) {
  return leads_to(name, GetStdHandle(STD_OUTPUT_HANDLE));
}

bool is_standard_error(const std::filesystem::path& name) {
  return leads_to(name, GetStdHandle(STD_ERROR_HANDLE));
}

bool standard_error_is_terminal() {
  DWORD mode = 0;
  return GetConsoleMode(GetStdHandle(STD_ERROR_HANDLE), &mode) != 0;
}

bool stands_for_something_open(const std::filesystem::path&) {
  return false;
}

bool may_write(const std::filesystem::path& file) {
  return _waccess(file.c_str(), 2) == 0;
}

bool may_write_into(const std::filesystem::path& folder) {
  return _waccess(folder.c_str(), 0) == 0; // who may make files there, only the attempt tells
}

bool is_held_elsewhere(const std::filesystem::path& file) {
  const HANDLE open =
      CreateFileW(file.c_str(), GENERIC_WRITE, FILE_SHARE_READ | FILE_SHARE_WRITE | FILE_SHARE_DELETE,
                  nullptr, OPEN_EXISTING, FILE_ATTRIBUTE_NORMAL, nullptr);
  if (open == INVALID_HANDLE_VALUE)
    return GetLastError() == ERROR_SHARING_VIOLATION;
  CloseHandle(open);
  return false;
}

/// Of the last name alone; `*` and `?` are all that this system knows.
std::vector<std::string> files_like(const std::string& pattern) {
  const std::filesystem::path given = pattern;
  std::vector<std::string> out;
  WIN32_FIND_DATAW found{};
  const HANDLE search = FindFirstFileW(given.c_str(), &found);
  if (search == INVALID_HANDLE_VALUE)
    return out;
  do
    if (std::wstring_view(found.cFileName) != L"." && std::wstring_view(found.cFileName) != L"..")
      out.push_back((given.parent_path() / found.cFileName).string());
  while (FindNextFileW(search, &found));
  FindClose(search);
  std::ranges::sort(out);
  return out;
}

int this_process() {
  return _getpid();
}

bool is_running(int process) {
  const HANDLE open = OpenProcess(PROCESS_QUERY_LIMITED_INFORMATION, FALSE, static_cast<DWORD>(process));
  DWORD code = 0;
  const bool running = open && GetExitCodeProcess(open, &code) && code == STILL_ACTIVE;
  if (open)
    CloseHandle(open);
  return running || (!open && GetLastError() != ERROR_INVALID_PARAMETER);
}

} // namespace bem_contact::system
