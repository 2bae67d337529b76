#pragma once

#include "bem_contact/contact/problem.hpp"

#include <array>
#include <vector>

namespace bem_contact::contact {

using Fields = std::array<std::vector<double>, 3>;
using Loads = std::array<const std::vector<double>*, 3>;

/// u_i = (A p)_i in columns 0 .. mx + 1 (two ahead of the grid, for rolling), by direct summation over the
/// numbers; where that is too much, by FFT, with direct sums at some elements as the check. `slips`: the rows
/// on which x and s are wanted; empty: n is all that is wanted.
Fields direct_displacements(const ContactProblem& problem, const std::vector<char>& slips, const Loads& p);

} // namespace bem_contact::contact
