#pragma once

#include "bem_contact/base/material.hpp"
#include "fem_influence/shared/elements.hpp"
#include "fem_influence/shared/sparse_columns.hpp"
#include "fem_influence/solid/solid_body.hpp"

#include <functional>
#include <span>
#include <vector>

namespace bem_contact::fem {

/// A load along x is antisymmetric about the plane x = 0 in u_y and u_z, any other one in u_x.
enum class MirrorSymmetry { even, odd };

/// Stiffness of a refined body; one factorization a symmetry.
class SolidSolver {
public:
  SolidSolver(const SolidBody& body, const Material& material);

  std::size_t unknowns(MirrorSymmetry symmetry) const;
  /// Solves for each column of `loads` and hands over the products of the solution with `samples` (both as
  /// patch_functionals gives them) and the solution itself [3 node + component].
  /// Throws Error where the factors would not fit into memory.
  void solve(MirrorSymmetry symmetry, const SparseColumns& loads, const SparseColumns& samples,
             const std::function<void(std::size_t column, std::span<const double> sampled,
                                      std::span<const double> displacement)>& use) const;

private:
  /// Of degree of freedom 3 node + component, in the order of elimination; -1: it is none.
  std::vector<int> unknown_numbers(MirrorSymmetry symmetry) const;
  /// The values of the unknowns' matrix, and whose they are, cell by cell as MumpsSolver takes them.
  std::vector<double> unknown_part(std::span<const int> unknown, Elements& elements) const;
  /// Of all nodes, [3 node + component], from the unknowns' solution.
  std::vector<double> displacement(std::span<const int> unknown, std::span<const double> solution) const;

  const SolidBody& body_;
  Elements cells_;            ///< nodes, masters for those that hang
  std::vector<double> value_; ///< of each cell's degrees of freedom the lower triangle, column by column
  std::vector<int> place_;    ///< of each node in the elimination
};

} // namespace bem_contact::fem
