#pragma once

#include "bem_contact/base/enum_names.hpp"
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

/// How a case ended.
enum class CaseStatus {
  missing = 0,       ///< not solved yet
  certified = 1,     ///< the certificate holds
  not_certified = 2, ///< a result whose certificate does not hold, or no convergence
  refused = 3,       ///< the input of the case is wrong: the reason says what
  died = 4           ///< the process that solved it ended
};
template <> struct EnumNames<CaseStatus> {
  static constexpr std::array<std::string_view, 5> names{"missing", "certified", "not certified", "refused",
                                                         "died"};
};

/// What is kept of one case of a sweep, but for its fields.
struct SweepCase {
  std::size_t index = 0;                   ///< from 0
  CaseStatus status = CaseStatus::missing; ///< how it ended
  std::string reason = {};                 ///< why it is not certified; a remark of the solver, warnings
  double seconds = 0;                      ///< wall clock
  double cpu_seconds = 0;                  ///< of the process
  std::vector<double> summary = {};        ///< SweepColumns::cases; empty where there is no result
  std::vector<std::vector<double>> patches = {}; ///< SweepColumns::patches of each patch
};

/// How many cases make a chunk. A chunk starts cold, and its cases start from each other. The chunks depend
/// on nothing but the number of cases, so results do not depend on who shares the work.
std::size_t chunk_size(std::size_t cases);

/// What the cases of one chunk share.
struct SweepSolver {
  std::shared_ptr<SequenceFiles> files; ///< of other chunks, too
  Sequence sequence;                    ///< solves contacts

  /// `displacements`: results hold them, for fields.
  explicit SweepSolver(std::shared_ptr<SequenceFiles> shared, bool displacements = false)
      : files(std::move(shared)), sequence({.displacements = displacements}, files) {}
};

/// How cases are solved.
struct SweepOptions {
  std::string model = {}; ///< instead of the scene's own; "": that
  bool strict = false;    ///< a case with a warning is refused
  /// Called with each result that is kept, before it is gone: `group` is "", or "right/" and "left/" of the
  /// wheels of a wheelset.
  std::function<void(const std::string& group, const SceneResult&)> seen = {};
  const std::atomic<bool>* stop = nullptr; ///< as Sequence::solve()
};

/// Solves a case. What is wrong with it is in its record; throws Stopped alone.
SweepCase solve_case(SweepSolver& solver, const SweepFile& sweep, std::size_t index,
                     const SweepOptions& options);

} // namespace bem_contact
