#pragma once

#include "bem_contact/contact/problem.hpp"
#include "bem_contact/contact/result.hpp"

#include <vector>

namespace bem_contact::contact {

/// Returns one summary for each of patch_elements() of the result, in their order: the largest force first.
std::vector<PatchSummary> find_patches(const ContactProblem& problem, const ContactResult& result);

/// True where contact reaches an edge of the grid: the potential contact is too small.
bool touches_border(const ContactGrid& grid, const std::vector<ElementState>& state);

} // namespace bem_contact::contact
