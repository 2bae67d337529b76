#pragma once

#include "bem_contact/uses/shakedown/shakedown_of_result.hpp"

#include <atomic>
#include <cstddef>
#include <functional>
#include <span>
#include <vector>

/// A load collective: how do its cases together strain the steel?
namespace bem_contact {
struct SceneResult;
struct SweepFile;
} // namespace bem_contact

namespace bem_contact::shakedown {

/// One patch of one case, without the maps of its section.
struct CollectivePatch : PatchShakedown {
  std::size_t index = 0; ///< of the case in the sweep
  std::size_t patch = 0; ///< of the case, from 1, the largest force first
  double weight = 1;     ///< how often the case occurs
  double along = 0;      ///< place of its wheelset along the track, mm
};

/// What is known at points below the rail's surface, of all cases; [s][depth], depth fastest.
struct Envelope {
  std::vector<double> s, depths;        ///< mm, rising
  std::vector<double> dang_van;         ///< largest of all cases, MPa; 0: no patch reaches there
  std::vector<double> damage;           ///< of one passage, mean over the collective; nan: no fatigue limit
  AtPoint worst_dang_van, worst_damage; ///< the largest of each
};

struct CollectiveShakedown {
  std::vector<CollectivePatch> patches; ///< case by case
  std::size_t cases = 0, too_small = 0;
  Envelope envelope;

  /// How many patches do so.
  std::size_t count(Yielding yielding) const;
};

/// What some cases do: their results in, the shakedown of each out, in the same order.
using ShakedownOfCases = std::function<std::vector<Shakedown>(std::span<const SceneResult>)>;

/// Solves each case of a sweep, and asks `of_cases` for the shakedown of each, `at_once` cases at a time.
/// Damages of cases sum up at each point after Miner (Dang Van's stress against the Woehler line of
/// fatigue_limits.hpp). Throws InputError for wrong properties, ConvergenceError where a case has no
/// certified result, and Stopped soon after another thread sets `stop`.
CollectiveShakedown shakedown_of(const SweepFile& sweep, const ShakedownProperties& properties,
                                 const ShakedownOfCases& of_cases, int at_once,
                                 const std::atomic<bool>* stop = nullptr);

/// That of half-spaces. `threads` work side by side; the numbers do not depend on how many.
CollectiveShakedown shakedown_of(const SweepFile& sweep, const ShakedownProperties& properties,
                                 int threads = 1, const std::atomic<bool>* stop = nullptr);

/// "of 12 patches 3 yield never, 8 once, 1 for ever; ..."
std::string in_words(const CollectiveShakedown& found, const ShakedownProperties& properties);

/// The numbers of a patch with those of its case, in the order of the outputs.
std::span<const ColumnOf<CollectivePatch>> collective_columns();

record::Record record_of(const CollectiveShakedown& found, const ShakedownProperties& properties);

} // namespace bem_contact::shakedown
