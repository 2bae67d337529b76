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

/// Which displacements a certificate needs.
struct WantedDisplacements {
  /// One value a row: whether x and s are wanted there; empty: nowhere. Where these are some rows, x and s
  /// are sure to be there at what is loaded and two columns ahead of it.
  std::vector<char> slip_rows = {};
  /// Elements at which n is wanted, those with tractions among them; nothing: all elements. At others n may
  /// be left at 0: then it is not negative.
  std::optional<std::vector<int>> normal = std::nullopt;
};

/// u_i = (A p)_i in columns 0 .. mx + 1 (two ahead of the grid, for rolling), mm; fields [ms][columns]. By
/// direct sums over the influence numbers; if these are too many, by FFT, which direct sums at some elements
/// confirm. p: tractions, MPa.
ComponentFields direct_displacements(const ContactProblem& problem, const WantedDisplacements& wanted,
                                     const ComponentSpans& p, int threads = 1);

} // namespace bem_contact::contact
