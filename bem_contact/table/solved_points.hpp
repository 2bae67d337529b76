#pragma once

#include "bem_contact/table/refine.hpp"

#include <map>

namespace bem_contact::table {

/// What both ways of refining share: points that were solved, none of them twice.
class SolvedPoints {
public:
  explicit SolvedPoints(const PointsSolver& solve) : solve_(solve) {}

  /// Solves those that are not known yet, all in one call.
  void ask(std::span<const Point> points);
  const PointValues& at(const Point& point) const { return known_.at(point); }
  std::size_t size() const { return known_.size(); }
  /// Solves the points of a table, and gives its columns their values.
  void fill(ContactTable& table);

private:
  const PointsSolver& solve_;
  std::map<Point, PointValues> known_;
};

/// The largest error of a table that was measured last, over the scale of its column.
struct WorstError {
  double relative = 0;
  std::size_t column = 0;
  Point at{};

  std::string text(const ContactTable& table) const;
};

/// Throws InputError in the first round, ConvergenceError in later ones, if a table has too many points.
void require_room(const ContactTable& table, const Wanted& wanted, int round, const WorstError& worst);

} // namespace bem_contact::table
