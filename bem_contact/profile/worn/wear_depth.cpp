#include "bem_contact/profile/worn/wear_depth.hpp"

#include "bem_contact/profile/measured/smoothing_spline.hpp"

#include <algorithm>
#include <cmath>

namespace bem_contact {

namespace {

/// mm. Exact points scatter by their rounding.
constexpr double least_depth_scatter = 1e-6;
/// mm. Waves of the depth shorter than this are removed where the points tell of none: half of the running
/// surface. Noise of 10 um then moves the conformal corner of S1002 on 60E1 by less than 1 %.
constexpr double longest_depth_wave = 50.0;
/// 1 (median distances of points). Shorter waves are not looked for: a wave needs so many points.
constexpr double shortest_depth_wave = 8.0;
/// 1. Where it must be, the wavelength is shortened by this factor at a time, and once more at the end.
/// Without that, 23 % of the contacts of tools/benchmarks/profile_noise (both, rolled: 10 um, 20 draws) were
/// off by 3 %, with it 11 %.
constexpr double depth_wave_step = 0.8;
/// mm. and so far beyond the stretch on which it must be. Six times as much gives nearly the same.
constexpr double depth_wave_reach = 2.0;
/// 1 (points). The shortest stretch on which what is removed is compared with noise.
constexpr std::size_t shortest_stretch = 4;
/// 1 (share of the wavelength there). Shorter stretches are not looked at: what smoothing takes of the shape
/// changes its sign after about this length, and a chance run of a few points is no shape.
constexpr double stretch_share = 0.25;

SmoothingSpline spline_of(std::span<const double> s, std::span<const double> depth) {
  return {s, Eigen::Map<const Eigen::VectorXd>(depth.data(), static_cast<Eigen::Index>(depth.size()))};
}

SmoothDepth smooth(const SmoothingSpline& spline, std::span<const double> s,
                   const Eigen::VectorXd& wavelength) {
  const Eigen::MatrixXd found = spline.minimise(wavelength);
  SmoothDepth out{{found.data(), found.data() + found.size()}, {}};
  Eigen::Index nearest = 0;
  for (const double at : s) {
    while (nearest + 1 < wavelength.size() && spline.middle(nearest) < at)
      ++nearest;
    out.wavelength.push_back(wavelength[nearest]);
  }
  return out;
}

/// Which points lie on a stretch whose removed parts do not look like noise, at least half as little as on
/// the worst: what is removed at an edge spreads, and goes when the edge is kept.
std::vector<bool> too_much_removed(std::span<const double> s, const SmoothDepth& smooth,
                                   std::span<const double> removed, double scatter) {
  const std::size_t n = removed.size();
  std::vector<double> sum(n + 1, 0.0);
  for (std::size_t i = 0; i < n; ++i)
    sum[i + 1] = sum[i] + removed[i];
  // A stretch of n points: over the deviation that noise makes of their sum.
  const auto excess = [&](std::size_t from, std::size_t length) {
    return std::abs(sum[from + length] - sum[from]) / (scatter * std::sqrt(static_cast<double>(length)));
  };
  const auto each_stretch = [&](const auto& look) {
    for (std::size_t length = shortest_stretch; length <= n; length += length / 2)
      for (std::size_t from = 0; from + length <= n; from += length / 4)
        if (s[from + length - 1] - s[from] >= stretch_share * smooth.wavelength[from + length / 2])
          look(from, length);
  };
  double limit = 0;
  each_stretch([&](auto from, auto length) { limit = std::max(limit, excess(from, length) / 2); });
  limit = std::max(limit, std::sqrt(2 * std::log(static_cast<double>(n))));
  std::vector<bool> marked(n, false);
  each_stretch([&](auto from, auto length) {
    if (excess(from, length) > limit)
      std::fill_n(marked.begin() + static_cast<std::ptrdiff_t>(from), length, true);
  });
  return marked;
}

/// Shortens the wavelength at the third derivatives within `depth_wave_reach` of a marked point. False if
/// none could be shortened.
bool shorten(Eigen::VectorXd& wavelength, const SmoothingSpline& spline, std::span<const double> s,
             const std::vector<bool>& marked, double shortest) {
  bool changed = false;
  std::size_t from = 0;
  for (Eigen::Index i = 0; i < wavelength.size(); ++i) {
    while (s[from] < spline.middle(i) - depth_wave_reach)
      ++from;
    bool near = false;
    for (std::size_t k = from; !near && k < s.size() && s[k] <= spline.middle(i) + depth_wave_reach; ++k)
      near = marked[k];
    if (near && wavelength[i] > shortest) {
      wavelength[i] = std::max(shortest, depth_wave_step * wavelength[i]);
      changed = true;
    }
  }
  return changed;
}

} // namespace

SmoothDepth smoothed_depth(std::span<const double> s, std::span<const double> depth, double given) {
  const SmoothingSpline spline = spline_of(s, depth);
  return smooth(spline, s, Eigen::VectorXd::Constant(spline.third_derivatives(), given));
}

SmoothDepth smoothed_depth_by_noise(std::span<const double> s, std::span<const double> depth, double scatter,
                                    double spacing) {
  const SmoothingSpline spline = spline_of(s, depth);
  const double shortest = std::min(longest_depth_wave, shortest_depth_wave * spacing);
  Eigen::VectorXd wavelength = Eigen::VectorXd::Constant(spline.third_derivatives(), longest_depth_wave);
  for (;;) {
    const SmoothDepth out = smooth(spline, s, wavelength);
    std::vector<double> removed(depth.begin(), depth.end());
    for (std::size_t i = 0; i < removed.size(); ++i)
      removed[i] -= out.depth[i];
    const std::vector<bool> marked =
        too_much_removed(s, out, removed, std::max(scatter, least_depth_scatter));
    if (std::ranges::find(marked, true) == marked.end() || !shorten(wavelength, spline, s, marked, shortest))
      break;
  }
  // What is removed just looks like noise there: shape of the same size may be hidden in it.
  const auto shortened = wavelength.array() < longest_depth_wave;
  wavelength = shortened.select(depth_wave_step * wavelength.array(), wavelength.array()).matrix().eval();
  return smooth(spline, s, wavelength);
}

} // namespace bem_contact
