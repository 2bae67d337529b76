#pragma once

#include "bem_contact/influence/series_tail.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace bem_contact {

/// The points of all harmonics of the period up to the last sample, for angles up to `largest_angle`, rad.
/// Harmonics that are samples count for themselves; between samples k g(k) is 6-point Lagrange in log k. All
/// that does not depend on the elements, so that it serves every size of them.
class SeriesPoints {
public:
  /// `wavenumber`: ascending, the first is 0, at least 3; 1/mm. Period 2 half_period, mm.
  SeriesPoints(std::span<const double> wavenumber, double half_period, double largest_angle);

  /// Points between two samples: a function of k counts for the samples first, first + 1, ...
  struct Run {
    std::size_t first = 0;
    std::vector<double> k;      ///< 1/mm
    std::vector<double> weight; ///< [sample][point]
  };
  const std::vector<Run>& runs() const { return runs_; }
  /// Harmonics beyond the last sample, up to tail_reach times it.
  const TailSeries& tail() const { return tail_; }
  std::span<const double> wavenumber() const { return wavenumber_; }
  double half_period() const { return half_period_; }
  double largest_angle() const { return largest_angle_; }

private:
  std::vector<double> wavenumber_;
  double half_period_, largest_angle_;
  std::vector<Run> runs_;
  TailSeries tail_;
};

/// The points met last. What is kept changes numbers by rounding alone. It serves one thread at a time.
class SeriesStore {
public:
  /// Returns points for angles up to `angle` at least. They are valid until the next call.
  const SeriesPoints& get(std::span<const double> wavenumber, double half_period, double angle);

private:
  std::vector<SeriesPoints> kept_;
};

} // namespace bem_contact
