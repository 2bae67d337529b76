#pragma once

#include "bem_contact/uses/sweep/sweep_columns.hpp"

#include <cstddef>
#include <functional>

namespace bem_contact {

/// Columns of a replay after those of its contacts: whether a step was solved, and of each quantity that is
/// compared the run's own number and by how much it differs from ours.
std::vector<SweepColumn> replay_columns(const SweepFile::Replay& replay);

/// Answers neighbouring steps of a replay, and solves as few of them as its tolerance allows.
///
/// Between two solved steps one more is solved: the one whose inputs lie farthest off the straight line
/// between theirs, or else the middle one. If what lies on the line there was known within the tolerance, all
/// steps between these three are taken from the lines between them; else both halves are looked at in the
/// same way. Steps with the inputs of a solved neighbour all along are never solved. Outcome, contact patches
/// and model must be the same at all three. Errors of what is not solved grow by the tolerance.
///
/// `solve` gives a case with the columns of its contacts, `kept` gets all of them in their order with
/// replay_columns() too, and says whether to go on.
void replay_steps(const SweepFile& sweep, CaseRange steps, const std::function<SweepCase(std::size_t)>& solve,
                  const std::function<bool(SweepCase)>& kept);

} // namespace bem_contact
