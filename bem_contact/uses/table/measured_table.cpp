#include "bem_contact/uses/table/measured_table.hpp"

#include "bem_contact/base/counted.hpp"
#include "bem_contact/base/error.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <functional>
#include <iterator>
#include <limits>
#include <set>

namespace bem_contact::table {

void MeasuredTable::ask(std::span<const Point> points) {
  std::set<Point> missing;
  for (const Point& point : points)
    if (!known_.contains(point))
      missing.insert(point);
  const std::vector<Point> asked(missing.begin(), missing.end());
  const std::vector<PointValues> answers = solve_(asked);
  for (std::size_t i = 0; i < asked.size(); ++i)
    known_[asked[i]] = answers[i];
}

namespace {

/// 1. Rounds, as a guard: each inserts a point at least, and 200 points on an axis are no table.
constexpr int most_rounds = 200;
/// 1. In the middle of a cell its corners have a larger weight along each axis than this, and others a
/// smaller one.
constexpr double corner_weight = 0.3;
/// 1, of a difference between a middle and a corner. Where the interpolation in the middle is off by less,
/// there is no jump between them: one that passes off a single corner of four leaves a quarter.
constexpr double jump_off = 0.2;
/// 1. How often the way from the middle to the corner is halved, and the share of the difference that is
/// then left of a jump. A bend leaves half of it each time, an eighth in the end.
constexpr int jump_halvings = 3;
constexpr double jump_left = 0.7;
/// 1. Ways that are looked at for each column, the steepest. Chosen: each takes jump_halvings solutions.
constexpr std::size_t most_ways = 6;

[[noreturn]] void refuse_to_hold(const Column& column) {
  throw InputError(fmt::format("{} cannot be held within the tolerance", column.name),
                   "a point of the table has no such number", "Take it out of table.hold.");
}

} // namespace

std::string MeasuredTable::foreseen_text() const {
  std::size_t cells = 1;
  for (const Axis& axis : table_.axes)
    cells *= axis.points.size() - 1;
  return table_.nested()
             ? ""
             : fmt::format(
                   "; with two points in each of its {} that is {} contacts at least, and twice as many "
                   "with each axis whose intervals must be halved",
                   counted(std::ptrdiff_t(cells), "cell", "cells"), table_.size() + 2 * cells);
}

void MeasuredTable::fill(int round) {
  require_room(round);
  if (wanted_.progress)
    wanted_.progress(
        fmt::format("{} points{}", table_.size(), round == 0 ? foreseen_text() : "; " + worst_text()));
  std::vector<Point> points;
  for (std::size_t i = 0; i < table_.size(); ++i)
    points.push_back(table_.point(i));
  ask(points);
  for (std::size_t c = 0; c < table_.columns.size(); ++c) {
    Column& column = table_.columns[c];
    column.values.clear();
    column.element_error = std::numeric_limits<double>::quiet_NaN();
    for (const Point& point : points) {
      const PointValues& at = known_.at(point);
      column.values.push_back(at.values[c]);
      column.element_error = std::fmax(column.element_error, at.element_errors[c]);
    }
    if (column.held && std::ranges::any_of(column.values, [](double v) { return !std::isfinite(v); }))
      refuse_to_hold(column);
  }
  if (wanted_.rescale)
    wanted_.rescale(table_);
}

double MeasuredTable::off(const Point& at, std::size_t column) const {
  return std::abs(interpolate(table_, table_.columns[column], at) - known_.at(at).values[column]);
}

WorstError MeasuredTable::error(const Point& at) const {
  WorstError worst{.at = at};
  for (std::size_t c = 0; c < table_.columns.size(); ++c)
    if (const Column& column = table_.columns[c]; column.held) {
      const double relative = off(at, c) / column.scale;
      if (std::isnan(relative))
        refuse_to_hold(column);
      if (relative > worst.relative)
        worst.relative = relative, worst.column = c;
    }
  return worst;
}

std::vector<WorstError> MeasuredTable::measure(std::span<const Point> points, double share) {
  ask(points);
  for (std::size_t c = 0; c < table_.columns.size(); ++c) {
    double& largest = table_.columns[c].interpolation_error = 0;
    for (const Point& point : points)
      largest = std::fmax(largest, off(point, c)); // leaves nan out
  }
  table_.tolerance = wanted_.tolerance;
  table_.checked = points.size();
  table_.solved = known_.size();
  std::vector<WorstError> wrong;
  worst_.relative = 0;
  for (const Point& point : points) {
    const WorstError here = error(point);
    if (here.relative > share * wanted_.tolerance)
      wrong.push_back(here);
    if (here.relative > worst_.relative)
      worst_ = here;
  }
  return wrong;
}

std::vector<MeasuredTable::Way> MeasuredTable::steep_ways(std::span<const Point> middles,
                                                          std::size_t column) const {
  const Column& of = table_.columns[column];
  std::vector<Way> out;
  for (const Point& middle : middles) {
    const double here = off(middle, column), there = known_.at(middle).values[column];
    Way steepest{.column = column};
    for (const PointWeight& corner : weights_at(table_, middle))
      if (corner.weight >= std::pow(corner_weight, double(middle.size())))
        if (const double step = std::abs(of.values[corner.index] - there); step > steepest.step)
          steepest = {column, middle, table_.point(corner.index), step};
    if (steepest.step > of.interpolation_error && here >= jump_off * steepest.step)
      out.push_back(std::move(steepest));
  }
  std::ranges::sort(out, std::ranges::greater(), &Way::step);
  out.resize(std::min(out.size(), most_ways));
  return out;
}

void MeasuredTable::state_jumps(std::span<const Point> middles) {
  std::vector<Way> ways;
  for (std::size_t c = 0; c < table_.columns.size(); ++c)
    std::ranges::move(steep_ways(middles, c), std::back_inserter(ways));
  std::vector<Way> halves = ways;
  for (int round = 0; round < jump_halvings; ++round) {
    std::vector<Point> between;
    for (const Way& way : halves) {
      between.push_back(way.from);
      for (std::size_t a = 0; a < way.to.size(); ++a)
        between.back()[a] = 0.5 * (way.from[a] + way.to[a]);
    }
    ask(between);
    for (std::size_t k = 0; k < halves.size(); ++k) {
      Way& way = halves[k];
      const auto value = [&](const Point& at) { return known_.at(at).values[way.column]; };
      const double before = std::abs(value(between[k]) - value(way.from)),
                   after = std::abs(value(way.to) - value(between[k]));
      (before > after ? way.to : way.from) = between[k];
      way.step = std::max(before, after);
    }
  }
  for (std::size_t k = 0; k < ways.size(); ++k) {
    if (halves[k].step < jump_left * ways[k].step)
      continue;
    Column& column = table_.columns[ways[k].column];
    column.interpolation_error = std::max(column.interpolation_error, ways[k].step);
    column.held = column.held && column.interpolation_error <= wanted_.tolerance * column.scale;
  }
  table_.solved = known_.size();
}

std::string MeasuredTable::worst_text() const {
  std::string where;
  for (std::size_t a = 0; a < table_.axes.size(); ++a)
    where += fmt::format("{}{} = {:.6g}", a == 0 ? "" : ", ", table_.axes[a].name, worst_.at[a]);
  return fmt::format("{} is still off by {:.3g} % at {}", table_.columns[worst_.column].name,
                     100 * worst_.relative, where);
}

void MeasuredTable::require_room(int round) const {
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

} // namespace bem_contact::table
