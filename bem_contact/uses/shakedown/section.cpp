#include "bem_contact/uses/shakedown/section.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/influence/dense.hpp"
#include "bem_contact/uses/shakedown/settings.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

namespace bem_contact::shakedown {

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

Section section_below(const ContactProblem& problem, std::span<const int> elements) {
  if (problem.plane_strain())
    throw InputError("There is no shakedown in plane strain",
                     "its elements are endless along x: nothing passes",
                     "Give a scene with elements along x.");
  const ContactGrid& grid = problem.grid;
  Range rows{grid.ms, -1}, columns{grid.mx, -1};
  for (const int i : elements) {
    rows = {std::min(rows.from, i / grid.mx), std::max(rows.to, i / grid.mx)};
    columns = {std::min(columns.from, i % grid.mx), std::max(columns.to, i % grid.mx)};
  }
  Section out;
  out.size = 0.5 * std::min(rows.count() * grid.ds, columns.count() * grid.dx);

  const int row_stride = rows.stride(points_across);
  const double s_first = problem.rows[rows.from].s, unit = row_stride * grid.ds;
  std::vector<double> middle;
  for (int i = 0; i < rows.count(); i += row_stride)
    middle.push_back(s_first + i * grid.ds);
  const double edge = s_first - grid.ds / 2, width = rows.count() * grid.ds;
  out.s = with_sides(middle, steps_beside(unit, 0.9 * block_margin * out.size, grid.ds));
  const int intervals = std::max(2, static_cast<int>(middle.size()) / points_between_knots);
  std::vector<double> knots;
  for (int i = 0; i <= intervals; ++i)
    knots.push_back(edge + width * i / intervals);
  out.s_knots = with_sides(knots, steps_beside(width / intervals, block_margin * out.size, grid.ds / 8));
  std::erase_if(out.s, [&](double s) { return s <= out.s_knots.front() || s >= out.s_knots.back(); });

  for (const double depth : depths_of_knots)
    out.depth_knots.push_back(depth * out.size);
  out.depths.push_back(0);
  for (std::size_t i = 0; i + 1 < out.depth_knots.size(); ++i)
    for (const double place : places_between_knots)
      out.depths.push_back(std::lerp(out.depth_knots[i], out.depth_knots[i + 1], place));

  // Ahead of the patch and behind it stresses change less from place to place.
  const int stride = columns.stride(times_across);
  const int margin = static_cast<int>(std::ceil(passage_margin * out.size / grid.dx / (2 * stride)));
  for (int i = margin; i > 0; --i)
    out.columns.push_back(columns.from - 2 * i * stride);
  for (int i = columns.from; i <= columns.to; i += stride)
    out.columns.push_back(i);
  for (int i = 1; i <= margin; ++i)
    out.columns.push_back(columns.to + 2 * i * stride);
  return out;
}

namespace {

using halfspace::Stress;

std::array<double, 6> numbers_of(const Stress& t) {
  return {t.xx, t.ss, t.nn, t.xs, t.xn, t.sn};
}

/// Tractions of the loaded rows, and which of them lie equally far from which points along s: these share one
/// matrix of unit stresses.
class Rows {
public:
  Rows(const Section& section, const ContactProblem& problem, const ContactResult& result)
      : components_(problem.has_friction() ? 3 : 1) {
    const ContactGrid& grid = problem.grid;
    int last = -1;
    for (int i = 0; i < grid.size(); ++i)
      if (result.pn[i] > 0) {
        first_ = std::min(first_, i % grid.mx);
        last = std::max(last, i % grid.mx);
      }
    count_ = std::max(0, last - first_ + 1);
    for (int row = 0; row < grid.ms && count_ > 0; ++row)
      add_row(section, problem, result, row);
  }

