#pragma once

#include "bem_contact/profile/bodies/body_file.hpp"
#include "bem_contact/profile/profile_curve.hpp"
#include "fem_influence/harmonic/section.hpp"
#include "fem_influence/harmonic/section_operator.hpp"
#include "fem_influence/shared/sparse_columns.hpp"

#include <span>
#include <vector>

namespace bem_contact::fem {

/// The section's equations as all wavenumbers share them: matrices, loads, and what is asked of the solution.
struct HarmonicSystem {
  std::size_t cells = 0, stations = 0;
  double width = 0; ///< of a station, mm
  SectionOperator op;
  std::vector<int> unknown;      ///< of degree of freedom 3 node + component; -1: held
  SparseColumns functionals;     ///< of the unknowns: the stations' (3 each), the remote section's (6)
  SparseColumns held_motion;     ///< of the degrees of freedom: rigid motions of the held part
  std::vector<double> load_work; ///< [rigid motion][load]: work of the load on the unknowns
  std::size_t nodes() const { return unknown.size() / 3; }
  std::size_t unknowns() const;
  /// In all three components; the others are held in none.
  bool held(int node) const { return unknown[3 * static_cast<std::size_t>(node)] < 0; }
  /// use(array) and use(number) of everything above but op's blocks, always in the same order: to send it to
  /// other processes.
  template <class Use> void for_each_part(Use&& use) {
    use(cells), use(stations), use(width), use(op.mu), use(op.lambda);
    use(op.cells.begin), use(op.cells.member), use(unknown), use(load_work);
    for (SparseColumns* columns : {&functionals, &held_motion})
      use(columns->column_begin), use(columns->row), use(columns->value);
  }
};

/// All but the blocks of its operator, which take most of the time: fill() gives them. `chosen`: of these
/// stations alone, in this order; none: of all. Throws InputError where the mesh does not fit the strip, or
/// where no node can move.
HarmonicSystem lay_out_system(const Section& section, const BodyFile& body, const ProfileCurve& curve,
                              std::span<const std::size_t> chosen = {});

/// Place of each node in the elimination, the held ones last. Deterministic, so that it does not matter which
/// process computes it.
std::vector<int> elimination_order(const HarmonicSystem& system);
/// Numbers the unknowns by their nodes' places.
void renumber(HarmonicSystem& system, std::span<const int> place);
/// Appends to the functionals the support's reaction on each rigid motion m of the held part, (K(0) m)^T u.
void append_reactions(HarmonicSystem& system);
/// The unknowns of each cell that has some, in the order of its nodes.
Elements unknowns_of_cells(const HarmonicSystem& system);

} // namespace bem_contact::fem
