#pragma once

#include "fem_influence/harmonic/machine_group.hpp"
#include "fem_influence/harmonic/meshed_system.hpp"

#include <exception>
#include <optional>
#include <span>

namespace bem_contact::fem {

/// Matrices and order of elimination that the first process of a machine computes for all of its processes.
class MachineSystem {
public:
  /// All of the group together. The first process brings its meshed system and computes matrices and order
  /// here; the others, which bring none, go on as soon as they have the rest. The group must live longer.
  MachineSystem(MachineGroup& group, std::optional<MeshedSystem> meshed, Timing& timing);

  /// This process's system, to be taken once; waits until the first process has the matrices. None where the
  /// machine has no memory for all: this process must mesh and assemble for itself then. Throws where the
  /// first process failed.
  std::optional<AssembledSystem> take();

  /// Throws where this process failed to compute the matrices.
  void require_matrices() const;

private:
  MachineGroup& group_;
  HarmonicSystem system_; // without blocks, on processes that are not the first
  std::span<SectionOperator::Block> blocks_;
  std::span<int> order_;
  std::optional<AssembledSystem> assembled_; // on the first
  std::exception_ptr failure_;               // of the first
};

} // namespace bem_contact::fem
