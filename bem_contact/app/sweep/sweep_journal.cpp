#include "bem_contact/app/sweep/sweep_journal.hpp"
#include "bem_contact/app/output/output_names.hpp"

#include "bem_contact/sequence/scene_record.hpp"

#include <algorithm>
#include <cstdio>
#include <fmt/format.h>

namespace bem_contact::app {

namespace {

constexpr JournalKind sweep_journals{
    .magic = "bem_contact sweep 2\n",
    .owner = "sweep",
    .of_another = digest_changed,
    .of_nobody = "it was not made by bem_contact sweep",
    .what_to_do = "Finish that sweep with what it began with, give another output, or remove the file.",
    .if_in_use = "Wait for it, or solve another --part."};

/// "" or "-2-of-8".
bool is_ending_of_share(const std::string& ending) {
  int part = 0, parts = 0;
  return ending.empty() || (std::sscanf(ending.c_str(), "-%d-of-%d", &part, &parts) == 2 &&
                            ending == fmt::format("-{}-of-{}", part, parts));
}

RecordReader decoded(const std::function<void(const CaseRecord&)>& seen) {
  return [&seen](std::string_view record) { seen(from_bytes(record)); };
}

} // namespace

std::size_t read_journal(const std::filesystem::path& file, const std::string& digest,
                         const std::function<void(const CaseRecord&)>& seen) {
  return bem_contact::read_journal(file, sweep_journals, digest, decoded(seen));
}

SweepJournal::SweepJournal(const std::filesystem::path& file, const std::string& digest,
                           const std::function<void(const CaseRecord&)>& seen)
    : SealedJournal(file, sweep_journals, digest, decoded(seen)) {}

std::filesystem::path journal_name(const std::filesystem::path& output, int part, int parts) {
  return output.string() + (parts > 1 ? fmt::format(".part-{}-of-{}", part, parts) : ".part");
}

std::vector<std::filesystem::path> journals_of(const std::filesystem::path& output) {
  std::vector<std::filesystem::path> found;
  const std::filesystem::path folder = output.has_parent_path() ? output.parent_path() : ".";
  const std::string whole = output.filename().string() + ".part";
  std::error_code ignored;
  for (const auto& entry : std::filesystem::directory_iterator(folder, ignored)) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with(whole) && is_ending_of_share(name.substr(whole.size())) &&
        is_journal(entry.path(), sweep_journals)) // others may have files of such names
      found.push_back(output.has_parent_path() ? entry.path() : entry.path().filename());
  }
  std::ranges::sort(found);
  return found;
}

} // namespace bem_contact::app
