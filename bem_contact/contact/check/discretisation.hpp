#pragma once

#include "bem_contact/contact/solve.hpp"

#include <optional>

namespace bem_contact::contact {

/// A coarser problem and a guess at its solution.
struct Companion {
  ContactProblem problem;
  StartingPoint start; ///< means of our tractions over the joined elements
};

/// The same problem on elements twice as large in x and in s (a direction of one element stays). Its numbers
/// are exact: means over the joined target elements of sums over the joined loaded ones, as ours are averages
/// over elements. Undeformed distance, rigid slip and rows are taken at the new centres (cubic
/// interpolation).
///
/// An odd column or row is left out at the end that is farther from the contact. Offsets
/// beyond those known are extrapolated linearly: only the first columns act over them, ahead of the grid.
/// Nothing is returned where the contact touches the border of the grid, where it is empty, or where the grid
/// is one element.
std::optional<Companion> coarse_companion(const ContactProblem& problem, const ContactResult& result);

/// An estimate is no better known than to some per cent: so precisely the companion is solved, and accepted.
inline constexpr double companion_tolerance = 1e-5, companion_violation = 1e-4;

/// Compares a result with that of its coarse companion. Nothing where the companion's certificate is worse
/// than companion_violation or it has too few elements in contact.
std::optional<Discretisation> compare(const ContactProblem& problem, const ContactResult& result,
                                      const ContactProblem& coarse_problem, const ContactResult& coarse);

} // namespace bem_contact::contact
