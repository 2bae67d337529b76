#include "bem_contact/inside/section.hpp"

#include "bem_contact/influence/dense.hpp"
#include "bem_contact/inside/settings.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

namespace bem_contact::inside {

namespace {

/// 1 (smaller half width of the patch). Knots of residual stresses below the surface: dense where limits are
/// decided, 0.3 to 0.5 deep.
constexpr double depths_of_knots[] = {0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.8, 1, 1.3, 1.7, 2.3, 3.5};
/// 1. Places of points between two knots.
constexpr double places_between_knots[] = {0.25, 0.75};
/// 1. Points for each interval between knots, along s.
constexpr int points_between_knots = 2;
/// 1. Each interval beside the patch is longer than the one before by this.
constexpr double growth_beside = 1.4;
/// 1 (element's smaller side). Depth at which stresses of the surface are taken: near enough that they differ
/// by rounding alone, since stresses are smooth in the middle of an element.
constexpr double depth_of_surface = 1e-6;

struct Range {
  int from = 0, to = 0; ///< first and last

  int count() const { return to - from + 1; }
  /// Steps that leave about so many.
  int stride(int points) const {
    return std::max(1, static_cast<int>(std::lround(double(count()) / points)));
  }
};

/// Steps beside the patch that grow, until they reach `far` mm; each a multiple of `unit` mm.
std::vector<double> steps_beside(double first, double far, double unit) {
  std::vector<double> out;
  double at = 0, step = first;
  while (at < far) {
    at += std::max(1.0, std::round(step / unit)) * unit;
    out.push_back(at);
    step *= growth_beside;
  }
  return out;
}

/// Adds `beside` on both ends of a rising row.
std::vector<double> with_sides(std::vector<double> middle, const std::vector<double>& beside) {
  std::vector<double> out;
  for (auto it = beside.rbegin(); it != beside.rend(); ++it)
    out.push_back(middle.front() - *it);
  out.insert(out.end(), middle.begin(), middle.end());
  for (const double step : beside)
    out.push_back(middle.back() + step);
  return out;
}

} // namespace

std::vector<BelowSurface> Section::points() const {
  std::vector<BelowSurface> out;
  for (const double at : s)
    for (const double depth : depths)
      out.push_back({at, depth});
  return out;
}

namespace {

struct Extent {
  Range rows, columns;

