#pragma once

#include "bem_contact/contact/problem.hpp"

#include <optional>

namespace bem_contact::contact {

/// The same problem on elements twice as large in x and in s (a direction of one element stays). Its numbers
/// are exact: means over the joined target elements of sums over the joined loaded ones, as ours are averages
/// over elements. Undeformed distance, rigid slip and rows are taken at the new centres (cubic
/// interpolation).
///
/// An odd column or row is left out at the end that is farther from the contact. One offset of an even grid
/// is not known (mx + 1 of the fine ones); it acts only where the first and the last column are both in
/// contact. Nothing is returned where the contact touches the border of the grid, where it is empty, or
/// where the grid is one element.
std::optional<ContactProblem> coarse_companion(const ContactProblem& problem, const ContactResult& result);

/// Compares a result with that of its coarse companion. Nothing where the companion did not converge or is
/// in contact at both ends of the grid along x.
std::optional<Discretisation> compare(const ContactProblem& problem, const ContactResult& result,
                                      const ContactProblem& coarse_problem, const ContactResult& coarse);

} // namespace bem_contact::contact