  struct Pair {
    std::size_t row, s; ///< places in `tractions` and in Section::s
  };
  struct Distance {
    double s = 0; ///< of a point from a row, mm
    std::vector<Pair> pairs;
  };
  int first() const { return first_; }                                         ///< column
  int count() const { return count_; }                                         ///< columns
  int components() const { return components_; }                               ///< 1: pressure alone
  const std::vector<Eigen::VectorXd>& tractions() const { return tractions_; } ///< [column][n, x, s]
  const std::map<long long, Distance>& distances() const { return distances_; }

private:
  void add_row(const Section& section, const ContactProblem& problem, const ContactResult& result, int row) {
    Eigen::VectorXd values = Eigen::VectorXd::Zero(count_ * components_);
    for (int c = 0; c < count_; ++c) {
      const int i = row * problem.grid.mx + first_ + c;
      if (!(result.pn[i] > 0))
        continue;
      values[c * components_] = result.pn[i];
      if (components_ == 3) {
        values[c * components_ + 1] = result.px[i];
        values[c * components_ + 2] = result.ps[i];
      }
    }
    if (values.isZero(0))
      return;
    for (std::size_t is = 0; is < section.s.size(); ++is) {
      const double s = section.s[is] - problem.rows[row].s;
      Distance& found = distances_[std::llround(s / problem.grid.ds * 1e6)]; // rows of one area are ds apart
      found.s = s;
      found.pairs.push_back({tractions_.size(), is});
    }
    tractions_.push_back(std::move(values));
  }

  int first_ = std::numeric_limits<int>::max(), count_ = 0, components_;
  std::vector<Eigen::VectorXd> tractions_;
  std::map<long long, Distance> distances_;
};

/// Unit stresses at a depth and a distance along s: [column and component of the traction][place and
/// component of the stress].
Eigen::MatrixXd unit_stresses(const Section& section, const Rows& rows, const ContactGrid& grid,
                              double poisson, std::array<double, 2> at) {
  const int least = section.columns.front() - (rows.first() + rows.count() - 1),
            most = section.columns.back() - rows.first();
  std::vector<std::array<Stress, 3>> by_distance;
  for (int i = least; i <= most; ++i)
    by_distance.push_back(
        halfspace::rectangle_stress(poisson, i * grid.dx, at[0], at[1], 0.5 * grid.dx, 0.5 * grid.ds));
  constexpr std::array<Component, 3> order{component_n, component_x, component_s};
  const auto places = static_cast<Eigen::Index>(section.columns.size());
  Eigen::MatrixXd out(rows.count() * rows.components(), 6 * places);
  for (Eigen::Index p = 0; p < places; ++p)
    for (int c = 0; c < rows.count(); ++c) {
      const auto& unit = by_distance[section.columns[static_cast<std::size_t>(p)] - rows.first() - c - least];
      for (int j = 0; j < rows.components(); ++j) {
        const std::array<double, 6> values = numbers_of(unit[order[j]]);
        for (int k = 0; k < 6; ++k)
          out(c * rows.components() + j, 6 * p + k) = values[k];
      }
    }
  return out;
}

} // namespace

std::vector<std::vector<Stress>> stresses_of_passage(const Section& section, const ContactProblem& problem,
                                                     const ContactResult& result, double poisson) {
  const ContactGrid& grid = problem.grid;
  const Rows rows(section, problem, result);
  std::vector<std::vector<Stress>> out(section.points(), std::vector<Stress>(section.columns.size() + 1));
  Eigen::MatrixXd loads, sums;
  for (std::size_t id = 0; id < section.depths.size(); ++id)
    for (const auto& [key, distance] : rows.distances()) {
      const double depth = std::max(section.depths[id], depth_of_surface * std::min(grid.dx, grid.ds));
      const Eigen::MatrixXd unit = unit_stresses(section, rows, grid, poisson, {distance.s, depth});
      const auto pairs = static_cast<Eigen::Index>(distance.pairs.size());
      loads.resize(pairs, unit.rows());
      for (Eigen::Index k = 0; k < pairs; ++k)
        loads.row(k) = rows.tractions()[distance.pairs[static_cast<std::size_t>(k)].row];
      sums.resize(pairs, unit.cols());
      dense_product(loads, unit, sums.data());
      for (Eigen::Index k = 0; k < pairs; ++k)
        for (std::size_t c = 0; c < section.columns.size(); ++c) {
          const auto v = sums.row(k).segment<6>(static_cast<Eigen::Index>(6 * c));
          out[section.point(distance.pairs[static_cast<std::size_t>(k)].s, id)][c].add(
              1, {v[0], v[1], v[2], v[3], v[4], v[5]});
        }
    }
  return out;
}

} // namespace bem_contact::shakedown
