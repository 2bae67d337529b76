#include "bem_contact/halfspace/stations_near_field.hpp"

#include <cmath>

namespace bem_contact::halfspace {

StationsNearField::StationsNearField(const Material& material, const ExpandOptions& options,
                                     std::span<const RowWeights> rows, double width) {
  most_ = std::abs(rows.back().first - rows.front().first) + 3;
  std::vector<double> station_s;
  for (int d = 0; d <= most_; ++d)
    station_s.push_back(d * width);
  const NearField near(material, options, station_s, width);
  lines_.resize(static_cast<std::size_t>(options.offsets * (2 * most_ + 1)));
  for (int m = 0; m < options.offsets; ++m)
    for (int d = 0; d <= most_; ++d) {
      std::array<double, 9> ahead{};
      near.add(m, d, 0, 1, ahead.data());
      lines_[index(m, d)] = ahead;
      for (std::size_t e = 0; e < 9 && d > 0; ++e) // load and sample change places
        lines_[index(m, -d)][e] =
            parity(static_cast<int>(e / 3), static_cast<int>(e % 3)) * ahead[e % 3 * 3 + e / 3];
    }
  for (const RowWeights& row_i : rows)
    for (const RowWeights& row_j : rows.first(static_cast<std::size_t>(&row_i - rows.data()) + 1)) {
      Mix mix{row_i.first - row_j.first - 3, {}};
      for (int p = 0; p < row_i.count; ++p)
        for (int q = 0; q < row_j.count; ++q)
          mix.weight[static_cast<std::size_t>(p - q + 3)] +=
              row_i.weight[static_cast<std::size_t>(p)] * row_j.weight[static_cast<std::size_t>(q)];
      mixes_.push_back(mix);
    }
}

void StationsNearField::take(int m, std::size_t pair, double factor, std::array<double, 9>& block) const {
  const Mix& mix = mixes_[pair];
  for (int a = 0; a < 7; ++a)
    if (const double weight = factor * mix.weight[static_cast<std::size_t>(a)]; weight != 0) {
      const std::array<double, 9>& from = lines_[index(m, mix.first + a)];
      for (std::size_t e = 0; e < 9; ++e)
        block[e] -= weight * from[e];
    }
}

} // namespace bem_contact::halfspace
