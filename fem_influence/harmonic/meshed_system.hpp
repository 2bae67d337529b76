#pragma once

#include "fem_influence/harmonic/harmonic_system.hpp"

#include <filesystem>
#include <memory>
#include <span>
#include <vector>

namespace bem_contact::fem {

/// Seconds on the wall, summed over what was done.
struct Timing {
  double assembly = 0;      ///< mesh, functionals, matrices
  double analysis = 0;      ///< order of elimination and pattern of the factors
  double factorization = 0; ///< factors and kernels
};

/// The mesh of a section and its equations, without the matrices, which take most of the time.
struct MeshedSystem {
  /// `stations`: those whose kernel is wanted; none: all. Throws InputError for a mesh that does not fit.
  MeshedSystem(const BodyFile& body, const ProfileCurve& curve, const std::filesystem::path& mesh,
               std::span<const std::size_t> stations, Timing& timing);

  double reference_radius;
  std::unique_ptr<const Section> section;
  HarmonicSystem system; ///< op has no blocks
};

/// All that a HarmonicSolver needs.
struct AssembledSystem {
  HarmonicSystem system;  ///< with all matrices
  std::vector<int> order; ///< of elimination, a place for each node
};

/// The matrices and the order of elimination, after which the mesh is not needed any more. `memory`: where
/// the matrices lie, as for fill().
AssembledSystem add_matrices(MeshedSystem meshed, Timing& timing,
                             std::span<SectionOperator::Block> memory = {});

} // namespace bem_contact::fem
