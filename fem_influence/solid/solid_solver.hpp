#pragma once

#include "bem_contact/base/material.hpp"
#include "fem_influence/shared/mumps_solver.hpp"
#include "fem_influence/solid/solid_body.hpp"

namespace bem_contact::fem {

/// Functionals f(v) = integral over the patch of v . e_j ds dx with the surface's own frame: column 3 P + j,
/// rows 3 node + component with hanging nodes replaced by their masters. Load vector of a unit traction and,
/// over the area, the sampling of a mean displacement: one array for both keeps Maxwell-Betti exact.
/// Throws InputError where the group `contact` does not cover a patch.
SparseColumns patch_functionals(const SolidBody& body, const ContactSurface& surface,
                                std::span<const SurfacePatch> patches);

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
  std::vector<int> unknown_numbers(MirrorSymmetry symmetry) const;

  const SolidBody& body_;
  Elements cells_;            ///< nodes, masters for those that hang
  std::vector<double> value_; ///< of each cell's degrees of freedom the lower triangle, column by column
  std::vector<int> place_;    ///< of each node in the elimination
};

/// Memory that processes may still take, GiB; infinite where the system does not say.
double available_memory();

} // namespace bem_contact::fem
