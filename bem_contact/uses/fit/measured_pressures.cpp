#include "bem_contact/uses/fit/measured_pressures.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/uses/curves/differences.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace bem_contact::fit {

namespace {

/// A place among middles with equal steps: the one before, and the share of the one after. Beside them the
/// numbers reach beyond the ends.
struct Between {
  int before = 0;
  double share = 0;

  Between(double at, double first, double step) {
    const double index = (at - first) / step, whole = std::clamp(std::floor(index), -1e6, 1e6);
    before = static_cast<int>(whole);
    share = std::clamp(index - whole, 0.0, 1.0);
  }
};

/// The pressures of a result on its grid; 0 beside it.
class Pressures {
public:
  explicit Pressures(const SceneResult& result) : problem_(result.problem), pn_(result.result.pn) {}

  double at(double x, double s) const {
    const Between column(x, problem_.grid.x0, problem_.grid.dx), row = row_of(s);
    return (1 - row.share) * on_row(row.before, column) + row.share * on_row(row.before + 1, column);
  }
  double largest_over_x(double s) const {
    const Between row = row_of(s);
    double out = 0;
    for (int ix = 0; ix < problem_.grid.mx; ++ix)
      out = std::max(out, (1 - row.share) * of(ix, row.before) + row.share * of(ix, row.before + 1));
    return out;
  }
  double largest_over_s(double x) const {
    const Between column(x, problem_.grid.x0, problem_.grid.dx);
    double out = 0;
    for (int is = 0; is < problem_.grid.ms; ++is)
      out = std::max(out, on_row(is, column));
    return out;
  }

private:
  double of(int ix, int is) const {
    const bool on_grid = ix >= 0 && ix < problem_.grid.mx && is >= 0 && is < problem_.grid.ms;
    return on_grid ? pn_[static_cast<std::size_t>(is) * problem_.grid.mx + ix] : 0;
  }
  double on_row(int is, const Between& column) const {
    return (1 - column.share) * of(column.before, is) + column.share * of(column.before + 1, is);
  }
  Between row_of(double s) const { return {s, problem_.rows.front().s, problem_.grid.ds}; }

  const ContactProblem& problem_;
  const std::vector<double>& pn_;
};

} // namespace

bool holds_pressures(const std::vector<std::string>& columns) {
  return std::ranges::find(columns, "pn") != columns.end();
}

MeasuredPressures measured_pressures(const std::string& source, const std::vector<std::string>& columns,
                                     const std::vector<std::vector<double>>& rows) {
  std::vector<std::string> names = columns;
  const bool scatter = !names.empty() && names.back() == "scatter";
  if (scatter)
    names.pop_back();
  using Names = std::vector<std::string>;
  MeasuredPressures out{
      .line = PressureLine::over_s, .x = {}, .s = {}, .measured = {}, .scatter = {}, .source = source};
  if (names == Names{"x", "pn"})
    out.line = PressureLine::over_x;
  else if (names == Names{"x", "s", "pn"})
    out.line = PressureLine::places;
  else if (names != Names{"s", "pn"})
    throw InputError(fmt::format("The table '{}' holds no measured pressures", source),
                     fmt::format("its columns are {}", fmt::join(columns, ", ")),
                     "Begin it with s,pn or x,pn (the largest pressure along the other axis) or x,s,pn, and "
                     "scatter if it is known.");
  for (const std::vector<double>& row : rows) {
    if (out.line != PressureLine::over_s)
      out.x.push_back(row[0]);
    if (out.line != PressureLine::over_x)
      out.s.push_back(row[names.size() - 2]);
    out.measured.push_back(row[names.size() - 1]);
    if (scatter)
      out.scatter.push_back(row.back());
    if (out.measured.back() < 0 || (scatter && row.back() < 0))
      throw InputError(fmt::format("The table '{}' cannot be used", source),
                       fmt::format("its row {} has a pressure or a scatter below 0", out.measured.size()),
                       "Correct it; pressures are positive.");
  }
  return out;
}

std::vector<double> pressures_at(const MeasuredPressures& places, const SceneResult& result) {
  const Pressures pressures(result);
  std::vector<double> out;
  for (std::size_t i = 0; i < places.measured.size(); ++i)
    out.push_back(places.line == PressureLine::over_s   ? pressures.largest_over_x(places.s[i])
                  : places.line == PressureLine::over_x ? pressures.largest_over_s(places.x[i])
                                                        : pressures.at(places.x[i], places.s[i]));
  return out;
}

record::Record record_of(const MeasuredPressures& m) {
  using record::Column;
  const bool over_x = m.line == PressureLine::over_x;
  Column place{over_x ? "x" : "s", "mm", "where it was measured", over_x ? m.x : m.s},
      measured{"measured", "MPa", "pressure", m.measured},
      scatter{"scatter", "MPa", "standard deviation of what was measured", m.scatter},
      computed{"computed", "MPa", "pressure", m.computed};
  const Differences differences(m.computed, m.measured, m.scatter);
  const Column difference{"difference", "MPa", "computed less measured", differences.each};
  record::Table table{"point", {place}};
  if (m.line == PressureLine::places)
    table.columns.push_back({"x", "mm", "where it was measured", m.x});
  table.columns.push_back(measured);
  if (!m.scatter.empty())
    table.columns.push_back(scatter);
  table.columns.push_back(computed);
  table.columns.push_back(difference);
  record::Record out{{"over", record::Text{over_x ? "x" : "s"}},
                     {"mean_difference", record::Number{differences.mean, "MPa", "computed less measured"}},
                     {"largest_difference", record::Number{differences.largest, "MPa", "of the magnitudes"}},
                     {"certified", m.certified}};
  if (!m.scatter.empty())
    out.add("within_scatter", record::Number{double(differences.within_scatter),
                                             "1",
                                             "points whose difference is within their scatter",
                                             {},
                                             true});
  return out.add("points", std::move(table));
}

} // namespace bem_contact::fit
