#include "bem_contact/sequence/solution/warm_start.hpp"
#include "bem_contact/sequence/solution/settings.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace bem_contact {

namespace {

/// The share of the shorter of two intervals that lies within the other one.
double overlap(double a_from, double a_to, double b_from, double b_to) {
  const double common = std::min(a_to, b_to) - std::max(a_from, b_from) + least_extent;
  return common / (std::min(a_to - a_from, b_to - b_from) + least_extent);
}

/// Maps interval a to interval b: middle to middle, and length to length.
struct Stretch {
  double from, to_from, factor;

  Stretch(double a_from, double a_to, double b_from, double b_to)
      : from(0.5 * (a_from + a_to)), to_from(0.5 * (b_from + b_to)),
        factor(std::max(b_to - b_from, double(least_extent)) /
               std::max(a_to - a_from, double(least_extent))) {}
  double operator()(double v) const { return to_from + (v - from) * factor; }
};

/// The tractions of a former solution between the middles of its elements.
class FormerFields {
public:
  explicit FormerFields(const FormerSolution& former) : former_(former) {}

  /// Moves to a place, given as row and column of the former grid. Returns false outside that grid, and where
  /// most of the elements around the place were not in contact: otherwise the start would be larger than the
  /// former contact by one element on every side.
  bool move_to(double row, double column) {
    const ContactGrid& grid = former_.grid;
    if (!(row > 0 && row < grid.ms - 1) || !(column > 0 && column < grid.mx - 1))
      return false;
    const int i = static_cast<int>(row), j = static_cast<int>(column);
    t_ = row - i, u_ = column - j;
    corner_ = static_cast<std::size_t>(i) * grid.mx + j;
    return mean([&](std::size_t c) { return former_.pn[c] > 0 ? 1.0 : 0.0; }) >= 0.5;
  }
  double operator()(const std::vector<double>& field) const {
    return mean([&](std::size_t c) { return field[c]; });
  }

private:
  template <class Value> double mean(const Value& at) const {
    const std::size_t next = corner_ + former_.grid.mx;
    return (1 - t_) * ((1 - u_) * at(corner_) + u_ * at(corner_ + 1)) +
           t_ * ((1 - u_) * at(next) + u_ * at(next + 1));
  }

  const FormerSolution& former_;
  double t_ = 0, u_ = 0;
  std::size_t corner_ = 0;
};

} // namespace

std::optional<FormerSolution> former_of(Model model, const ContactProblem& problem,
                                        const ContactResult& result, const ContactEstimate& estimate) {
  if (!(result.certified() || result.trust.ended_early) || result.patches.empty() || !(estimate.approach > 0))
    return std::nullopt;
  return FormerSolution{problem.grid,
                        problem.rows.front().s,
                        result.totals.Fz,
                        result.totals.approach,
                        potential_areas(estimate),
                        result.px,
                        result.ps,
                        result.pn,
                        model};
}

bool alike(const std::vector<PotentialArea>& a, const std::vector<PotentialArea>& b) {
  return a.size() == b.size() &&
         std::ranges::equal(a, b, [](const PotentialArea& one, const PotentialArea& other) {
           return overlap(one.s_from, one.s_to, other.s_from, other.s_to) > alike_overlap &&
                  overlap(one.x_from, one.x_to, other.x_from, other.x_to) > alike_overlap;
         });
}

PotentialArea expected_contact(const FormerSolution& former, const std::vector<PotentialArea>& areas) {
  const ContactGrid& grid = former.grid;
  constexpr double far = std::numeric_limits<double>::infinity();
  const PotentialArea none{far, -far, far, -far};
  const auto add = [](PotentialArea& to, const PotentialArea& more) {
    to = {std::min(to.s_from, more.s_from), std::max(to.s_to, more.s_to), std::min(to.x_from, more.x_from),
          std::max(to.x_to, more.x_to)};
  };
  std::vector<PotentialArea> touched(areas.size(), none);
  std::size_t k = 0; // the nearest area
  for (int is = 0; is < grid.ms; ++is) {
    const double s = former.first_s + is * grid.ds;
    while (k + 1 < areas.size() && s > 0.5 * (former.areas[k].s_to + former.areas[k + 1].s_from))
      ++k;
    for (int ix = 0; ix < grid.mx; ++ix)
      if (former.pn[static_cast<std::size_t>(is) * grid.mx + ix] > 0)
        add(touched[k], {s, s, grid.x(ix), grid.x(ix)});
  }
  PotentialArea all = none;
  for (k = 0; k < areas.size(); ++k) {
    const PotentialArea &a = areas[k], &b = former.areas[k], &t = touched[k];
    if (t.s_from > t.s_to) {
      add(all, a);
      continue;
    }
    const Stretch along_s(b.s_from, b.s_to, a.s_from, a.s_to), along_x(b.x_from, b.x_to, a.x_from, a.x_to);
    add(all, {along_s(t.s_from), along_s(t.s_to), along_x(t.x_from), along_x(t.x_to)});
  }
  return all;
}

StartingPoint start_from(const FormerSolution& former, const ContactProblem& problem,
                         const std::vector<PotentialArea>& areas, double force) {
  const ContactGrid &to = problem.grid, &from = former.grid;
  const double scale = force > 0 && former.force > 0 ? std::cbrt(force / former.force) : 1.0;
  StartingPoint start;
  start.approach = former.approach * scale * scale;
  start.px.assign(to.size(), 0.0);
  start.ps = start.pn = start.px;
  FormerFields value(former);
  std::size_t k = 0; // the nearest area
  for (int is = 0; is < to.ms && !areas.empty(); ++is) {
    const double here = problem.rows[is].s;
    while (k + 1 < areas.size() && here > 0.5 * (areas[k].s_to + areas[k + 1].s_from))
      ++k;
    const PotentialArea &a = areas[k], &b = former.areas[k];
    const double row = (Stretch(a.s_from, a.s_to, b.s_from, b.s_to)(here) - former.first_s) / from.ds;
    const Stretch along_x(a.x_from, a.x_to, b.x_from, b.x_to);
    for (int ix = 0; ix < to.mx; ++ix) {
      if (!value.move_to(row, (along_x(to.x(ix)) - from.x0) / from.dx))
        continue;
      const int element = is * to.mx + ix;
      start.px[element] = scale * value(former.px);
      start.ps[element] = scale * value(former.ps);
      start.pn[element] = scale * value(former.pn);
    }
  }
  return start;
}

} // namespace bem_contact
