#include "bem_contact/profile/measured/profile_smoothing.hpp"

#include "bem_contact/profile/measured/settings.hpp"
#include "bem_contact/profile/measured/smoothing_spline.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace bem_contact {

namespace {

/// rad. Tangents on either side that differ by more make a kink. Noise of 10 um in points 0.25 mm apart,
/// fitted over 3 mm, turns them by 0.012.
constexpr double kink_turn = 0.2;
/// 1. Points on either side that such a tangent needs at least.
constexpr int kink_points = 5;
/// 1. Points nearer than this part of the wavelength become one: the spline through the rest keeps far
/// shorter waves than are asked for.
constexpr double thinning = 50;

std::vector<double> chord_lengths(std::span<const Point2> p) {
  std::vector<double> t(p.size(), 0.0);
  for (std::size_t i = 1; i < p.size(); ++i)
    t[i] = t[i - 1] + norm(p[i] - p[i - 1]);
  return t;
}

/// Neighbours within `width` become their mean; both ends stay.
std::vector<Point2> thinned(std::span<const Point2> p, double width) {
  std::vector<Point2> kept{p.front()};
  for (std::size_t i = 1; i + 1 < p.size();) {
    Point2 sum = p[i];
    std::size_t end = i + 1;
    for (; end + 1 < p.size() && norm(p[end] - p[i]) < width; ++end)
      sum = sum + p[end];
    kept.push_back((1.0 / static_cast<double>(end - i)) * sum);
    i = end;
  }
  kept.push_back(p.back());
  return kept;
}

/// Direction at t0 of the parabola through the points from..to, fitted over t.
double direction(std::span<const Point2> p, std::span<const double> t, std::size_t from, std::size_t to,
                 double t0) {
  const auto count = static_cast<Eigen::Index>(to - from + 1);
  const double scale = std::max(std::abs(t[to] - t0), std::abs(t[from] - t0));
  Eigen::MatrixXd powers(count, 3), position(count, 2);
  for (Eigen::Index i = 0; i < count; ++i) {
    const std::size_t k = from + static_cast<std::size_t>(i);
    const double u = (t[k] - t0) / scale;
    powers.row(i) << 1, u, u * u;
    position.row(i) << p[k].y, p[k].z;
  }
  const Eigen::MatrixXd fit = powers.colPivHouseholderQr().solve(position);
  return std::atan2(fit(1, 1), fit(1, 0));
}

/// Interior points at which the directions on both sides differ most, and by more than kink_turn.
std::vector<std::size_t> find_kinks(std::span<const Point2> p, double reach) {
  const std::vector<double> t = chord_lengths(p);
  const std::size_t n = p.size(), side = kink_points - 1;
  std::vector<double> turn(n, 0.0);
  for (std::size_t i = side; i + side < n; ++i) {
    std::size_t from = i - side, to = i + side;
    while (from > 0 && t[i] - t[from - 1] <= reach)
      --from;
    while (to + 1 < n && t[to + 1] - t[i] <= reach)
      ++to;
    turn[i] = std::abs(
        std::remainder(direction(p, t, i, to, t[i]) - direction(p, t, from, i, t[i]), 2 * std::numbers::pi));
  }
  std::vector<std::size_t> kinks;
  for (std::size_t i = 0; i < n; ++i) {
    const auto rival = [&](std::size_t k) { return std::abs(t[k] - t[i]) <= reach && turn[k] > turn[i]; };
    bool largest = turn[i] > kink_turn;
    for (std::size_t k = i; largest && k-- > 0 && t[i] - t[k] <= reach;)
      largest = !rival(k);
    for (std::size_t k = i + 1; largest && k < n && t[k] - t[i] <= reach; ++k)
      largest = !rival(k);
    if (largest)
      kinks.push_back(i);
  }
  return kinks;
}

/// The points of one part between kinks; one that is too short to have a third derivative stays. An end that
/// is a kink is held by a weight, because both parts end there.
std::vector<Point2> smooth_part(std::span<const Point2> p, double wavelength, bool held_first,
                                bool held_last) {
  if (p.size() < 5)
    return {p.begin(), p.end()};
  Eigen::MatrixXd measured(p.size(), 2);
  for (std::size_t i = 0; i < p.size(); ++i)
    measured.row(static_cast<Eigen::Index>(i)) << p[i].y, p[i].z;
  SmoothingSpline spline(chord_lengths(p), std::move(measured));
  if (held_first)
    spline.hold(0);
  if (held_last)
    spline.hold(static_cast<Eigen::Index>(p.size()) - 1);
  const Eigen::MatrixXd found =
      spline.minimise(Eigen::VectorXd::Constant(spline.third_derivatives(), wavelength), highest_wave);
  std::vector<Point2> out;
  for (Eigen::Index i = 0; i < found.rows(); ++i)
    out.push_back({found(i, 0), found(i, 1)});
  if (held_first)
    out.front() = p.front();
  if (held_last)
    out.back() = p.back();
  return out;
}

} // namespace

SmoothedProfile smoothed(std::span<const Point2> points, double wavelength) {
  const std::vector<Point2> before = thinned(points, wavelength / thinning);
  SmoothedProfile out;
  out.kinks = find_kinks(before, wavelength / 4);
  std::vector<std::size_t> ends = out.kinks;
  ends.push_back(before.size() - 1);
  std::size_t begin = 0;
  for (const std::size_t end : ends) {
    const auto part = smooth_part(std::span(before).subspan(begin, end + 1 - begin), wavelength, begin > 0,
                                  end + 1 < before.size());
    out.points.insert(out.points.end(), part.begin() + (begin > 0 ? 1 : 0), part.end());
    begin = end;
  }
  double sum = 0;
  for (std::size_t i = 0; i < before.size(); ++i) {
    const double moved = norm(out.points[i] - before[i]);
    out.largest = std::max(out.largest, moved);
    sum += moved * moved;
  }
  out.rms = std::sqrt(sum / static_cast<double>(before.size()));
  return out;
}

} // namespace bem_contact
