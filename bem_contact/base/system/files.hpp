#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// What the library of C++ lacks of files, and each system does in its own way. Functions that can fail
/// return false or -1, and `errno` says why.
namespace bem_contact::system {

enum class OpenFor {
  reading,
  changing,  ///< and writing at its end; it is made where there is none
  appending, ///< it must be there, and be no link
  locking    ///< it is made where there is none, and must be no link
};

/// The number of the open file, which no child inherits.
int open_file(const std::filesystem::path& file, OpenFor what);
void close_file(int file);

bool write_all(int file, std::string_view bytes);
/// What comes next is written at the new end.
bool set_size(int file, std::uint64_t bytes);
bool read_begin(int file, std::span<char> bytes);
/// Takes room on the disk.
bool reserve(int file, std::uint64_t from, std::uint64_t bytes);
/// Waits until the file is on its disk. True where a file system cannot be asked.
bool put_on_disk(const std::filesystem::path& file);

enum class Locked { here, elsewhere, nowhere };
/// For this process until it is closed. `nowhere`: this file system has no locks.
Locked lock(int file);
/// Whether it is a regular file of no bytes.
bool is_empty_file(int file);
/// Whether the name still leads to the open file.
bool is_named(int file, const std::filesystem::path& name);
/// Closes a file that is locked, and removes it in such an order that nobody's new file is removed.
void remove_locked(int file, const std::filesystem::path& name);

/// Whether the name leads to where standard output or standard error goes.
bool is_standard_output(const std::filesystem::path& name);
bool is_standard_error(const std::filesystem::path& name);
bool standard_error_is_terminal();
/// Names such as /proc/self/fd/1 stand for something open, which has no other name.
bool stands_for_something_open(const std::filesystem::path& link);

bool may_write(const std::filesystem::path& file);
bool may_write_into(const std::filesystem::path& folder);
/// Windows: another program has the file open so that it cannot be written, as those for tables do.
bool is_held_elsewhere(const std::filesystem::path& file);

/// The files of a pattern as FOLDER/*.whl, sorted.
std::vector<std::string> files_like(const std::string& pattern);

int this_process();
bool is_running(int process);

} // namespace bem_contact::system
