#pragma once

#include "bem_contact/base/conventions.hpp"

#include <cstddef>
#include <vector>

namespace bem_contact {

/// Influence numbers of one body or of the pair on a regular strip: `rows` element rows along s, elements
/// dx by ds, offsets m = x_I - x_J = 0 .. offsets-1 in units of dx. Negative offsets follow from parity(i,
/// j).
///
/// values[m][3 I + i][3 J + j], row-major: displacement i averaged over element (m, I), mm, under 1 MPa of
/// traction j on element (0, J). Maxwell-Betti: A_ij(m; I, J) = parity(i,j) A_ji(m; J, I).
/// Steady rolling over mx columns needs offsets = mx + 2.
/// Plane strain (one element, infinitely long along x): offsets = 1, dx = 0 and k = 0 only.
struct InfluenceNumbers {
  int offsets = 0;
  int rows = 0;
  double dx = 0; ///< mm
  double ds = 0; ///< mm
  std::vector<double> values;

  double& at(int m, int row_i, int i, int row_j, int j) { return values[index(m, row_i, i, row_j, j)]; }
  double at(int m, int row_i, int i, int row_j, int j) const { return values[index(m, row_i, i, row_j, j)]; }
  std::size_t index(int m, int row_i, int i, int row_j, int j) const {
    const std::size_t n = 3 * static_cast<std::size_t>(rows);
    return (static_cast<std::size_t>(m) * n + 3 * row_i + i) * n + 3 * row_j + j;
  }
};

} // namespace bem_contact
