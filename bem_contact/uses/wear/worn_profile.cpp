#include "bem_contact/uses/wear/worn_profile.hpp"

#include "bem_contact/base/output_file.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <iterator>
#include <numeric>
#include <ostream>
#include <utility>

namespace bem_contact::wear {

namespace {

/// mm. Distance of the points of a profile that wears: a contact 1.2 mm wide, on a flange, still has twelve.
constexpr double profile_spacing = 0.1;
/// 1 (wavelength). Spacing of the knots of the cubic B-spline that spreads the wear of a row: it keeps half
/// of a wave of three times its spacing, (sin(pi/3) / (pi/3))^4 = 0.47.
constexpr double knots_per_wavelength = 3.0;

/// Integral from -infinity to t of the cubic B-spline with knots -2, -1, 0, 1, 2.
double b_spline_until(double t) {
  if (t < 0)
    return 1 - b_spline_until(-t);
  if (t >= 2)
    return 1;
  return t >= 1 ? 1 - std::pow(2 - t, 4) / 24 : 0.5 + t * (2.0 / 3 - t * t * (1.0 / 3 - t / 8));
}

/// Half the distances to both neighbours, mm.
std::vector<double> lengths(std::span<const Point2> points) {
  std::vector<double> out(points.size(), 0.0);
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const double half = norm(points[i + 1] - points[i]) / 2;
    out[i] += half;
    out[i + 1] += half;
  }
  return out;
}

} // namespace

double WornBody::largest() const {
  return depth.empty() ? 0 : *std::ranges::max_element(depth);
}

std::vector<Point2> points_of(const ProfileCurve& curve) {
  const double length = curve.s_end() - curve.s_begin();
  const int steps = std::max(2, static_cast<int>(std::ceil(length / profile_spacing)));
  std::vector<Point2> out;
  for (int i = 0; i <= steps; ++i)
    out.push_back(curve.at(curve.s_begin() + length * i / steps).position);
  return out;
}

Depths::Depths(std::span<const Point2> points)
    : s_(ProfileCurve::through_points("worn", points).joints()), length_(lengths(points)),
      depth_(points.size(), 0.0) {}

void Depths::add(const DepthOverS& wear, double weight, double smoothing) {
  const double half = wear.width / 2;
  const double knots = std::max(smoothing / knots_per_wavelength, double(profile_spacing));
  for (std::size_t row = 0; row < wear.s.size(); ++row) {
    if (wear.depth[row] == 0)
      continue;
    const double s = std::clamp(wear.s[row], s_.front(), s_.back());
    const std::size_t first = std::ranges::upper_bound(s_, s - half - 2 * knots) - s_.begin(),
                      last = std::ranges::lower_bound(s_, s + half + 2 * knots) - s_.begin();
    const auto share = [&](std::size_t i) {
      return b_spline_until((s_[i] - s + half) / knots) - b_spline_until((s_[i] - s - half) / knots);
    };
    double sum = 0;
    for (std::size_t i = first; i < last; ++i)
      sum += share(i) * length_[i];
    for (std::size_t i = first; i < last; ++i)
      depth_[i] += weight * wear.depth[row] * wear.width * share(i) / sum;
  }
  Contact contact;
  for (std::size_t row = 0; row < wear.s.size(); ++row)
    contact.rows.push_back({wear.s[row], weight * wear.depth[row]});
  std::ranges::sort(contact.rows);
  contacts_.push_back(std::move(contact));
}

double Depths::Contact::at(double s) const {
  const auto above = std::ranges::lower_bound(rows, s, {}, &std::pair<double, double>::first);
  if (above == rows.end() || (above == rows.begin() && above->first > s))
    return 0;
  if (above->first == s)
    return above->second;
  const auto below = std::prev(above);
  return std::lerp(below->second, above->second, (s - below->first) / (above->first - below->first));
}

double Depths::smoothed_off() const {
  double deepest = 0;
  for (const Contact& contact : contacts_)
    for (const auto& [s, own] : contact.rows) {
      double depth = 0;
      for (const Contact& other : contacts_)
        depth += other.at(s);
      deepest = std::max(deepest, depth);
    }
  return deepest > 0 ? std::max(0.0, 1 - largest() / deepest) : 0.0;
}

double Depths::largest() const {
  return *std::ranges::max_element(depth_);
}

double Depths::area() const {
  return std::inner_product(depth_.begin(), depth_.end(), length_.begin(), 0.0);
}

std::vector<Point2> worn(std::span<const Point2> points, const std::vector<double>& depth, double area) {
  std::vector<Point2> out(points.begin(), points.end());
  if (!(area > 0))
    return out;
  const ProfileCurve curve = ProfileCurve::through_points("worn", points);
  const std::vector<double> s = curve.joints(); // of the points
  std::vector<Point2> move(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    if (depth[i] > 0)
      move[i] = depth[i] * normal_of(curve.at(s[i]).delta);
  double linear = 0, square = 0; // of the area under the moves times a factor
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const Point2 edge = points[i + 1] - points[i];
    linear += (cross(edge, move[i]) + cross(edge, move[i + 1])) / 2;
    square += cross(move[i + 1], move[i]) / 2;
  }
  const double factor = 2 * area / (linear + std::sqrt(linear * linear + 4 * square * area));
  for (std::size_t i = 0; i < points.size(); ++i)
    out[i] = points[i] + factor * move[i];
  return out;
}

void write_profile(const std::filesystem::path& file, std::span<const Point2> points) {
  write_whole(file, [&](std::ostream& out) {
    for (const Point2& p : points)
      out << fmt::format("{:.12f} {:.12f}\n", p.y, p.z);
  });
}

} // namespace bem_contact::wear
