#pragma once

#include "bem_contact/contact/problem.hpp"

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace bem_contact::contact {

/// One field for each component x, s, n.
using ComponentFields = std::array<std::vector<double>, 3>;
using ComponentSpans = std::array<std::span<const double>, 3>;

/// Columns of the sums: two ahead of the grid, for rolling, where the numbers reach so far.
int summed_columns(const ContactProblem& problem);

/// Places in a field [ms][summed_columns()] at which displacements are wanted; nothing: everywhere. At others
/// they may be left at 0.
using Places = std::optional<std::vector<int>>;

/// Which displacements a certificate needs.
struct WantedDisplacements {
  Places tangential = std::vector<int>{}; ///< x and s
  Places normal = std::nullopt;           ///< n; what is left at 0 is not negative
};

/// u_i = (A p)_i, mm; fields [ms][summed_columns()]. By direct sums over the influence numbers; if these are
/// too many, by FFT, which direct sums at some elements confirm. p: tractions, MPa.
ComponentFields direct_displacements(const ContactProblem& problem, const WantedDisplacements& wanted,
                                     const ComponentSpans& p, int threads = 1);

} // namespace bem_contact::contact
