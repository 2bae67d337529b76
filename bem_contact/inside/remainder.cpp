#include "bem_contact/inside/remainder.hpp"

#include "bem_contact/base/lagrange.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace bem_contact::inside {

using halfspace::Stress;

Stress difference(const Stress& a, const Stress& b) {
  Stress out = a;
  return out.add(-1, b);
}

namespace {

/// Lagrange's weights of some places for one.
template <std::size_t n> std::array<double, n> weights(const std::array<double, n>& places, double at) {
  std::array<double, n> out{};
  lagrange_weights(places, at, out);
  return out;
}

/// nn, xn and sn of the first, the others of the second.
Stress joined(const Stress& across, const Stress& along) {
  return {along.xx, along.ss, across.nn, along.xs, across.xn, across.sn};
}

} // namespace

Remainder towards_surface(std::span<const Passage> helpers, double depth, double error) {
  const auto& d = helper_depths;
  const auto along = weights<3>({d[0], d[1], d[2]}, depth), across = weights<3>({0, d[0], d[1]}, depth);
  const auto line_along = weights<2>({d[0], d[1]}, depth), line_across = weights<2>({0, d[0]}, depth);
  Remainder out{{}, error};
  double curved = 0;
  for (std::size_t j = 0; j < helpers[0].size(); ++j) {
    const Stress &a = helpers[0][j], &b = helpers[1][j], &c = helpers[2][j];
    Stress parabola_along, parabola_across, line, line_to_zero;
    parabola_along.add(along[0], a).add(along[1], b).add(along[2], c);
    parabola_across.add(across[1], a).add(across[2], b);
    line.add(line_along[0], a).add(line_along[1], b);
    line_to_zero.add(line_across[1], a);
    out.stresses.push_back(joined(parabola_across, parabola_along));
    curved = std::max(curved, von_mises(difference(out.stresses.back(), joined(line_to_zero, line))));
  }
  out.error += curved;
  return out;
}

AreaPlan::AreaPlan(std::span<const BelowSurface> points, double least, const IsBelow& is_below)
    : least_depth(least), own(points.size(), -1), first_helper(points.size(), -1) {
  for (std::size_t i = 0; i < points.size(); ++i)
    if (points[i].depth >= least_depth && is_below(points[i])) {
      own[i] = static_cast<int>(probes.size());
      probes.push_back(points[i]);
    }
  std::vector<std::pair<double, int>> known; // arc lengths that have helpers
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (own[i] >= 0 || !is_below(points[i]))
      continue;
    const double s = points[i].s;
    auto found = std::ranges::find(known, s, &std::pair<double, int>::first);
    if (found == known.end()) {
      found = known.insert(known.end(), {s, static_cast<int>(probes.size())});
      for (const double depth : helper_depths)
        probes.push_back({s, depth * least_depth});
    }
    first_helper[i] = found->second;
  }
}

void add_remainder(AreaStresses& area, const AreaPlan& plan, const ProbedRemainder& rest) {
  for (std::size_t i = 0; i < area.points.size(); ++i) {
    Remainder at;
    if (plan.own[i] >= 0) {
      const auto probe = static_cast<std::size_t>(plan.own[i]);
      at = {rest.stresses[probe], rest.error[probe]};
    } else if (plan.first_helper[i] >= 0) {
      const auto first = static_cast<std::size_t>(plan.first_helper[i]);
      at = towards_surface(std::span(rest.stresses).subspan(first, helper_depths.size()),
                           area.points[i].depth / plan.least_depth, rest.error[first]);
    } else {
      constexpr double none = std::numeric_limits<double>::quiet_NaN();
      at.stresses.assign(area.x.size(), {none, none, none, none, none, none});
    }
    Passage sum = area.flat[i];
    for (std::size_t j = 0; j < sum.size(); ++j)
      sum[j].add(1, at.stresses[j]);
    area.body.push_back(std::move(sum));
    area.error.push_back(at.error);
  }
}

} // namespace bem_contact::inside
