#include "bem_contact/uses/table/refine_nested.hpp"

#include "bem_contact/uses/table/measured_table.hpp"
#include "bem_contact/uses/table/settings.hpp"

#include <algorithm>
#include <set>
#include <utility>

namespace bem_contact::table {

namespace {

/// 1, of the tolerance: with nested axes, a larger error along the last axis is removed before the axes
/// before it are looked at. A table of a/b from 0.1 to 10 within 1 % takes 26516 points with it.
constexpr double inner_share = 0.5;

/// The points of one axis at some point of the axes before it, and what lies below each.
struct Line {
  std::vector<double> points{};
  std::vector<Line> below{}; ///< one for each point; empty at the last axis

  /// The interval around a coordinate: the point before it and the next; of a single point both are that.
  std::pair<std::size_t, std::size_t> around(double at) const {
    if (points.size() == 1)
      return {0, 0};
    const std::size_t above = std::ranges::upper_bound(points, at) - points.begin();
    const std::size_t last = points.size() - 1;
    return {std::clamp<std::size_t>(above, 1, last) - 1, std::clamp<std::size_t>(above, 1, last)};
  }
};

/// Between points of every axis: the error is measured in its middle.
struct Cell {
  Point low, high;

  Point middle() const {
    Point out = low;
    for (std::size_t a = 0; a < out.size(); ++a)
      out[a] = 0.5 * (low[a] + high[a]);
    return out;
  }
};

/// Points that both lines have, and below each what both have there; of a line with a single point the other.
Line common(const Line& one, const Line& other) {
  if (one.points.size() == 1 || other.points.size() == 1)
    return one.points.size() == 1 ? other : one;
  Line out;
  std::ranges::set_intersection(one.points, other.points, std::back_inserter(out.points));
  const auto below = [](const Line& line, double at) -> const Line& {
    return line.below[std::ranges::lower_bound(line.points, at) - line.points.begin()];
  };
  for (const double at : out.points)
    if (!one.below.empty())
      out.below.push_back(common(below(one, at), below(other, at)));
  return out;
}

/// The lines of a table.
Line line_of(const ContactTable& table, std::size_t axis, std::size_t before) {
  const AxisLine given = table.axes[axis].line(before);
  Line out{{given.points.begin(), given.points.end()}, {}};
  for (std::size_t i = 0; axis + 1 < table.axes.size() && i < out.points.size(); ++i)
    out.below.push_back(line_of(table, axis + 1, given.first + i));
  return out;
}

void append(const Line& line, std::span<Axis> axes) {
  Axis& axis = axes.front();
  axis.points.insert(axis.points.end(), line.points.begin(), line.points.end());
  axis.first.push_back(axis.points.size());
  for (const Line& below : line.below)
    append(below, axes.subspan(1));
}

void find_cells(const std::vector<const Line*>& lines, Cell& cell, std::size_t axis, std::vector<Cell>& out) {
  std::set<double> points;
  for (const Line* line : lines)
    points.insert(line->points.begin(), line->points.end());
  for (auto low = points.begin(), high = std::next(low); high != points.end(); ++low, ++high) {
    cell.low[axis] = *low, cell.high[axis] = *high;
    if (axis + 1 == cell.low.size()) {
      out.push_back(cell);
      continue;
    }
    std::vector<const Line*> below;
    for (const Line* line : lines) {
      const auto [first, last] = line->around(0.5 * (*low + *high));
      below.push_back(&line->below[first]);
      if (last != first)
        below.push_back(&line->below[last]);
    }
    find_cells(below, cell, axis + 1, out);
  }
}

/// A point that an axis may get: the coordinates of the axes before it, and its own.
using Insertion = Point;

class NestedRefinement {
public:
  NestedRefinement(ContactTable& table, const PointsSolver& solve, const Wanted& wanted)
      : table_(table), measured_(table, solve, wanted), large_(inner_share * wanted.tolerance),
        root_(line_of(table, 0, 0)) {}

  void run() {
    for (int round = 0;; ++round) {
      fill(round);
      std::vector<Cell> cells;
      Cell cell{Point(table_.axes.size()), Point(table_.axes.size())};
      find_cells({&root_}, cell, 0, cells);
      const std::vector<Cell> wrong = measure(cells);
      if (wrong.empty())
        return measured_.state_jumps(middles_of(cells));
      insert(wrong);
    }
  }

private:
  /// The table of the lines.
  void fill(int round) {
    for (Axis& axis : table_.axes)
      axis.points.clear(), axis.first = {0};
    append(root_, table_.axes);
    table_.axes.front().first.clear(); // nothing comes before it
    measured_.fill(round);
  }

