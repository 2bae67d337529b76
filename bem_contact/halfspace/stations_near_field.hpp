#pragma once

#include "bem_contact/halfspace/near_field.hpp"
#include "bem_contact/halfspace/rows_on_stations.hpp"

#include <array>
#include <span>
#include <vector>

/// Private to this room.
namespace bem_contact::halfspace {

/// Half-space numbers of pairs of stations, interpolated to pairs of rows exactly as with_rows() interpolates
/// the file's numbers. They depend only on how many stations lie between the two.
class StationsNearField {
public:
  /// `width`: of a station, mm.
  StationsNearField(const Material& material, const ExpandOptions& options, std::span<const RowWeights> rows,
                    double width);

  /// Takes `factor` times the numbers [i][j] of a pair (counted row by row, J <= I) at offset m from `block`.
  void take(int m, std::size_t pair, double factor, std::array<double, 9>& block) const;

private:
  struct Mix {
    int first = 0; ///< stations between
    std::array<double, 7> weight{};
  };
  std::size_t index(int m, int d) const { return static_cast<std::size_t>(m * (2 * most_ + 1) + most_ + d); }

  int most_ = 0;
  std::vector<std::array<double, 9>> lines_; ///< [offset][stations between, -most .. most]
  std::vector<Mix> mixes_;
};

} // namespace bem_contact::halfspace
