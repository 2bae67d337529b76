#pragma once

#include "bem_contact/influence/influence_function.hpp"

#include <array>
#include <span>
#include <vector>

/// Private to this room: rows that lie between the stations of an influence file, by interpolation.
namespace bem_contact::halfspace {

/// Lagrange weights of `count` (at most 4) neighbouring stations for one row.
struct RowWeights {
  int first = 0, count = 0;
  std::array<double, 4> weight{};
};

/// Weights of rows at these arc lengths, mm. They do not depend on which stations there are beyond those with
/// a weight, to the last bit.
std::vector<RowWeights> interpolate(const InfluenceStrip& strip, std::span<const double> row_s);

/// Stations with a weight, and those between.
StationRange used_stations(std::span<const RowWeights> rows);

/// The function with the rows in place of its stations; of plane strain the wavenumber 0 alone. Interpolating
/// the kernel is the same as interpolating the influence numbers, because expand() is linear in the kernel,
/// and it is cheaper: there are fewer wavenumbers than offsets, and fewer rows than stations.
InfluenceFunction with_rows(const InfluenceFunction& function, std::span<const RowWeights> rows,
                            bool plane_strain);

} // namespace bem_contact::halfspace
