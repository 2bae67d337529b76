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

/// How many cases make a chunk. A chunk starts cold, and its cases start from each other. The chunks depend
/// on nothing but the number of cases of the sweep.
std::size_t chunk_size(std::size_t cases);

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
/// does the first of each chunk. So what is found does not depend on how a sweep is cut, if it is cut between
/// chunks. `kept` gets each case, with what is wrong with it, and says whether to go on. Throws Stopped, and
/// what `kept` does.
void solve_cases(const SweepFile& sweep, CaseRange cases, const SweepOptions& options,
                 const std::shared_ptr<SequenceFiles>& files, const std::function<bool(SweepCase)>& kept);

} // namespace bem_contact
