#include "bem_contact/influence/series_points.hpp"

#include "bem_contact/influence/harmonic_points.hpp"
#include "bem_contact/influence/settings.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace bem_contact {

namespace {

/// Sets of points that are kept: two files, on a few sizes of grids. A set has about 100 kB. Chosen.
constexpr std::size_t series_points_kept = 16;
/// 1 (share of a wavenumber). A harmonic that is beyond the last sample by less is not beyond it: rounding.
constexpr double last_sample_slack = 1e-12;
/// 1 (share of a wavenumber). A harmonic this near to a sample is that sample: rounding.
constexpr double sample_snap = 1e-10;

constexpr std::size_t neighbours = 6; ///< of the interpolation between samples

struct Interpolation {
  std::size_t first = 0, count = 0;
  std::array<double, neighbours> weight{};
};

/// g(k) from the samples: Lagrange on k g(k) in log k over the (up to) six samples around k, 0 left out.
class Interpolator {
public:
  explicit Interpolator(std::span<const double> wavenumber) : wavenumber_(wavenumber) {
    logarithm_.push_back(0); // of the sample k = 0: not used
    for (const double k : wavenumber.subspan(1))
      logarithm_.push_back(std::log(k));
  }

  /// `above`: index of the first sample beyond k.
  Interpolation at(double k, std::size_t above) const {
    const std::size_t positive = wavenumber_.size() - 1;
    Interpolation result;
    result.count = std::min(neighbours, positive);
    const std::size_t half = result.count / 2;
    result.first = std::clamp<std::size_t>(above > half ? above - half : 1, 1, positive - result.count + 1);
    const double log_k = std::log(k);
    for (std::size_t a = 0; a < result.count; ++a) {
      const double own = logarithm_[result.first + a];
      double above_line = wavenumber_[result.first + a], below_line = k;
      for (std::size_t b = 0; b < result.count; ++b)
        if (b != a) {
          above_line *= log_k - logarithm_[result.first + b];
          below_line *= own - logarithm_[result.first + b];
        }
      result.weight[a] = above_line / below_line;
    }
    return result;
  }

private:
  std::span<const double> wavenumber_;
  std::vector<double> logarithm_;
};

TailSeries tail_of(std::span<const double> wavenumber, double step) {
  // the last harmonic that is not beyond the last sample
  const auto inside = static_cast<long>(std::floor(wavenumber.back() / step * (1 + last_sample_slack)));
  return {inside + 1, std::max(inside + 1, static_cast<long>(tail_reach * wavenumber.back() / step)), step};
}

} // namespace

SeriesPoints::SeriesPoints(std::span<const double> wavenumber, double half_period, double largest_angle)
    : wavenumber_(wavenumber.begin(), wavenumber.end()), half_period_(half_period),
      largest_angle_(largest_angle), tail_(tail_of(wavenumber, std::numbers::pi / half_period)) {
  const Interpolator interpolator(wavenumber_);
  const double step = std::numbers::pi / half_period;
  const auto add_between = [&](long first, long last, std::size_t above) { // `above`: the upper sample
    const HarmonicPoints harmonics = harmonic_points(first, last, largest_angle);
    const std::size_t count = harmonics.position.size();
    Run run;
    for (std::size_t p = 0; p < count; ++p) {
      run.k.push_back(step * harmonics.position[p]);
      const Interpolation samples = interpolator.at(run.k[p], above);
      run.first = samples.first; // the same for all: they lie between the same two samples
      run.weight.resize(samples.count * count);
      for (std::size_t b = 0; b < samples.count; ++b)
        run.weight[b * count + p] = harmonics.weight[p] * samples.weight[b];
    }
    runs_.push_back(std::move(run));
  };
  long next = 1; // harmonic
  for (std::size_t above = 1; above < wavenumber_.size(); ++above) {
    const double sample = wavenumber_[above] / step;
    const long nearest = std::lround(sample);
    const bool is_sample = std::abs(static_cast<double>(nearest) - sample) <= sample_snap * sample;
    const long last = is_sample ? nearest - 1 : static_cast<long>(std::floor(sample));
    if (last >= next)
      add_between(next, last, above);
    if (is_sample)
      runs_.push_back({above, {step * static_cast<double>(nearest)}, {1}});
    next = std::max(next, (is_sample ? nearest : last) + 1);
  }
}

const SeriesPoints& SeriesStore::get(std::span<const double> wavenumber, double half_period, double angle) {
  const double bound = std::exp2(std::ceil(angles_per_octave * std::log2(angle)) / angles_per_octave);
  const auto serves = [&](const SeriesPoints& points) {
    return points.largest_angle() == bound && points.half_period() == half_period &&
           std::ranges::equal(points.wavenumber(), wavenumber);
  };
  if (const auto found = std::ranges::find_if(kept_, serves); found != kept_.end())
    return *found;
  if (kept_.size() >= series_points_kept)
    kept_.erase(kept_.begin());
  return kept_.emplace_back(wavenumber, half_period, bound);
}

} // namespace bem_contact