  static std::vector<Point> middles_of(const std::vector<Cell>& cells) {
    std::vector<Point> out;
    for (const Cell& cell : cells)
      out.push_back(cell.middle());
    return out;
  }

  /// The cells whose errors are too large.
  std::vector<Cell> measure(const std::vector<Cell>& cells) {
    const std::vector<Point> middles = middles_of(cells);
    std::vector<Cell> wrong;
    auto at = middles.begin();
    for (const WorstError& here : measured_.measure(middles)) { // in the order of the middles
      at = std::find(at, middles.end(), here.at);
      wrong.push_back(cells[at - middles.begin()]);
    }
    return wrong;
  }

  /// The points that could be inserted for a cell: of each axis one in each line beside the cell.
  void find_insertions(const Line& line, Point before, const Cell& cell, std::vector<Insertion>& out) const {
    const std::size_t axis = before.size();
    const auto [first, last] = line.around(0.5 * (cell.low[axis] + cell.high[axis]));
    if (first != last) {
      out.push_back(before);
      out.back().push_back(0.5 * (line.points[first] + line.points[last]));
    }
    for (const std::size_t i : std::set{first, last})
      if (!line.below.empty()) {
        before.push_back(line.points[i]);
        find_insertions(line.below[i], before, cell, out);
        before.pop_back();
      }
  }

  /// An inserted point at the lower and upper ends of the cell on the axes after it.
  static std::vector<Point> tests_of(const Insertion& insertion, const Cell& cell) {
    std::vector<Point> out{cell.low, cell.high};
    for (Point& point : out)
      std::ranges::copy(insertion, point.begin());
    if (out[0] == out[1])
      out.pop_back();
    return out;
  }

  /// Where solutions say that the error of a wrong cell comes from.
  void insert(const std::vector<Cell>& wrong) {
    std::vector<std::vector<Insertion>> candidates;
    std::vector<Point> tests;
    for (const Cell& cell : wrong) {
      candidates.emplace_back();
      find_insertions(root_, {}, cell, candidates.back());
      for (const Insertion& insertion : candidates.back())
        std::ranges::copy(tests_of(insertion, cell), std::back_inserter(tests));
    }
    measured_.ask(tests);
    std::set<Insertion> chosen;
    for (std::size_t i = 0; i < wrong.size(); ++i)
      choose(candidates[i], wrong[i], chosen);
    std::vector<Insertion> outer_first(chosen.begin(),
                                       chosen.end()); // a new line is a copy of what was measured
    std::ranges::stable_sort(outer_first, {}, &Insertion::size);
    for (const Insertion& insertion : outer_first)
      insert(root_, insertion, 0);
  }

  void choose(const std::vector<Insertion>& candidates, const Cell& cell, std::set<Insertion>& chosen) const {
    std::vector<double> errors;
    double largest = 0;
    std::size_t innermost = 0; // coordinates of the candidates with a large error
    for (const Insertion& insertion : candidates) {
      errors.push_back(0);
      for (const Point& test : tests_of(insertion, cell))
        errors.back() = std::max(errors.back(), measured_.error(test).relative);
      largest = std::max(largest, errors.back());
      if (errors.back() >= large_)
        innermost = std::max(innermost, insertion.size());
    }
    for (std::size_t k = 0; k < errors.size(); ++k)
      if (innermost > 0 ? candidates[k].size() == innermost && errors[k] >= large_
                        : errors[k] >= axis_share * largest)
        chosen.insert(candidates[k]);
  }

  static void insert(Line& line, const Insertion& insertion, std::size_t axis) {
    const double at = insertion[axis];
    const auto place = std::ranges::lower_bound(line.points, at);
    const std::size_t i = place - line.points.begin();
    const bool there = place != line.points.end() && *place == at;
    if (axis + 1 < insertion.size())
      return insert(line.below[i], insertion, axis + 1);
    if (there)
      return;
    line.points.insert(place, at);
    if (!line.below.empty())
      line.below.insert(line.below.begin() + static_cast<std::ptrdiff_t>(i),
                        common(line.below[i - 1], line.below[i]));
  }

  ContactTable& table_;
  MeasuredTable measured_;
  double large_; ///< an error along the last axes that is removed first
  Line root_;
};

} // namespace

void refine_nested(ContactTable& table, const PointsSolver& solve, const Wanted& wanted) {
  NestedRefinement(table, solve, wanted).run();
}

} // namespace bem_contact::table
