#pragma once

#include "bem_contact/record/column.hpp"
#include "bem_contact/sequence/scene_result.hpp"

#include <atomic>
#include <cstddef>
#include <vector>

/// A load collective is a sweep whose cases occur with weights: what all answers to it share.
namespace bem_contact {

class Sequence;
struct SweepFile;

/// Solves one of its cases. Throws ConvergenceError where it has no certified result, and what
/// Sequence::solve() throws.
SceneResult solve_of_collective(Sequence& sequence, const SweepFile& sweep, std::size_t index,
                                const std::atomic<bool>* stop);

/// Where the wheelset of a case is along the track, mm.
double place_of_case(const SweepFile& sweep, std::size_t index);

/// The columns that say of which case a patch is. P has `index`, `patch`, `weight` and `along`.
template <class P> std::vector<ColumnOf<P>> columns_of_case() {
  return {{"case", "1", "of the sweep, from 0", [](const P& p) { return double(p.index); }},
          {"patch", "1", "of the case, from 1, the largest force first",
           [](const P& p) { return double(p.patch); }},
          {"weight", "1", "how often the case occurs", [](const P& p) { return p.weight; }},
          {"along", "mm", "place of the wheelset along the track (position.along)",
           [](const P& p) { return p.along; }}};
}

} // namespace bem_contact
