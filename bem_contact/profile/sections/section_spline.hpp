#pragma once

#include <vector>

namespace bem_contact {

/// Slopes of the cubic splines that go through values at the same places: "not a knot" at both ends (de Boor
/// 1978, chapter IV), a parabola through three, a straight line through two. Each costs as much as it has
/// places.
class SectionSpline {
public:
  /// Two places or more, rising.
  explicit SectionSpline(const std::vector<double>& places);

  /// One slope for each of the values: numbers, points.
  template <class Value> std::vector<Value> slopes(const std::vector<Value>& values) const {
    const std::size_t n = values.size();
    std::vector<Value> secants, out;
    for (std::size_t i = 0; i + 1 < n; ++i)
      secants.push_back((1 / length_[i]) * (values[i + 1] - values[i]));
    if (n == 2)
      return {secants[0], secants[0]};
    for (std::size_t i = 0; i < n; ++i) {
      const Row& row = rows_[i];
      const std::size_t k = i == 0 ? 0 : i + 1 == n ? n - 3 : i - 1;
      const Value right = row.first * secants[k] + row.second * secants[k + 1];
      out.push_back(row.scale * (i == 0 ? right : right - row.before * out[i - 1]));
    }
    for (std::size_t i = n - 1; i-- > 0;)
      out[i] = out[i] - rows_[i].after * out[i + 1];
    return out;
  }

private:
  /// One equation, as it is eliminated: the slope before counts `before`, right of it stand `first` and
  /// `second` of two secants, the sum is scaled, and the slope behind counts `after`.
  struct Row {
    double before = 0, first = 0, second = 0, scale = 1, after = 0;
  };
  std::vector<double> length_;
  std::vector<Row> rows_;
};

} // namespace bem_contact
