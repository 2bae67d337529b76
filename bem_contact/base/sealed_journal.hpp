#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

namespace bem_contact {

/// What the journals of one program hold.
struct JournalKind {
  std::string_view magic;      ///< the first line, with its end
  std::string_view owner;      ///< "sweep": a journal may belong to another one
  std::string_view of_another; ///< why a journal of another digest is not continued
  std::string_view of_nobody;  ///< why a file with another first line is not
  std::string_view what_to_do; ///< in both cases
  std::string_view if_in_use;  ///< what to do while another process writes it
};

/// Gets the bytes of a record.
using RecordReader = std::function<void(std::string_view record)>;

/// A long run appends what it has finished to this file, as sealed records.
///
/// A kill at any moment loses nothing finished: the next run cuts off a record that is only half written.
/// Only one process writes a journal.
///     <magic><digest>\n
///     then [u64 bytes][record][SHA-256 of the record, 64 characters], in the machine's own byte order
class SealedJournal {
public:
  /// Makes the file, or continues it and calls `seen` with each complete record. `digest`: SHA-256 of all
  /// that the records depend on. Throws what write_whole() does (base/output_file.hpp), and InputError if the
  /// file is in use, or holds complete records of another digest or anything else: they are never thrown
  /// away.
  SealedJournal(const std::filesystem::path& file, const JournalKind& kind, const std::string& digest,
                const RecordReader& seen);
  ~SealedJournal();
  SealedJournal(const SealedJournal&) = delete;
  SealedJournal& operator=(const SealedJournal&) = delete;

  const std::filesystem::path& file() const { return file_; }
  const std::string& warning() const { return warning_; } ///< of lock_file(): nothing keeps others away
  void append(std::string_view record);
  /// When all is in another file.
  void remove();

private:
  void write(std::string_view bytes);

  std::filesystem::path file_;
  int handle_ = -1;
  std::string warning_;
};

/// Says whether a file begins as such a journal does; false for all but regular files.
bool is_journal(const std::filesystem::path& file, const JournalKind& kind);

/// Calls `seen` with each complete record of a journal. Returns how many bytes are whole (0: none, or no
/// journal). Throws InputError as the constructor of SealedJournal does.
std::size_t read_journal(const std::filesystem::path& file, const JournalKind& kind,
                         const std::string& digest, const RecordReader& seen);

} // namespace bem_contact
