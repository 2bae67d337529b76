#include "bem_contact/sequence/scene_aids.hpp"

#include <algorithm>
#include <cmath>

namespace bem_contact {

namespace {

/// Of two intervals' shorter one, how much lies in the other.
double overlap(double a_from, double a_to, double b_from, double b_to) {
  constexpr double least = 0.2; // mm: an area may be one slice
  const double common = std::min(a_to, b_to) - std::max(a_from, b_from) + least;
  return common / (std::min(a_to - a_from, b_to - b_from) + least);
}

/// Takes [from, to] to [to_from, to_to].
struct Stretch {
  double from, to_from, factor;

  Stretch(double a_from, double a_to, double b_from, double b_to)
      : from(0.5 * (a_from + a_to)), to_from(0.5 * (b_from + b_to)),
        factor(std::max(b_to - b_from, 0.2) / std::max(a_to - a_from, 0.2)) {}
  double operator()(double v) const { return to_from + (v - from) * factor; }
};

} // namespace

bool alike(const std::vector<PotentialArea>& a, const std::vector<PotentialArea>& b) {
  constexpr double enough = 0.3;
  return a.size() == b.size() &&
         std::ranges::equal(a, b, [](const PotentialArea& one, const PotentialArea& other) {
           return overlap(one.s_from, one.s_to, other.s_from, other.s_to) > enough &&
                  overlap(one.x_from, one.x_to, other.x_from, other.x_to) > enough;
         });
}

StartingPoint start_from(const FormerTractions& former, const ContactProblem& problem,
                         const std::vector<PotentialArea>& areas, double force) {
  const ContactGrid &to = problem.grid, &from = former.grid;
  const double scale = force > 0 && former.force > 0 ? std::cbrt(force / former.force) : 1.0;
  StartingPoint start;
  start.approach = former.approach * scale * scale;
  start.px.assign(to.size(), 0.0);
  start.ps = start.pn = start.px;
  std::size_t k = 0; // the nearest area
  for (int is = 0; is < to.ms && !areas.empty(); ++is) {
    const double here = problem.rows[is].s;
    while (k + 1 < areas.size() && here > 0.5 * (areas[k].s_to + areas[k + 1].s_from))
      ++k;
    const PotentialArea &a = areas[k], &b = former.areas[k];
    const double row = (Stretch(a.s_from, a.s_to, b.s_from, b.s_to)(here) - former.first_s) / from.ds;
    if (!(row > 0 && row < from.ms - 1))
      continue;
    const Stretch along_x(a.x_from, a.x_to, b.x_from, b.x_to);
    for (int ix = 0; ix < to.mx; ++ix) {
      const double column = (along_x(to.x(ix)) - from.x0) / from.dx;
      if (!(column > 0 && column < from.mx - 1))
        continue;
      const int i = static_cast<int>(row), j = static_cast<int>(column);
      const double t = row - i, u = column - j;
      const auto mean = [&](const auto& at) {
        return (1 - t) * ((1 - u) * at(0) + u * at(1)) + t * ((1 - u) * at(from.mx) + u * at(from.mx + 1));
      };
      const std::size_t corner = static_cast<std::size_t>(i) * from.mx + j;
      // in contact where most of its corners were, or the start would have an element more all around
      if (mean([&](int c) { return former.pn[corner + c] > 0 ? 1.0 : 0.0; }) < 0.5)
        continue;
      const auto value = [&](const std::vector<double>& f) {
        return scale * mean([&](int c) { return f[corner + c]; });
      };
      const int element = is * to.mx + ix;
      start.px[element] = value(former.px);
      start.ps[element] = value(former.ps);
      start.pn[element] = value(former.pn);
    }
  }
  return start;
}

} // namespace bem_contact
