#pragma once

#include "bem_contact/base/sealed_journal.hpp"
#include "bem_contact/influence/influence_function.hpp"

#include <cstddef>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace bem_contact {

/// Journals of finished wavenumbers; `magic` is their first line.
constexpr JournalKind wavenumber_journals(std::string_view magic) {
  return {.magic = magic,
          .owner = "computation",
          .of_another = "it holds finished wavenumbers of another body, mesh or program version",
          .of_nobody = "it holds no finished wavenumbers of this version of fem_influence",
          .what_to_do = "To keep it, give another output with -o, or the body and mesh that it belongs to. "
                        "To begin anew, remove it.",
          .if_in_use = "Wait for it, or give another output with -o."};
}

/// The wavenumbers that a run has finished so far, in `file` + ".part". A run that was killed goes on from
/// it.
class PartialInfluenceFile {
public:
  /// Opens or creates. Throws what a SealedJournal does (base/sealed_journal.hpp). Another `fingerprint` is
  /// another body.
  PartialInfluenceFile(const std::filesystem::path& file, const std::string& fingerprint,
                       std::size_t stations, std::span<const double> wavenumber);
  ~PartialInfluenceFile();
  bool has(std::size_t k) const;
  /// numbers: the kernel's lower triangle by rows, remote, remote_self, and errors of any meaning.
  void write(std::size_t k, std::vector<double> numbers);
  /// Moves wavenumbers, kernel, remote and remote_self of all parts into `function`, and their errors one
  /// after the other into `errors`. Throws InputError if a part is missing. Only the file has them
  /// afterwards.
  void take_into(InfluenceFunction& function, std::vector<double>& errors);
  void remove(); ///< after the final file is complete

private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

} // namespace bem_contact
