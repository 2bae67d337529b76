#include "bem_contact/uses/table/refine.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/uses/table/measured_table.hpp"
#include "bem_contact/uses/table/refine_nested.hpp"
#include "bem_contact/uses/table/settings.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <map>
#include <numbers>
#include <numeric>
#include <set>

namespace bem_contact::table {

namespace {

/// 1. Cells whose middle is solved in one round of refining. The last round measures every cell. Fewer leave
/// large errors to that round; more cost solutions that refining throws away.
constexpr std::size_t cells_in_a_round = 400;
/// 1. The second point of a cell lies at so much of its intervals, or as far from their other ends. There
/// slopes that are off alike at both ends of an interval make the largest error, h t (1 - t) (1 - 2 t); in
/// the middle they make none. And forces are uneven where elements come into contact: of S1002 on 60E1 by 0.6
/// % of mu Fn within 0.3 mm, which a row of middles may miss altogether.
constexpr double beside_middle = 0.5 - 0.5 / std::numbers::sqrt3;
/// 1, of the tolerance. So much the points of cells may be off: elsewhere the table is off by up to 1.14
/// times as much (S1002 on 60E1 where the contact passes to the flange, of 240 forces at random points).
constexpr double held_share = 0.85;
/// 1, of the largest error of a round: cells with a larger one are refined. Smaller ones often vanish with
/// the intervals that the others need.
constexpr double worst_share = 0.5;

class TensorRefinement {
public:
  TensorRefinement(ContactTable& table, const PointsSolver& solve, const Wanted& wanted)
      : table_(table), measured_(table, solve, wanted) {}

  void run() {
    for (int round = 0;; ++round) {
      measured_.fill(round);
      const std::vector<Point> cells = middles();
      std::vector<WorstError> wrong = measured_.measure(sample(cells, round), held_share);
      if (wrong.empty()) // nothing wrong is seen: look at all of them
        wrong = measured_.measure(cells, held_share);
      if (wrong.empty())
        wrong = measured_.measure(with_points_beside(cells), held_share);
      if (wrong.empty()) {
        table_.checked = cells.size();
        return measured_.state_jumps(cells);
      }
      insert(wrong);
    }
  }

private:
  /// The intervals of a cell are those of the axes around a point in it.
  std::vector<std::size_t> intervals_of(const Point& inside) const {
    std::vector<std::size_t> out;
    for (std::size_t a = 0; a < inside.size(); ++a)
      out.push_back(std::ranges::upper_bound(table_.axes[a].points, inside[a]) -
                    table_.axes[a].points.begin() - 1);
    return out;
  }

  /// The middles, and a second point of each cell: along each axis near the lower or the upper end, in turn
  /// from cell to cell along the others.
  std::vector<Point> with_points_beside(std::vector<Point> middles) const {
    for (std::size_t k = 0, count = middles.size(); k < count; ++k) {
      Point beside = middles[k];
      const std::vector<std::size_t> cell = intervals_of(beside);
      const std::size_t all = std::accumulate(cell.begin(), cell.end(), std::size_t(0));
      for (std::size_t a = 0; a < beside.size(); ++a) {
        const std::vector<double>& points = table_.axes[a].points;
        const bool lower = (cell.size() == 1 ? all : all - cell[a]) % 2 == 0;
        beside[a] =
            std::lerp(points[cell[a]], points[cell[a] + 1], lower ? beside_middle : 1 - beside_middle);
      }
      middles.push_back(std::move(beside));
    }
    return middles;
  }

  std::vector<Point> middles() const {
    ContactTable cells{.axes = table_.axes};
    for (Axis& axis : cells.axes) {
      for (std::size_t i = 0; i + 1 < axis.points.size(); ++i)
        axis.points[i] = 0.5 * (axis.points[i] + axis.points[i + 1]);
      axis.points.pop_back();
    }
    std::vector<Point> out;
    for (std::size_t i = 0; i < cells.size(); ++i)
      out.push_back(cells.point(i));
    return out;
  }

  /// Other cells in each round: every so many, from another first one.
  static std::vector<Point> sample(const std::vector<Point>& cells, int round) {
    const std::size_t stride = cells.size() / cells_in_a_round + 1;
    std::vector<Point> out;
    for (std::size_t i = static_cast<std::size_t>(round) % stride; i < cells.size(); i += stride)
      out.push_back(cells[i]);
    return out;
  }

  /// A point of a cell, moved to the lower or the upper ends of its intervals but that of one axis. Of a
  /// middle it is a point of the table, if this interval is halved.
  Point on_edge(const Point& inside, std::size_t axis, std::size_t end) const {
    Point out = inside;
    const std::vector<std::size_t> cell = intervals_of(inside);
    for (std::size_t a = 0; a < out.size(); ++a)
      if (a != axis)
        out[a] = table_.axes[a].points[cell[a] + end];
    return out;
  }

  /// Halves intervals of the worst cells: of the axis along which the error is largest, as solutions on two
  /// of the cell's edges tell.
  void insert(const std::vector<WorstError>& wrong) {
    std::vector<Point> edges;
    const auto each_edge = [&](const auto& use) {
      for (const WorstError& cell : wrong)
        if (cell.relative >= worst_share * measured_.worst().relative)
          for (std::size_t a = 0; a < cell.at.size(); ++a)
            use(cell, a);
    };
    each_edge([&](const WorstError& cell, std::size_t a) {
      for (const std::size_t end : {0u, 1u})
        edges.push_back(on_edge(cell.at, a, end));
    });
    measured_.ask(edges);
    std::map<Point, std::vector<double>> along; ///< error of each cell along each axis
    each_edge([&](const WorstError& cell, std::size_t a) {
      const auto off = [&](std::size_t end) { return measured_.off(on_edge(cell.at, a, end), cell.column); };
      along[cell.at].push_back(std::max(off(0), off(1)));
    });
    std::vector<std::set<double>> fresh(table_.axes.size());
    for (const auto& [inside, errors] : along) {
      const std::vector<std::size_t> cell = intervals_of(inside);
      for (std::size_t a = 0; a < errors.size(); ++a)
        if (!(errors[a] < axis_share * *std::ranges::max_element(errors)))
          fresh[a].insert(0.5 * (table_.axes[a].points[cell[a]] + table_.axes[a].points[cell[a] + 1]));
    }
    for (std::size_t a = 0; a < fresh.size(); ++a) {
      std::vector<double>& points = table_.axes[a].points;
      points.insert(points.end(), fresh[a].begin(), fresh[a].end());
      std::ranges::sort(points);
    }
  }

  ContactTable& table_;
  MeasuredTable measured_;
};

} // namespace

PointsSolver one_by_one(PointSolver solve) {
  return [solve = std::move(solve)](std::span<const Point> points) {
    std::vector<PointValues> out;
    for (const Point& point : points)
      out.push_back(solve(point));
    return out;
  };
}

void refine(ContactTable& table, const PointsSolver& solve, const Wanted& wanted) {
  if (!(wanted.tolerance > 0 && std::isfinite(wanted.tolerance)))
    throw InputError(fmt::format("A table within {:g} is not possible", wanted.tolerance),
                     "the tolerance is no positive number", "Give one, such as 0.01.");
  if (table.nested())
    refine_nested(table, solve, wanted);
  else
    TensorRefinement(table, solve, wanted).run();
}

} // namespace bem_contact::table
