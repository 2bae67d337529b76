#pragma once

#include "bem_contact/app/sweep/sweep_record.hpp"
#include "bem_contact/base/sealed_journal.hpp"

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace bem_contact::app {

/// A running sweep appends each finished case, to_bytes() of its record, to this file.
class SweepJournal : public SealedJournal {
public:
  SweepJournal(const std::filesystem::path& file, const std::string& digest,
               const std::function<void(const CaseRecord&)>& seen);
};

/// Reads the complete cases of a journal (base/sealed_journal.hpp).
std::size_t read_journal(const std::filesystem::path& file, const std::string& digest,
                         const std::function<void(const CaseRecord&)>& seen);

/// The journals of an output: "SWEEP.h5.part", "SWEEP.h5.part-2-of-8", ...
std::vector<std::filesystem::path> journals_of(const std::filesystem::path& output);
std::filesystem::path journal_name(const std::filesystem::path& output, int part, int parts);

} // namespace bem_contact::app
