#include "bem_contact/table/refine.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/table/refine_nested.hpp"
#include "bem_contact/table/settings.hpp"
#include "bem_contact/table/solved_points.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <map>
#include <set>

namespace bem_contact::table {

namespace {

/// The largest error of one cell, and where.
struct CellError {
  std::size_t column = 0;
  double relative = 0; ///< over the column's scale
};

class TensorRefinement {
public:
  TensorRefinement(ContactTable& table, const PointsSolver& solve, const Wanted& wanted)
      : table_(table), wanted_(wanted), solved_(solve) {}

  void run() {
    for (int round = 0;; ++round) {
      require_room(table_, wanted_, round, worst_);
      fill();
      const std::vector<Point> cells = middles();
      std::map<Point, CellError> wrong = measure(sample(cells, round));
      if (wrong.empty()) // nothing wrong is seen: look at all of them
        wrong = measure(cells);
      if (wrong.empty())
        return state_errors(cells);
      insert(wrong);
    }
  }

private:
  /// The intervals of a cell are those of the axes around its middle.
  std::vector<std::size_t> intervals_of(const Point& middle) const {
    std::vector<std::size_t> out;
    for (std::size_t a = 0; a < middle.size(); ++a)
      out.push_back(std::ranges::upper_bound(table_.axes[a].points, middle[a]) -
                    table_.axes[a].points.begin() - 1);
    return out;
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

  void fill() {
    if (wanted_.progress)
      wanted_.progress(
          fmt::format("{} points{}", table_.size(), worst_.at.empty() ? "" : "; " + worst_.text(table_)));
    solved_.fill(table_);
    if (wanted_.rescale)
      wanted_.rescale(table_);
  }

  double error(const Point& middle, std::size_t c) const {
    return std::abs(interpolate(table_, table_.columns[c], middle) - solved_.at(middle).values[c]);
  }

  /// The cells among them whose error is too large.
  std::map<Point, CellError> measure(const std::vector<Point>& middles) {
    solved_.ask(middles);
    std::map<Point, CellError> out;
    worst_.relative = 0;
    for (const Point& middle : middles) {
      CellError cell;
      for (std::size_t c = 0; c < table_.columns.size(); ++c)
        if (const Column& column = table_.columns[c]; column.held)
          if (const double relative = error(middle, c) / column.scale; !(relative <= cell.relative))
            cell = {c, relative};
      if (cell.relative > wanted_.tolerance)
        out[middle] = cell;
      if (cell.relative > worst_.relative)
        worst_ = {cell.relative, cell.column, middle};
    }
    return out;
  }

  /// The middle of a cell's interval of one axis, at the lower or the upper ends of its other intervals. If
  /// this interval is halved, it is a point of the table.
  Point on_edge(const Point& middle, std::size_t axis, std::size_t end) const {
    Point out = middle;
    const std::vector<std::size_t> cell = intervals_of(middle);
    for (std::size_t a = 0; a < out.size(); ++a)
      if (a != axis)
        out[a] = table_.axes[a].points[cell[a] + end];
    return out;
  }

  /// Halves intervals of the worst cells: of the axis along which the error is largest, as solutions on two
  /// of the cell's edges tell.
  void insert(const std::map<Point, CellError>& wrong) {
    std::vector<Point> edges;
    const auto each_edge = [&](const auto& use) {
      for (const auto& [middle, cell] : wrong)
        if (cell.relative >= worst_share * worst_.relative)
          for (std::size_t a = 0; a < middle.size(); ++a)
            use(middle, cell, a);
    };
    each_edge([&](const Point& middle, const CellError&, std::size_t a) {
      for (const std::size_t end : {0u, 1u})
        edges.push_back(on_edge(middle, a, end));
    });
    solved_.ask(edges);
    std::map<Point, std::vector<double>> along; ///< error of each cell along each axis
    each_edge([&](const Point& middle, const CellError& cell, std::size_t a) {
      along[middle].push_back(
          std::max(error(on_edge(middle, a, 0), cell.column), error(on_edge(middle, a, 1), cell.column)));
    });
    std::vector<std::set<double>> fresh(table_.axes.size());
    for (const auto& [middle, errors] : along)
      for (std::size_t a = 0; a < errors.size(); ++a)
        if (!(errors[a] < axis_share * *std::ranges::max_element(errors)))
          fresh[a].insert(middle[a]);
    for (std::size_t a = 0; a < fresh.size(); ++a) {
      std::vector<double>& points = table_.axes[a].points;
      points.insert(points.end(), fresh[a].begin(), fresh[a].end());
      std::ranges::sort(points);
    }
  }

  void state_errors(const std::vector<Point>& cells) {
    table_.tolerance = wanted_.tolerance;
    table_.checked = cells.size();
    table_.solved = solved_.size();
    for (std::size_t c = 0; c < table_.columns.size(); ++c) {
      double largest = 0;
      for (const Point& middle : cells)
        largest = std::fmax(largest, error(middle, c)); // leaves nan out
      table_.columns[c].interpolation_error = largest;
    }
  }

  ContactTable& table_;
  const Wanted& wanted_;
  SolvedPoints solved_;
  WorstError worst_;
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
