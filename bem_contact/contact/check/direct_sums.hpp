#pragma once

#include "bem_contact/contact/problem.hpp"

#include <array>
#include <span>
#include <vector>

namespace bem_contact::contact {

/// One field for each component x, s, n.
using ComponentFields = std::array<std::vector<double>, 3>;
using ComponentSpans = std::array<std::span<const double>, 3>;

/// u_i = (A p)_i in columns 0 .. mx + 1 (two ahead of the grid, for rolling), mm; fields [ms][columns]. By
/// direct sums over the influence numbers; if these are too many, by FFT, which direct sums at some elements
/// confirm. `slips`: the rows on which x and s are wanted; empty: only n is wanted. Where these are some
/// rows, x and s are sure to be there at what is loaded and two columns ahead of it. p: tractions, MPa.
ComponentFields direct_displacements(const ContactProblem& problem, const std::vector<char>& slips,
                                     const ComponentSpans& p, int threads = 1);

} // namespace bem_contact::contact
