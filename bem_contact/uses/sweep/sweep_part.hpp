#pragma once

#include "bem_contact/base/error.hpp"
#include "bem_contact/uses/sweep/sweep_columns.hpp"
#include "bem_contact/uses/sweep/sweep_inputs.hpp"

#include <atomic>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>

namespace bem_contact {

/// A sweep as a command was given it.
struct AskedSweep {
  std::filesystem::path scene; ///< its file
  SweepFile sweep;
  std::string model = {};  ///< of the option; "": none
  bool strict = false;     ///< a case with a warning is refused
  Origins origins = {};    ///< all that the results depend on
  std::string digest = {}; ///< digest_of() them

  const SweepColumns& columns() const { return columns_of(sweep); }
};

/// A file of some neighbours in the order of a sweep: the table of these cases (sweep_table.hpp), with the
/// attributes format, digest, first_case and last_case (not included). The same cases give the same bytes
/// wherever they are solved, but for their seconds.
struct SweepPart {
  std::filesystem::path file;
  CaseRange cases;
  std::size_t patches = 0; ///< rows of the table of patches
};

/// Solves cases in this process and writes their file, which is whole or absent. Returns which they are.
/// `slow_case`: seconds; if the first case takes longer, it is the only one. `kept` is called after each
/// case; `stop` as Sequence::solve(). Throws std::bad_alloc where memory ran out, and what H5Writer does.
CaseRange solve_part(const AskedSweep& asked, CaseRange cases, const std::shared_ptr<SequenceFiles>& files,
                     const std::filesystem::path& file, double slow_case, const std::function<void()>& kept,
                     const std::atomic<bool>* stop = nullptr);

/// Why a file is not joined.
class PartFault : public InputError {
public:
  PartFault(const std::string& whole, std::string reason, bool is_damaged)
      : InputError(whole), why(std::move(reason)), damaged(is_damaged) {}
  std::string why;
  bool damaged; ///< nothing can be made of it; a part of another sweep is not damaged
};

/// Throws PartFault for a file that is not a part of this sweep, or damaged.
SweepPart read_part(const AskedSweep& asked, const std::filesystem::path& file);
/// Reads every number of it. Throws PartFault.
void require_whole(const std::filesystem::path& file);
/// Of a part that this program has just written: its table is looked at when it is joined.
CaseRange cases_in_part(const AskedSweep& asked, const std::filesystem::path& file);

/// Whether a file says that it is a part of any sweep.
bool is_part_of_sweep(const std::filesystem::path& file);

} // namespace bem_contact
