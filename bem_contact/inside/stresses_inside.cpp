#include "bem_contact/inside/stresses_inside.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/base/input_file.hpp"
#include "bem_contact/base/number_text.hpp"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <sstream>

namespace bem_contact::inside {

namespace {

using halfspace::Stress;

/// 1. A patch with fewer rows or columns has no stresses worth looking at.
constexpr int least_across = 4;
/// 1. Most points of one's own: some minutes.
constexpr std::size_t most_own_points = 20'000;

double largest_pressure(const SurfaceTractions& t, std::span<const int> elements) {
  double out = 0;
  for (const int i : elements)
    out = std::max(out, t.pn[static_cast<std::size_t>(i)]);
  return out;
}

void add_flat(const SurfaceTractions& t, std::span<const int> columns, AreaStresses& area) {
  for (const int column : columns)
    area.x.push_back(t.x(column));
  area.flat = halfspace_stresses(t, area.points, columns);
}

std::array<double, 2> outer_principals(const Stress& t) {
  Eigen::Matrix3d tensor;
  tensor << t.xx, t.xs, t.xn, t.xs, t.ss, t.sn, t.xn, t.sn, t.nn;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> principal(tensor, Eigen::EigenvaluesOnly);
  return {principal.eigenvalues()[0], principal.eigenvalues()[2]};
}

bool is_known(const Stress& t) {
  return std::isfinite(t.xx + t.ss + t.nn + t.xs + t.xn + t.sn);
}

} // namespace

bool is_too_small(std::span<const int> elements, int columns) {
  int least_row = elements.front(), most_row = 0, least_column = columns, most_column = 0;
  for (const int i : elements) {
    least_row = std::min(least_row, i / columns);
    most_row = std::max(most_row, i / columns);
    least_column = std::min(least_column, i % columns);
    most_column = std::max(most_column, i % columns);
  }
  return most_row - least_row + 1 < least_across || most_column - least_column + 1 < least_across;
}

StressesInside halfspace_inside(const SurfaceTractions& tractions, Side side,
                                std::span<const BelowSurface> own) {
  StressesInside out;
  out.side = side;
  out.poisson = tractions.poisson;
  if (!own.empty()) {
    AreaStresses area;
    area.points.assign(own.begin(), own.end());
    area.pmax = *std::ranges::max_element(tractions.pn);
    const std::vector<int> columns = passage_of(tractions);
    if (columns.empty())
      return out;
    add_flat(tractions, columns, area);
    out.areas.push_back(std::move(area));
    return out;
  }
  for (const std::vector<int>& elements : loaded_patches(tractions)) {
    if (is_too_small(elements, tractions.columns)) {
      ++out.too_small;
      continue;
    }
    AreaStresses area;
    area.section = section_below(tractions, elements);
    area.points = area.section->points();
    area.rows = area.section->s.size();
    area.depths = area.section->depths.size();
    area.pmax = largest_pressure(tractions, elements);
    add_flat(tractions, area.section->columns, area);
    out.areas.push_back(std::move(area));
  }
  return out;
}

std::vector<BelowSurface> read_points_below(const std::filesystem::path& file) {
  std::istringstream text(read_text_file(file.string(), "points"));
  const auto refuse = [&](const std::string& why) {
    throw InputError(fmt::format("'{}' has no points below a surface", file.string()), why,
                     "Give a CSV file with the columns s,depth (mm).");
  };
  const auto cells = [](std::string line) {
    std::erase_if(line, [](char c) { return c == ' ' || c == '\t' || c == '\r'; });
    std::vector<std::string> out(1);
    for (const char c : line)
      if (c == ',')
        out.emplace_back();
      else
        out.back() += c;
    return out;
  };
  std::vector<BelowSurface> out;
  std::string line;
  for (std::size_t number = 1; std::getline(text, line); ++number) {
    if (const std::size_t comment = line.find('#'); comment != std::string::npos)
      line.resize(comment);
    const std::vector<std::string> found = cells(line);
    if (found.size() == 1 && found[0].empty())
      continue;
    if (out.empty() && found == std::vector<std::string>{"s", "depth"})
      continue;
    const auto s = number_of_text(found[0]),
               depth = found.size() == 2 ? number_of_text(found[1]) : std::nullopt;
    if (!s || !depth || !std::isfinite(*s) || !(*depth >= 0) || !std::isfinite(*depth))
      refuse(fmt::format("line {} is no arc length and no depth of 0 or more", number));
    out.push_back({*s, *depth});
    if (out.size() > most_own_points)
      refuse(fmt::format("it has more than {} points", most_own_points));
  }
  if (out.empty())
    refuse("it is empty");
  return out;
}

namespace {

/// What may lie between a point and its neighbours, if the measure is a parabola between them: an eighth of
/// its second difference.
double between(double before, double here, double after) {
  const double bend = std::abs(before - 2 * here + after) / 8;
  return std::isfinite(bend) ? bend : 0;
}

} // namespace

Peak peak_of(const StressesInside& inside, const AreaStresses& area, const std::vector<Passage>& stresses,
             const std::function<double(const Stress&)>& measure) {
  Peak out{{-std::numeric_limits<double>::infinity(), 0}, 0, {}};
  std::size_t point = 0, place = 0;
  for (std::size_t i = 0; i < stresses.size(); ++i)
    for (std::size_t j = 0; j < stresses[i].size(); ++j)
      if (const Stress& t = stresses[i][j]; is_known(t))
        if (const double value = measure(t); value > out.value.value)
          out = {{value, 0}, area.x[j], area.points[point = i]}, place = j;
  const auto at = [&](std::size_t i, std::size_t j) { return measure(stresses[i][j]); };
  double error = inside.traction_error * out.value;
  if (&stresses == &area.body && !area.error.empty())
    error += area.error[point];
  if (place > 0 && place + 1 < area.x.size())
    error += between(at(point, place - 1), out.value, at(point, place + 1));
  if (area.rows * area.depths == stresses.size() && area.rows > 0) {
    const std::size_t id = point % area.depths, is = point / area.depths;
    if (id > 0 && id + 1 < area.depths)
      error += between(at(point - 1, place), out.value, at(point + 1, place));
    if (is > 0 && is + 1 < area.rows)
      error += between(at(point - area.depths, place), out.value, at(point + area.depths, place));
  }
  out.value.error = error;
  return out;
}

AreaPeaks peaks_of(const StressesInside& inside, const AreaStresses& area) {
  AreaPeaks out;
  out.pmax = area.pmax;
  const auto [first, last] = std::ranges::minmax(area.points, {}, &BelowSurface::s);
  out.s = 0.5 * (first.s + last.s);
  const std::vector<Passage>& best = area.best();
  out.shear = peak_of(inside, area, best, halfspace::largest_shear);
  out.von_mises = peak_of(inside, area, best, halfspace::von_mises);
  out.flat_shear = area.body.empty() ? out.shear : peak_of(inside, area, area.flat, halfspace::largest_shear);
  out.flat_von_mises =
      area.body.empty() ? out.von_mises : peak_of(inside, area, area.flat, halfspace::von_mises);
  double largest = -1;
  for (const Passage& passage : best)
    for (const Stress& t : passage) {
      if (!is_known(t))
        continue;
      const auto [least, most] = outer_principals(t);
      out.tension = std::max(out.tension, most);
      out.compression = std::min(out.compression, least);
      if (const double value = halfspace::von_mises(t); value > largest) {
        largest = value;
        out.mean = (t.xx + t.ss + t.nn) / 3;
      }
    }
  if (!area.body.empty()) {
    out.shear_change = out.shear.value / out.flat_shear.value - 1;
    out.von_mises_change = out.von_mises.value / out.flat_von_mises.value - 1;
  }
  return out;
}

} // namespace bem_contact::inside
