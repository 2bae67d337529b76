#pragma once

#include <string>

namespace bem_contact::app {

/// What `bem_contact sweep` was asked for.
struct SweepRequest {
  std::string scene, output, csv, model;
  int jobs = 0;       ///< processes; 0: one a core
  std::string part;   ///< "2/8": the second of eight shares; "": all
  bool merge = false; ///< solve nothing: write what the shares have solved
};

struct SweepSummary {
  std::string text;       ///< what was solved, in how many seconds, what failed
  bool certified = false; ///< every case that was asked for
};

/// Solves the cases that are not solved yet and writes them into one file (sweep_file.hpp). A share writes
/// its journal alone (sweep_journal.hpp): merge makes the file of all of them.
/// Throws InputError for wrong input, an output that belongs to another sweep, or files that cannot be
/// written; what is wrong with a single case is in its record.
SweepSummary sweep_command(const SweepRequest& request);

/// Examples, for --help.
std::string sweep_help();

} // namespace bem_contact::app
