#include "bem_contact/table/refine.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/table/settings.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <map>
#include <numeric>
#include <set>

namespace bem_contact::table {

namespace {

/// The largest error of one cell, and where.
struct CellError {
  std::size_t column = 0;
  double relative = 0; ///< over the column's scale
};

class Refinement {
public:
  Refinement(ContactTable& table, const PointsSolver& solve, const Wanted& wanted)
      : table_(table), solve_(solve), wanted_(wanted) {}

  void run() {
    for (int round = 0;; ++round) {
      require_room(round);
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

  Point key(Point point) const { return wanted_.representative ? wanted_.representative(point) : point; }

  void solve_missing(const std::vector<Point>& points) {
    std::set<Point> missing;
    for (const Point& point : points)
      if (Point k = key(point); !known_.contains(k))
        missing.insert(std::move(k));
    const std::vector<Point> asked(missing.begin(), missing.end());
    const std::vector<PointValues> answers = solve_(asked);
    for (std::size_t i = 0; i < asked.size(); ++i)
      known_[asked[i]] = answers[i];
    table_.solved = known_.size();
  }

  void fill() {
    std::vector<Point> points;
    for (std::size_t i = 0; i < table_.size(); ++i)
      points.push_back(table_.point(i));
    if (wanted_.progress)
      wanted_.progress(
          fmt::format("{} points{}", points.size(), worst_at_.empty() ? "" : "; " + worst_text()));
    solve_missing(points);
    for (std::size_t c = 0; c < table_.columns.size(); ++c) {
      Column& column = table_.columns[c];
      column.values.clear();
      column.element_error = std::numeric_limits<double>::quiet_NaN();
      for (const Point& point : points) {
        const PointValues& at = known_.at(key(point));
        column.values.push_back(at.values[c]);
        column.element_error = std::fmax(column.element_error, at.element_errors[c]);
      }
      if (column.held && std::ranges::any_of(column.values, [](double v) { return !std::isfinite(v); }))
        throw InputError(fmt::format("{} cannot be held within the tolerance", column.name),
                         "a point of the table has no such number", "Take it out of table.hold.");
    }
    if (wanted_.rescale)
      wanted_.rescale(table_);
  }

  double error(const Point& middle, std::size_t c) const {
    return std::abs(interpolate(table_, table_.columns[c], middle) - known_.at(key(middle)).values[c]);
  }

  /// The cells among them whose error is too large.
  std::map<Point, CellError> measure(const std::vector<Point>& middles) {
    solve_missing(middles);
    std::map<Point, CellError> out;
    worst_ = 0;
    for (const Point& middle : middles) {
      CellError cell;
      for (std::size_t c = 0; c < table_.columns.size(); ++c)
        if (const Column& column = table_.columns[c]; column.held)
          if (const double relative = error(middle, c) / column.scale; !(relative <= cell.relative))
            cell = {c, relative};
      if (cell.relative > wanted_.tolerance)
        out[middle] = cell;
      if (cell.relative > worst_)
        worst_ = cell.relative, worst_at_ = middle, worst_column_ = cell.column;
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
        if (cell.relative >= worst_share * worst_)
          for (std::size_t a = 0; a < middle.size(); ++a)
            use(middle, cell, a);
    };
    each_edge([&](const Point& middle, const CellError&, std::size_t a) {
      for (const std::size_t end : {0u, 1u})
        edges.push_back(on_edge(middle, a, end));
    });
    solve_missing(edges);
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

  void require_room(int round) const {
    const std::size_t points = table_.size();
    if (points <= wanted_.most_points && round < most_rounds)
      return;
    if (round == 0)
      throw InputError(fmt::format("The table begins with {} points", points),
                       fmt::format("{} are allowed", wanted_.most_points),
                       "Give fewer points on the axes, or allow more with --most-points.");
    throw ConvergenceError(
        fmt::format("The table is not within {:g} %", 100 * wanted_.tolerance),
        fmt::format("{}, and the next refinement takes {} points where {} are allowed", worst_text(), points,
                    wanted_.most_points),
        "Allow a larger error with --tolerance or more points with --most-points, shorten the axes, or take "
        "out of table.hold what jumps there.");
  }

  std::string worst_text() const {
    std::string where;
    for (std::size_t a = 0; a < table_.axes.size(); ++a)
      where += fmt::format("{}{} = {:.6g}", a == 0 ? "" : ", ", table_.axes[a].name, worst_at_[a]);
    return fmt::format("{} is still off by {:.3g} % at {}", table_.columns[worst_column_].name, 100 * worst_,
                       where);
  }

  void state_errors(const std::vector<Point>& cells) {
    table_.tolerance = wanted_.tolerance;
    table_.checked = cells.size();
    for (std::size_t c = 0; c < table_.columns.size(); ++c) {
      double largest = 0;
      for (const Point& middle : cells)
        largest = std::fmax(largest, error(middle, c)); // leaves nan out
      table_.columns[c].interpolation_error = largest;
    }
  }

  ContactTable& table_;
  const PointsSolver& solve_;
  const Wanted& wanted_;
  std::map<Point, PointValues> known_;
  double worst_ = 0; ///< of the last measurement
  Point worst_at_;
  std::size_t worst_column_ = 0;
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
  Refinement(table, solve, wanted).run();
}

} // namespace bem_contact::table
