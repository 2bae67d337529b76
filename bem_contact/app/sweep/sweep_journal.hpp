#pragma once

#include "bem_contact/app/sweep/sweep_record.hpp"

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace bem_contact::app {

/// A running sweep appends each finished case to this file, as one sealed record.
///
/// A kill at any moment loses no finished case: the next run cuts off a record that is only half written.
/// Only one process writes a journal.
///     bem_contact sweep 2\n<digest>\n
///     then [u64 bytes][record][SHA-256 of the record, 64 characters], in the machine's own byte order
class SweepJournal {
public:
  /// Makes the file, or continues it and calls `seen` with each complete record.
  /// Throws InputError if it belongs to a sweep of another digest, is in use, or cannot be opened; Error
  /// where writing fails.
  SweepJournal(std::filesystem::path file, const std::string& digest,
               const std::function<void(const CaseRecord&)>& seen);
  ~SweepJournal();
  SweepJournal(const SweepJournal&) = delete;
  SweepJournal& operator=(const SweepJournal&) = delete;

  /// `record`: to_bytes() of one.
  void append(const std::string& record);

private:
  std::filesystem::path file_;
  int handle_ = -1;
};

/// Calls `seen` with each complete record of a journal. Returns how many bytes belong to complete records (0:
/// none, or no journal). Throws InputError for a journal of another digest.
std::size_t read_journal(const std::filesystem::path& file, const std::string& digest,
                         const std::function<void(const CaseRecord&)>& seen);

/// The journals of an output: "SWEEP.h5.part", "SWEEP.h5.part-2-of-8", ...
std::vector<std::filesystem::path> journals_of(const std::filesystem::path& output);
std::filesystem::path journal_name(const std::filesystem::path& output, int part, int parts);

} // namespace bem_contact::app
