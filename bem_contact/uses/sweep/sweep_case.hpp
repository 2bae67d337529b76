#pragma once

#include "bem_contact/record/outcome.hpp"
#include "bem_contact/scene/sweep_file.hpp"
#include "bem_contact/sequence/sequence.hpp"

#include <atomic>
#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace bem_contact {

/// What is kept of one case of a sweep, but for its fields.
struct SweepCase {
  std::size_t index = 0;                             ///< from 0
  record::Outcome status = record::Outcome::missing; ///< how it ended
  std::string reason = {};          ///< why it is not certified; a remark of the solver, warnings
  double seconds = 0;               ///< wall clock
  double cpu_seconds = 0;           ///< of the process
  std::vector<double> summary = {}; ///< SweepColumns::cases; empty where there is no result
  std::vector<std::vector<double>> patches = {}; ///< SweepColumns::patches of each patch
};

/// How many of so many cases make a chunk where nothing is known of their work. A chunk starts cold, and its
/// cases start from each other.
std::size_t chunk_size(std::size_t cases);

/// How a sweep is cut into chunks: by the number of its cases and the work of its first, and not by how many
/// processes share it or how busy they are. So what is found does not depend on these.
struct SweepCut {
  double case_work = 0;  ///< units of work (contact/work.hpp), about: foreseen_work() of the first case
  std::size_t chunk = 1; ///< cases
  bool little = false;   ///< all cases together are so little work that they are one chunk
};
/// Each case is a chunk where one takes long.
SweepCut cut_of(std::size_t cases, double case_work);
/// That of a sweep, by the work that its first case is foreseen to take. Reads what this case names.
SweepCut cut_of(const SweepFile& sweep, const std::string& model, SequenceFiles& files);

/// How cases are solved.
struct SweepOptions {
  std::string model = {};     ///< instead of the scene's own; "": that
  bool strict = false;        ///< a case with a warning is refused
  bool displacements = false; ///< results hold them, for fields
  /// Called with each result that is kept, before it is gone: `group` is "", or "right/" and "left/" of the
  /// wheels of a wheelset.
  std::function<void(const std::string& group, const SceneResult&)> seen = {};
  const std::atomic<bool>* stop = nullptr; ///< as Sequence::solve()
};

/// Solves cases one after the other, each from what was learnt of those before. The first starts cold, and so
/// does the first of each chunk (cut_of()). So what is found does not depend on how a sweep is cut, if it is
/// cut between chunks. `kept` gets each case, with what is wrong with it, and says whether to go on. Throws
/// Stopped, and what `kept` does.
void solve_cases(const SweepFile& sweep, CaseRange cases, const SweepOptions& options,
                 const std::shared_ptr<SequenceFiles>& files, const std::function<bool(SweepCase)>& kept);

} // namespace bem_contact
