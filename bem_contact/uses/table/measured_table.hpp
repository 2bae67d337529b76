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
  /// States the errors of the table at these points, the middles of its cells, and gives those where they are
  /// too large.
  std::vector<WorstError> measure(std::span<const Point> middles);
  const WorstError& worst() const { return worst_; } ///< of the last measurement

private:
  void require_room(int round) const;
  std::string worst_text() const;

  ContactTable& table_;
  const PointsSolver& solve_;
  const Wanted& wanted_;
  std::map<Point, PointValues> known_;
  WorstError worst_;
};

} // namespace bem_contact::table
