#pragma once

#include "bem_contact/contact/problem.hpp"
#include "bem_contact/contact/result.hpp"

#include <vector>

namespace bem_contact::contact {

/// The elements of each connected area (8 neighbours) of state != exterior, in no order.
std::vector<std::vector<int>> connected_elements(const ContactGrid& grid,
                                                 const std::vector<ElementState>& state);

/// Connected areas (8 neighbours) of result.state != exterior, largest force first.
std::vector<PatchSummary> find_patches(const ContactProblem& problem, const ContactResult& result);

/// True where contact reaches an edge of the grid: the potential contact is too small.
bool touches_border(const ContactGrid& grid, const std::vector<ElementState>& state);

} // namespace bem_contact::contact
