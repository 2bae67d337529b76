#pragma once

#include "bem_contact/app/study/study_case.hpp"
#include "bem_contact/record/outcome.hpp"
#include "bem_contact/record/record.hpp"

#include <filesystem>
#include <functional>
#include <set>
#include <span>
#include <string>
#include <vector>

namespace bem_contact::app {

/// What differs in how a part is run.
enum class PartKind {
  usual,     ///< one command, one result file
  influence, ///< the program of [influence]; no result file
  wheelset,  ///< says where the wheel is that other parts take
  sweep,     ///< tables (CSV) beside its result
  wear       ///< a folder of its own
};

/// A command as a part of a study.
struct Part {
  const char* name; ///< of its table in the scene, its files and its group
  PartKind kind = PartKind::usual;
  const char* title;   ///< what it answers
  const char* command; ///< "": the program of [influence]
  bool (*asked)(const StudyCase&);
  bool of_one_wheel = false; ///< solves no wheelset: it takes the wheel of wheel_text()
  /// With [wheelset] it is of the wheelset of the scene without [sweep].
  bool of_one_wheelset = false;
  bool has_jobs = false;   ///< the option --jobs
  bool goes_on = false;    ///< called again, it may find what was not found
  bool solves = true;      ///< contacts, which are certified
  bool has_models = false; ///< by several models, each in its turn
};

/// Lists the parts in the order of their work: a later one may use what an earlier one has found.
std::span<const Part> all_parts();
const Part* part_named(std::string_view name); ///< null: none

/// How a part went.
struct PartResult {
  const Part* part = nullptr;
  int code = 0;      ///< ExitCode
  bool kept = false; ///< was there, and is still true
  double seconds = 0;
  std::vector<std::string> errors = {}, warnings = {};
  std::string about = {}; ///< of which wheel it is, and what it has not taken over; "": of the whole scene
  std::filesystem::path file; ///< of its result (HDF5); "": it has none
};

/// How it ended: of a part that solves no contact `done`, not `certified`.
record::Outcome outcome_of(const PartResult& result);

/// Where a study is, and what is wanted of it.
struct StudyFolder {
  std::filesystem::path scene;          ///< file of the scene
  std::filesystem::path folder;         ///< of the answers
  int jobs = 0;                         ///< processes of a part; 0: what its command takes by itself
  std::vector<std::string> wanted = {}; ///< parts; empty: all that the scene asks for
  std::string program = {};             ///< of the option --influence; "": none
  std::vector<std::filesystem::path> inputs = {}; ///< files that the scene names, and its own

  std::filesystem::path parts() const { return folder / "parts"; }
};

/// The name under which studies list what they have written (base/output_folder.hpp).
inline constexpr const char* study_maker = "study";

/// Makes the folders. Throws InputError where they cannot be made, and where `parts` holds something that no
/// study has made.
void make_study_folder(const StudyFolder& where);

/// Runs each part that is asked for and is not there yet. `tell` is called after each. `said`: messages that
/// have been shown.
std::vector<PartResult> run_parts(const StudyCase& study, const StudyFolder& folder,
                                  std::set<std::string>& said,
                                  const std::function<void(const PartResult&)>& tell);

} // namespace bem_contact::app
