#pragma once

#include "bem_contact/halfspace/line_store.hpp"
#include "bem_contact/influence/expand.hpp"

#include <array>
#include <cstddef>
#include <functional>
#include <span>
#include <vector>

/// Private to this room.

namespace bem_contact::halfspace {

/// A weighted sum of lines: a line is one influence number at all offsets. What is mixed are blocks of nine
/// lines [i][j][m], one after the other.
struct LineMix {
  static constexpr std::size_t most = 11; ///< blocks
  std::size_t count = 0;
  std::array<const double*, most> block{};
  std::array<double, most> weight{};

  void add(const double* from, double factor) {
    if (factor != 0) {
      block[count] = from;
      weight[count++] = factor;
    }
  }
};

/// line = factor line + the mix of the blocks' lines `shift` values after their beginning.
void add_mix(const LineMix& mix, std::size_t shift, double factor, double* line, std::size_t offsets);

/// Half-space numbers of all pairs of rows of one strip, at every offset. Rows need not be equally far apart.
///
/// A line is the numbers of two rows at all offsets. Pairs at the same distance share a line. On a wheel,
/// opposite equal rows of the rail, the distances of d-th neighbours scatter a little. Then lines at a few
/// distances (Chebyshev's points) between the smallest and the largest serve all of them by interpolation.
/// Both ends are rounded outwards, so that other strips need the same lines. The numbers are analytic in the
/// distance as long as elements do not touch, so the polynomial through p lines is off by at most 4 (h / 2
/// g)^p, where h is half of the range and g its distance from touching. p is chosen for near_field_accuracy
/// (settings.hpp); if 4 lines are not enough, each pair has its own.
class NearField {
public:
  /// `row_s` monotone, mm; offsets and dx of the options (0: plane strain) count. `ds`: width of the rows.
  /// `known`: lines of earlier ones.
  NearField(const Material& material, const ExpandOptions& options, std::span<const double> row_s, double ds,
            LineStore& known);
  /// Rows that need not lie on one line: the distance of row_j and the row so many rows `apart` from it, mm.
  /// All have one sign.
  using Distances = std::function<double(std::size_t apart, std::size_t row_j)>;
  NearField(const Material& material, const ExpandOptions& options, std::size_t rows,
            const Distances& distance, double ds, LineStore& known);

  /// Adds `factor` times the numbers of rows row_j <= row_i to a mix.
  void add_to(LineMix& to, int row_i, int row_j, double factor) const {
    const Mix& mix = mixes_[first_of_[static_cast<std::size_t>(row_i - row_j)] + row_j];
    for (int p = 0; p < mix.count; ++p)
      to.add(values_.data() + (mix.first + p) * 9 * offsets_,
             factor * mix.weight[static_cast<std::size_t>(p)]);
  }

  std::size_t lines() const { return lines_; }

private:
  static constexpr int most = 4;
  struct Mix { ///< of neighbouring lines
    std::size_t first = 0;
    int count = 0;
    std::array<double, most> weight{};
  };

  /// Adds the mixes of rows equally many rows apart, whose distances are given, and the lines they need.
  void add_mixes(std::span<const double> distances, double ds, std::vector<double>& at);
  /// Fills values_ with the lines at the distances `at`.
  void fill(const Material& material, const ExpandOptions& options, std::span<const double> at, double ds,
            LineStore& known);

  std::size_t lines_ = 0, offsets_ = 0;
  std::vector<double> values_;        ///< [line][i][j][offset]
  std::vector<Mix> mixes_;            ///< of the pairs, by distance in rows, then row_j
  std::vector<std::size_t> first_of_; ///< mix of each distance
};

} // namespace bem_contact::halfspace