  Extent(const SurfaceTractions& t, std::span<const int> elements)
      : rows{t.rows(), -1}, columns{t.columns, -1} {
    for (const int i : elements) {
      rows = {std::min(rows.from, i / t.columns), std::max(rows.to, i / t.columns)};
      columns = {std::min(columns.from, i % t.columns), std::max(columns.to, i % t.columns)};
    }
  }
  /// Smaller half width, mm.
  double size(const SurfaceTractions& t) const {
    return 0.5 * std::min(rows.count() * t.ds, columns.count() * t.dx);
  }
};

/// Ahead of the patch and behind it stresses change less from place to place.
std::vector<int> passage(const Extent& extent, const SurfaceTractions& t) {
  const Range& columns = extent.columns;
  const int stride = columns.stride(times_across);
  const int margin = static_cast<int>(std::ceil(passage_margin * extent.size(t) / t.dx / (2 * stride)));
  std::vector<int> out;
  for (int i = margin; i > 0; --i)
    out.push_back(columns.from - 2 * i * stride);
  for (int i = columns.from; i <= columns.to; i += stride)
    out.push_back(i);
  for (int i = 1; i <= margin; ++i)
    out.push_back(columns.to + 2 * i * stride);
  return out;
}

} // namespace

Section section_below(const SurfaceTractions& tractions, std::span<const int> elements) {
  const Extent extent(tractions, elements);
  const Range& rows = extent.rows;
  const double ds = tractions.ds;
  Section out;
  out.size = extent.size(tractions);

  const int row_stride = rows.stride(points_across);
  const double s_first = tractions.s[static_cast<std::size_t>(rows.from)], unit = row_stride * ds;
  std::vector<double> middle;
  for (int i = 0; i < rows.count(); i += row_stride)
    middle.push_back(s_first + i * ds);
  const double edge = s_first - ds / 2, width = rows.count() * ds;
  out.s = with_sides(middle, steps_beside(unit, 0.9 * block_margin * out.size, ds));
  const int intervals = std::max(2, static_cast<int>(middle.size()) / points_between_knots);
  std::vector<double> knots;
  for (int i = 0; i <= intervals; ++i)
    knots.push_back(edge + width * i / intervals);
  out.s_knots = with_sides(knots, steps_beside(width / intervals, block_margin * out.size, ds / 8));
  std::erase_if(out.s, [&](double s) { return s <= out.s_knots.front() || s >= out.s_knots.back(); });

  for (const double depth : depths_of_knots)
    out.depth_knots.push_back(depth * out.size);
  out.depths.push_back(0);
  for (std::size_t i = 0; i + 1 < out.depth_knots.size(); ++i)
    for (const double place : places_between_knots)
      out.depths.push_back(std::lerp(out.depth_knots[i], out.depth_knots[i + 1], place));
  out.columns = passage(extent, tractions);
  return out;
}

std::vector<int> passage_of(const SurfaceTractions& tractions) {
  std::vector<int> loaded;
  for (std::size_t i = 0; i < tractions.pn.size(); ++i)
    if (tractions.pn[i] > 0)
      loaded.push_back(static_cast<int>(i));
  return loaded.empty() ? std::vector<int>{} : passage(Extent(tractions, loaded), tractions);
}

namespace {

using halfspace::Stress;

std::array<double, 6> numbers_of(const Stress& t) {
  return {t.xx, t.ss, t.nn, t.xs, t.xn, t.sn};
}

/// Tractions of the loaded rows, and which of them lie equally far from which points: these share one matrix
/// of unit stresses.
class Rows {
public:
  Rows(const SurfaceTractions& t, std::span<const BelowSurface> points) : components_(t.has_shear() ? 3 : 1) {
    int last = -1;
    for (std::size_t i = 0; i < t.pn.size(); ++i)
      if (is_loaded(t, i)) {
        const int column = static_cast<int>(i) % t.columns;
        first_ = std::min(first_, column);
        last = std::max(last, column);
      }
    count_ = std::max(0, last - first_ + 1);
    for (int row = 0; row < t.rows() && count_ > 0; ++row)
      add_row(t, points, row);
  }

  struct Pair {
    std::size_t row, point; ///< places in `tractions` and among the points
  };
  struct Distance {
    double s = 0, depth = 0; ///< of a point from a row, mm
    std::vector<Pair> pairs;
  };
  int first() const { return first_; }                                         ///< column
  int count() const { return count_; }                                         ///< columns
  int components() const { return components_; }                               ///< 1: pressure alone
  const std::vector<Eigen::VectorXd>& tractions() const { return tractions_; } ///< [column][n, x, s]
  /// By depth and distance along s.
  const std::map<std::pair<double, long long>, Distance>& distances() const { return distances_; }

private:
  static bool is_loaded(const SurfaceTractions& t, std::size_t i) {
    return t.pn[i] != 0 || t.px[i] != 0 || t.ps[i] != 0;
  }
  void add_row(const SurfaceTractions& t, std::span<const BelowSurface> points, int row) {
    Eigen::VectorXd values = Eigen::VectorXd::Zero(count_ * components_);
    for (int c = 0; c < count_; ++c) {
      const auto i = static_cast<std::size_t>(row * t.columns + first_ + c);
      values[c * components_] = t.pn[i];
      if (components_ == 3) {
        values[c * components_ + 1] = t.px[i];
        values[c * components_ + 2] = t.ps[i];
      }
    }
    if (values.isZero(0))
      return;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double s = points[i].s - t.s[static_cast<std::size_t>(row)];
      Distance& found = distances_[{points[i].depth, std::llround(s / t.ds * 1e6)}]; // rows are ds apart
      found.s = s;
      found.depth = points[i].depth;
      found.pairs.push_back({tractions_.size(), i});
    }
    tractions_.push_back(std::move(values));
  }

