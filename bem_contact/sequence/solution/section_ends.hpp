#pragma once

#include "bem_contact/sequence/solution/solve_on_grid.hpp"

#include <array>
#include <optional>

namespace bem_contact {

/// A contact on a rail of sections, solved by the influence functions of one end and of the other of the
/// stretch between the two sections that it lies between (SectionBlend).
///
/// A blend holds for a body that is all along as it is under the contact. The true body changes over the
/// length L of the contact, and between the two sections it need not change linearly. From the one end to
/// the other, over the distance h, a number changes by D. Over half of the contact it changes by D L / (2 h);
/// where the change along the track is by a parabola, at most twice as steep at one end as on the mean, the
/// blend at the share w is off by D w (1 - w). Both are added to its stated error.
struct SectionEnds {
  std::array<ContactCase, 2> asked;
  std::array<GridSolution, 2> solved;
  double over_contact = 0; ///< L / h, 1
  double bend = 0;         ///< w (1 - w), 1

  /// By how much a number is uncertain that is `before` and `after` at the two ends.
  double error(double before, double after) const;
};

/// Solves both ends on the elements of a solution; nothing where no two files are blended. Throws
/// OffStripError where the section changes too much within the contact, and ConvergenceError where an end has
/// no certified solution.
std::optional<SectionEnds> section_ends(const ContactCase& asked, const GridSolution& solved,
                                        const SolveResources& resources);

/// The same error of the creepage of free rolling (free_creepage_of()); nothing where an end has none.
std::optional<double> free_creepage_error(SectionEnds& ends, const SolveResources& resources);

/// Adds what the ends say to the errors of a solution that are stated.
void add_section_errors(const SectionEnds& ends, ContactResult& result);
/// Does so for the moment about that point.
void add_section_error(const SectionEnds& ends, const ReferencePoint& about, Measured& moment);

} // namespace bem_contact
