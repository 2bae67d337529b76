#include "bem_contact/inside/kernel_sums.hpp"

#include "bem_contact/base/lagrange.hpp"
#include "bem_contact/influence/dense.hpp"
#include "bem_contact/inside/waves.hpp"

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace bem_contact::inside {

namespace {

using halfspace::Stress;

/// 1. Neighbours between which is interpolated: of the wavenumbers, and of places and depths.
constexpr std::size_t wave_neighbours = 6, point_neighbours = 4;
/// 1 (of a place's or a depth's distance). So far beyond the last one counts as on it.
constexpr double beyond_last = 1e-9;

/// Lagrange's weights of some rising values about one.
struct Neighbours {
  std::size_t first = 0;
  std::vector<double> weights;

  Neighbours(std::span<const double> values, double at, std::size_t count) {
    count = std::min(count, values.size());
    const auto above = static_cast<std::size_t>(std::ranges::upper_bound(values, at) - values.begin());
    first = std::min(above > count / 2 ? above - count / 2 : 0, values.size() - count);
    weights.resize(count);
    lagrange_weights(values.subspan(first, count), at, weights);
  }
};

std::vector<double> logarithms(std::span<const double> values) {
  std::vector<double> out;
  for (const double value : values)
    out.push_back(std::log(value));
  return out;
}

bool all_there(const StressKernel& kernel, const Neighbours& places, const Neighbours& depths) {
  for (std::size_t p = 0; p < places.weights.size(); ++p)
    for (std::size_t d = 0; d < depths.weights.size(); ++d)
      if (!kernel.there[(places.first + p) * kernel.depths.size() + depths.first + d])
        return false;
  return true;
}

} // namespace

ContactRow surface_at(const StressKernel& kernel, double s) {
  const double step = kernel.places[1].s - kernel.places[0].s, at = (s - kernel.places[0].s) / step;
  const auto last = static_cast<double>(kernel.places.size() - 2);
  const auto i = static_cast<std::size_t>(std::clamp(std::floor(at), 0.0, last));
  const ContactRow &a = kernel.places[i], &b = kernel.places[i + 1];
  const double part = at - static_cast<double>(i);
  return {s, a.position + part * (b.position - a.position),
          a.delta + std::clamp(part, 0.0, 1.0) * (b.delta - a.delta)};
}

KernelPoint::KernelPoint(const StressKernel& kernel, std::span<const double> s,
                         std::span<const double> log_depths, const BelowSurface& at) {
  const double close = beyond_last * (s.back() - s.front());
  if (at.s < s.front() - close || at.s > s.back() + close ||
      at.depth < kernel.depths.front() * (1 - beyond_last) ||
      at.depth > kernel.depths.back() * (1 + beyond_last))
    return;
  for (const std::size_t count : {point_neighbours, std::size_t{2}}) { // fewer near the body's side
    const Neighbours places(s, at.s, count), depths(log_depths, std::log(at.depth), count);
    if (!all_there(kernel, places, depths))
      continue;
    place = places.first;
    depth = depths.first;
    of_place = places.weights;
    of_depth = depths.weights;
    return;
  }
}

KernelSums::KernelSums(const InfluenceStrip& strip, const StressKernel& kernel,
                       const SurfaceTractions& tractions)
    : strip_(strip), kernel_(kernel), tractions_(tractions) {
  int first = tractions.rows(), last = -1;
  for (std::size_t i = 0; i < tractions.pn.size(); ++i)
    if (tractions.at(i) != std::array<double, 3>{}) {
      first = std::min(first, static_cast<int>(i) / tractions.columns);
      last = std::max(last, static_cast<int>(i) / tractions.columns);
    }
  loaded_ = {first, std::max(0, last - first + 1)};
}

namespace {

/// What each of a form's wavenumbers stands for: amplitudes of the loads times how stresses vary along x,
/// [3 loaded stations + component][places as even, then as odd], summed over the waves about it.
class WaveLoads {
public:
  WaveLoads(const InfluenceStrip& strip, std::span<const double> wavenumber, StationRange loaded,
            std::size_t places)
      : strip_(strip), wavenumber_(wavenumber), log_(logarithms(wavenumber.subspan(1))), loaded_(loaded),
        sums_(wavenumber.size(),
              Eigen::MatrixXd::Zero(3 * loaded.count, static_cast<Eigen::Index>(2 * places))) {}

  void add(const Wavenumber& wave, const SurfaceTractions& tractions, std::span<const double> x, double rho) {
    Eigen::MatrixXd loads(3 * loaded_.count, 2), places(2, sums_.front().cols());
    for (int J = 0; J < loaded_.count; ++J) {
      const auto station = static_cast<std::size_t>(loaded_.first + J);
      const double rho_J = relative_radius(strip_.reference_radius, strip_.stations[station].position.z);
      const WaveOfRow row(tractions, station, wave.k / rho_J);
      for (int c = 0; c < 3; ++c)
        for (int i = 0; i < 2; ++i)
          loads(3 * J + c, i) = row.amplitudes(static_cast<std::size_t>(c))[static_cast<std::size_t>(i)];
    }
    const auto count = static_cast<Eigen::Index>(x.size());
    for (Eigen::Index j = 0; j < count; ++j)
      for (int i = 0; i < 2; ++i) {
        const WaveAt at(wave.k * x[static_cast<std::size_t>(j)] / rho, i == 1);
        places(i, j) = wave.weight * at.even;
        places(i, count + j) = wave.weight * at.odd;
      }
    const Eigen::MatrixXd product = loads * places;
    for_each_sample(wave.k, [&](std::size_t sample, double weight) { sums_[sample] += weight * product; });
  }
  const std::vector<Eigen::MatrixXd>& sums() const { return sums_; } ///< [wavenumber]

private:
  /// The lowest waves are samples; between the others a smooth function of log k.
  template <class Use> void for_each_sample(double k, Use&& use) const {
    for (std::size_t i = 0; i < wavenumber_.size(); ++i)
      if (std::abs(k - wavenumber_[i]) <= 1e-9 * k)
        return use(i, 1.0);
    const Neighbours near(log_, std::log(k), wave_neighbours);
    for (std::size_t i = 0; i < near.weights.size(); ++i)
      use(1 + near.first + i, near.weights[i]);
  }

  const InfluenceStrip& strip_;
  std::span<const double> wavenumber_;
  std::vector<double> log_; ///< of all but the first
  StationRange loaded_;
  std::vector<Eigen::MatrixXd> sums_;
};

using Floats = Eigen::Map<const Eigen::MatrixXf>;
using FloatsByRow = Eigen::Map<const Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>;

/// The products of one depth for some places: [6 place + component][as even, then as odd].
Eigen::MatrixXd product_at(const StressForm& form, std::size_t depth, StationRange places,
                           StationRange loaded, const std::vector<Eigen::MatrixXd>& loads) {
  const StressForm::Place at = form.place_of(depth);
  const Eigen::Index left_rank = form.left_rank[depth], right_rank = form.right_rank[depth];
  const Eigen::Index left_rows = static_cast<Eigen::Index>(form.left.size() / form.left_columns()),
                     right_rows = static_cast<Eigen::Index>(form.right.size() / form.right_columns());
  const Floats left(&form.left[at.left * static_cast<std::size_t>(left_rows)], left_rows, left_rank),
      right(&form.right[at.right * static_cast<std::size_t>(right_rows)], right_rows, right_rank);
  const Eigen::MatrixXd near_loads = right.middleRows(3 * loaded.first, 3 * loaded.count).cast<double>(),
                        near_places = left.middleRows(6 * places.first, 6 * places.count).cast<double>();
  Eigen::MatrixXd part(right_rank, loads.front().cols()), felt(left_rank, part.cols()),
      sum = Eigen::MatrixXd::Zero(left_rank, part.cols());
  for (std::size_t k = 0; k < form.wavenumber.size(); ++k) {
    const Eigen::MatrixXd core =
        FloatsByRow(&form.core[k * form.core_size() + at.core], left_rank, right_rank).cast<double>();
    dense_product_of_columns(near_loads, loads[k], part.data());
    dense_product(core, part, felt.data());
    sum += felt;
  }
  Eigen::MatrixXd out(near_places.rows(), part.cols());
  dense_product(near_places, sum, out.data());
  return out;
}

Stress stress_of(const Eigen::MatrixXd& field, Eigen::Index row, Eigen::Index place, Eigen::Index places) {
  return {field(row, place),
          field(row + 1, place),
          field(row + 2, place),
          field(row + 3, places + place),
          field(row + 4, places + place),
          field(row + 5, place)};
}

} // namespace

std::vector<Passage> KernelSums::sums(const StressForm& form, std::span<const KernelPoint> points,
                                      std::span<const double> x, double rho) const {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  std::vector<Passage> out;
  std::size_t first = kernel_.places.size(), last = 0;
  std::vector<char> wanted(kernel_.depths.size(), 0);
  for (const KernelPoint& p : points) {
    out.emplace_back(x.size(), p.is_there() ? Stress{} : Stress{none, none, none, none, none, none});
    if (!p.is_there())
      continue;
    first = std::min(first, p.place);
    last = std::max(last, p.place + p.of_place.size());
    for (std::size_t d = 0; d < p.of_depth.size(); ++d)
      wanted[p.depth + d] = 1;
  }
  if (last == 0 || loaded_.count == 0)
    return out;
  double reach = 0;
  for (const double at : x)
    reach = std::max(reach, std::abs(at));
  reach += reach_of(tractions_);
  WaveLoads loads(strip_, form.wavenumber, loaded_, x.size());
  for (const Wavenumber& wave : waves_of_series(strip_.half_period, form.wavenumber.back(), reach))
    loads.add(wave, tractions_, x, rho);
  const auto places = static_cast<Eigen::Index>(x.size());
  for (std::size_t depth = 0; depth < wanted.size(); ++depth) {
    if (!wanted[depth])
      continue;
    const Eigen::MatrixXd field = product_at(
        form, depth, {static_cast<int>(first), static_cast<int>(last - first)}, loaded_, loads.sums());
    for (std::size_t i = 0; i < points.size(); ++i) {
      const KernelPoint& p = points[i];
      if (!p.is_there() || depth < p.depth || depth >= p.depth + p.of_depth.size())
        continue;
      for (std::size_t n = 0; n < p.of_place.size(); ++n)
        for (Eigen::Index j = 0; j < places; ++j)
          out[i][static_cast<std::size_t>(j)].add(
              p.of_depth[depth - p.depth] * p.of_place[n],
              stress_of(field, static_cast<Eigen::Index>(6 * (p.place + n - first)), j, places));
    }
  }
  return out;
}

ProbedRemainder KernelSums::at(std::span<const BelowSurface> points, std::span<const double> x) const {
  std::vector<KernelPoint> at;
  std::vector<double> s;
  for (const ContactRow& place : kernel_.places)
    s.push_back(place.s);
  const std::vector<double> log_depths = logarithms(kernel_.depths);
  double rho = 0;
  for (const BelowSurface& p : points) {
    at.emplace_back(kernel_, s, log_depths, p);
    rho += relative_radius(strip_.reference_radius, surface_at(kernel_, p.s).position.z) /
           static_cast<double>(points.size());
  }
  ProbedRemainder out{sums(kernel_.remainder, at, x, rho), std::vector<double>(points.size(), 0)};
  if (kernel_.error.wavenumber.empty())
    return out;
  const std::vector<Passage> error = sums(kernel_.error, at, x, rho);
  for (std::size_t i = 0; i < error.size(); ++i)
    for (const Stress& t : error[i])
      if (at[i].is_there())
        out.error[i] = std::max(out.error[i], von_mises(t));
  return out;
}

} // namespace bem_contact::inside