  int first_ = std::numeric_limits<int>::max(), count_ = 0, components_;
  std::vector<Eigen::VectorXd> tractions_;
  std::map<std::pair<double, long long>, Distance> distances_;
};

/// Unit stresses at a depth and a distance along s: [column and component of the traction][place and
/// component of the stress].
Eigen::MatrixXd unit_stresses(const SurfaceTractions& t, const Rows& rows, std::span<const int> columns,
                              const Rows::Distance& at) {
  const int least = columns.front() - (rows.first() + rows.count() - 1), most = columns.back() - rows.first();
  const double depth = std::max(at.depth, depth_of_surface * std::min(t.dx, t.ds));
  std::vector<std::array<Stress, 3>> by_distance;
  for (int i = least; i <= most; ++i)
    by_distance.push_back(
        halfspace::rectangle_stress(t.poisson, i * t.dx, at.s, depth, 0.5 * t.dx, 0.5 * t.ds));
  constexpr std::array<Component, 3> order{component_n, component_x, component_s};
  const auto places = static_cast<Eigen::Index>(columns.size());
  Eigen::MatrixXd out(rows.count() * rows.components(), 6 * places);
  for (Eigen::Index p = 0; p < places; ++p)
    for (int c = 0; c < rows.count(); ++c) {
      const auto& unit = by_distance[columns[static_cast<std::size_t>(p)] - rows.first() - c - least];
      for (int j = 0; j < rows.components(); ++j) {
        const std::array<double, 6> values = numbers_of(unit[order[j]]);
        for (int k = 0; k < 6; ++k)
          out(c * rows.components() + j, 6 * p + k) = values[k];
      }
    }
  return out;
}

} // namespace

Stress halfspace_stress(const SurfaceTractions& t, const BelowSurface& point, double x) {
  Stress sum;
  for (std::size_t i = 0; i < t.pn.size(); ++i) {
    if (!(t.pn[i] > 0))
      continue;
    const auto row = i / static_cast<std::size_t>(t.columns);
    const auto unit = halfspace::rectangle_stress(t.poisson, x - t.x(static_cast<int>(i) % t.columns),
                                                  point.s - t.s[row], point.depth, 0.5 * t.dx, 0.5 * t.ds);
    sum.add(t.px[i], unit[component_x]).add(t.ps[i], unit[component_s]).add(t.pn[i], unit[component_n]);
  }
  return sum;
}

std::vector<std::vector<Stress>> halfspace_stresses(const SurfaceTractions& tractions,
                                                    std::span<const BelowSurface> points,
                                                    std::span<const int> columns) {
  std::vector<std::vector<Stress>> out(points.size(), std::vector<Stress>(columns.size()));
  if (columns.empty())
    return out;
  const Rows rows(tractions, points);
  Eigen::MatrixXd loads, sums;
  for (const auto& [key, distance] : rows.distances()) {
    const Eigen::MatrixXd unit = unit_stresses(tractions, rows, columns, distance);
    const auto pairs = static_cast<Eigen::Index>(distance.pairs.size());
    loads.resize(pairs, unit.rows());
    for (Eigen::Index k = 0; k < pairs; ++k)
      loads.row(k) = rows.tractions()[distance.pairs[static_cast<std::size_t>(k)].row];
    sums.resize(pairs, unit.cols());
    dense_product(loads, unit, sums.data());
    for (Eigen::Index k = 0; k < pairs; ++k)
      for (std::size_t c = 0; c < columns.size(); ++c) {
        const auto v = sums.row(k).segment<6>(static_cast<Eigen::Index>(6 * c));
        out[distance.pairs[static_cast<std::size_t>(k)].point][c].add(1,
                                                                      {v[0], v[1], v[2], v[3], v[4], v[5]});
      }
  }
  return out;
}

} // namespace bem_contact::inside
