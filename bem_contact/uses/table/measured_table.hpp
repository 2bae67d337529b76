#pragma once

#include "bem_contact/uses/table/refine.hpp"

#include <map>

namespace bem_contact::table {

/// The largest error of held columns at a point, over the scale of its column.
struct WorstError {
  double relative = 0;
  std::size_t column = 0;
  Point at{};
};

/// What refine() and refine_nested() share: the points of a table, each solved once, and its errors between
/// them.
class MeasuredTable {
public:
  MeasuredTable(ContactTable& table, const PointsSolver& solve, const Wanted& wanted)
      : table_(table), solve_(solve), wanted_(wanted) {}

  /// Solves the points of the table, and gives its columns their values. Throws InputError in the first
  /// round, ConvergenceError in later ones, if there are too many points.
  void fill(int round);
  /// Solves those that are not known yet, all in one call.
  void ask(std::span<const Point> points);
  /// How far the interpolation of a column is off at a point that was solved, in its unit.
  double off(const Point& at, std::size_t column) const;
  /// The largest error there.
  WorstError error(const Point& at) const;
  /// States the errors of the table at these points, which lie in its cells, and gives those where they are
  /// too large: by more than this share of the tolerance.
  std::vector<WorstError> measure(std::span<const Point> points, double share = 1);
  const WorstError& worst() const { return worst_; } ///< of the last measurement
  /// Beside a jump the table may be off by all of it, however small the cells are, and their middles tell of
  /// half of it. Where a column changes most from a middle to a corner, and the middle is off, the way
  /// between them is halved again and again: what does not become smaller is a jump, and the stated error
  /// covers it.
  void state_jumps(std::span<const Point> middles);

private:
  /// From the middle of a cell to one of its corners, and how much a column changes on it, in its unit.
  struct Way {
    std::size_t column = 0;
    Point from{}, to{};
    double step = 0;
  };
  /// The ways on which there may be a jump that is larger than the stated error.
  std::vector<Way> steep_ways(std::span<const Point> middles, std::size_t column) const;
  void require_room(int round) const;
  std::string worst_text() const;
  std::string foreseen_text() const; ///< how many contacts it takes; "" of nested axes, which nobody knows

  ContactTable& table_;
  const PointsSolver& solve_;
  const Wanted& wanted_;
  std::map<Point, PointValues> known_;
  WorstError worst_;
};

} // namespace bem_contact::table
