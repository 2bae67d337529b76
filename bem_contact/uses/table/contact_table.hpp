#pragma once

#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace bem_contact::table {

/// The points of one axis at some place of the axes before it.
struct AxisLine {
  std::span<const double> points; ///< increasing, in the unit of the axis
  std::size_t first;              ///< number of the first of them, counted over all lines of the axis
};

/// One axis of a table.
struct Axis {
  std::string name;        ///< as scenes and look-ups name the coordinate
  std::string unit;        ///< mm, N, rad ...; "1": none
  std::string description; ///< in a few words
  /// Increasing, in the unit of the axis. A nested axis has those of one line after the other.
  std::vector<double> points;
  /// Empty if the points are the same everywhere. Else the axis is nested: it has points of its own at each
  /// point of the axes before it, and first[i] .. first[i + 1] are those at the i-th. A line may have a
  /// single point, if the coordinate changes nothing there; the last line reaches from end to end.
  std::vector<std::size_t> first{};

  /// The line at point number `before` of the axes before it, counted from 0 as ContactTable::point() does.
  AxisLine line(std::size_t before) const;
  double from() const; ///< its lower end, in its unit
  double to() const;   ///< its upper end, in its unit
};

/// One number at every point of a table.
struct Column {
  std::string name;        ///< as look-ups name it
  std::string unit;        ///< N, N mm ...; "1": none
  std::string description; ///< in a few words
  bool held = true;        ///< whether refine() keeps its error within the tolerance, jumps too
  double scale = 1;        ///< what errors are relative to, in its unit
  /// Largest difference from a solution within a cell, or jump within one, in its unit.
  double interpolation_error = std::numeric_limits<double>::quiet_NaN();
  /// Largest error by the size of the elements that a point states, in its unit; nan: not known.
  double element_error = std::numeric_limits<double>::quiet_NaN();
  /// How far a value that is looked up may be off, in its unit: between the points and by the elements; where
  /// the second is not known, between the points alone.
  double error() const { return interpolation_error + (std::isnan(element_error) ? 0 : element_error); }
  /// There is one value for each point, in its unit; the last axis runs fastest: [first axis][second
  /// axis]..., unless axes are nested.
  std::vector<double> values{};
};

/// Says by what the creepages of a creep table are scaled (creep_table.hpp): Kalker's coefficients over the
/// ellipse, linear between the points.
struct CreepScale {
  std::vector<double> log10_a_over_b{}; ///< of the semi-axes along x and s, increasing, 1
  std::vector<double> c11{}, c22{};     ///< Kalker's coefficients at these, 1; equally long
  double poisson = 0;                   ///< Poisson's ratio of the pair, 1
};

/// Numbers over a tensor product of axes, or over nested axes.
struct ContactTable {
  std::vector<Axis> axes{};          ///< the first one runs slowest
  std::vector<Column> columns{};     ///< each with size() values
  std::optional<CreepScale> scale{}; ///< of a creep table
  double tolerance = 0;              ///< that refine() has met, relative to each column's scale, 1
  std::size_t solved = 0;            ///< contact problems, points between the points included
  std::size_t checked = 0;           ///< of them, cells whose middle was solved to measure the error

  std::size_t size() const; ///< points
  bool nested() const;      ///< whether an axis is
  /// The coordinates of a point by its number in Column::values, one for each axis, in their units.
  std::vector<double> point(std::size_t index) const;
  /// Throws InputError for a name that no column has.
  const Column& column(std::string_view name) const;
};

/// What a point of the table contributes to the value at some place: the same for every column.
struct PointWeight {
  std::size_t index; ///< of the point, as values have it
  double weight;     ///< 1
};

/// Throws InputError unless the table has so many axes, one for each coordinate of a point.
void require_coordinates(const ContactTable& table, std::size_t count);

/// How the points of a table make the value at a place, one coordinate for each axis. In each coordinate it
/// is cubic between two points, with the slopes there of parabolas through three neighbours (linear, where
/// there are only two points), and constant beyond the ends. Coordinates are taken one after the other: at
/// each of up to four neighbours on one axis, the next axis has points of its own if it is nested. The slope
/// is continuous. Beside a jump it overshoots, by less than a tenth of the jump in each coordinate where
/// points are equally far apart. Throws InputError unless `at` has one coordinate for each axis.
std::vector<PointWeight> weights_at(const ContactTable& table, std::span<const double> at);
/// The value of a column with these weights, in its unit.
double interpolate(const Column& column, std::span<const PointWeight> weights);
/// The value of a column at a place, one coordinate for each axis, in the unit of the column. Throws
/// InputError for another number of coordinates.
double interpolate(const ContactTable& table, const Column& column, std::span<const double> at);

/// The value of each column at a place, in the units of the columns, for users. Throws InputError outside the
/// axes, where interpolate() goes on with a constant and nobody knows the error.
std::vector<double> look_up(const ContactTable& table, std::span<const double> at);
/// Throws InputError if a coordinate is outside its axis, by more than the last digits.
void require_inside(const Axis& axis, double at);

/// The curve y over x (increasing, as many as y, two at least) at a place: linear between its points,
/// constant beyond its ends.
double interpolate(std::span<const double> x, std::span<const double> y, double at);

} // namespace bem_contact::table
