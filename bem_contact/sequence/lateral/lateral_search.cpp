#include "bem_contact/sequence/lateral/lateral_search.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/sequence/lateral/settings.hpp"

#include <algorithm>
#include <cmath>
#include <set>

namespace bem_contact {

LateralSearch::LateralSearch(const Question& question, const LateralForce& rough, KnownLateralForces& known)
    : question_(question), curve_(rough, question.start, question.resultant, known) {}

std::vector<LateralSearch::Crossing> LateralSearch::crossings() {
  const std::vector<Point> points = curve_.points(question_.wanted);
  const double wanted = question_.wanted;
  std::vector<Crossing> out;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const Point &a = points[i], &b = points[i + 1];
    // A force that is met at a point counts for the interval to its right.
    if (a.force && b.force && (*a.force - wanted) * (*b.force - wanted) <= 0 && *b.force != wanted)
      out.push_back({a, b, std::lerp(a.lateral, b.lateral, (wanted - *a.force) / (*b.force - *a.force))});
  }
  return out;
}

std::optional<LateralSearch::Crossing> LateralSearch::nearest_crossing() {
  const std::vector<Crossing> all = crossings();
  const auto nearest = std::ranges::min_element(
      all, {}, [&](const Crossing& c) { return std::abs(c.about - question_.start); });
  return nearest == all.end() ? std::nullopt : std::optional(*nearest);
}

/// Where the curve passes the force between two points, mm, to `width`.
double LateralSearch::on_curve(const Crossing& crossing, double width) {
  return narrow_lateral(
             [&](double at) { return curve_(at); }, question_.wanted,
             {{crossing.low.lateral, *crossing.low.force}, {crossing.high.lateral, *crossing.high.force}}, 0,
             width)
      .lateral;
}

bool LateralSearch::passes() {
  return nearest_crossing().has_value();
}

double LateralSearch::guess() {
  const std::optional<Crossing> nearest = nearest_crossing();
  return nearest ? on_curve(*nearest, lateral_root_width) : question_.start;
}

/// A little beyond where the curve passes the force, so that the model is likely to bracket it there.
/// At least `least` from where the model was solved.
double LateralSearch::next_after(const Crossing& crossing, double least) {
  if (!crossing.low.exact && !crossing.high.exact)
    return on_curve(crossing, lateral_root_width);
  const double from = crossing.low.exact ? crossing.low.lateral : crossing.high.lateral;
  const double to = crossing.low.exact ? crossing.high.lateral : crossing.low.lateral;
  const double there =
      on_curve(crossing, std::max(double(lateral_root_width),
                                  0.2 * (lateral_overshoot - 1) * std::abs(crossing.about - from)));
  const double beyond = std::max(lateral_overshoot * std::abs(there - from), least);
  return from + std::copysign(std::min(beyond, 0.5 * std::abs(there + to - 2 * from)), to - from);
}

/// Where the curve falls least short of a force that it does not pass. Throws InputError where the model has
/// been solved there, and misses the force by more than forces scatter from element to element.
double LateralSearch::closest_approach(const LateralForce& force) {
  std::vector<Point> points = curve_.points(question_.wanted);
  std::erase_if(points, [](const Point& p) { return !p.force; });
  const auto short_of = [&](const Point& p) { return std::abs(*p.force - question_.wanted); };
  const auto nearest = std::ranges::min_element(points, {}, short_of);
  const bool solved = nearest == points.end() || std::ranges::any_of(points, [&](const Point& p) {
                        return p.exact && std::abs(p.lateral - nearest->lateral) < lateral_extremum_width;
                      });
  if (!solved)
    return nearest->lateral;
  for (const Point& p : points)
    if (p.exact && short_of(p) <= lateral_scatter * question_.resultant)
      return p.lateral;
  refuse_lateral_force(question_.wanted, reached(force));
}

/// The curve, known well where its force is least and most: what can be reached must not depend on what was
/// wanted. There the model is solved, because on a tread rough forces miss more than it changes by.
std::vector<LateralSample> LateralSearch::reached(const LateralForce& force) {
  std::vector<LateralSample> out;
  std::ranges::minmax_result<LateralSample> ends;
  const auto look = [&](double wanted) {
    out.clear();
    for (const Point& p : curve_.points(wanted))
      if (p.force)
        out.push_back({p.lateral, *p.force});
    if (!out.empty())
      ends = std::ranges::minmax(out, {}, &LateralSample::force);
  };
  look(question_.wanted);
  for (int i = 0; i < extremum_rounds && !out.empty(); ++i) {
    const auto [least, most] = ends;
    look(least.force);
    look(most.force);
  }
  std::set<double> tried;
  const auto may_be_extreme = [&](const LateralSample& p) {
    const double even = even_lateral_force * question_.resultant;
    return (p.force <= ends.min.force + even || p.force >= ends.max.force - even) &&
           !curve_.exact().contains(p.lateral) && !tried.contains(p.lateral);
  };
  for (int i = 0; i < most_lateral_steps; ++i) {
    const auto next = std::ranges::find_if(out, may_be_extreme);
    if (next == out.end())
      break;
    tried.insert(next->lateral);
    if (try_at(force, next->lateral))
      look(question_.wanted);
  }
  return out;
}

bool LateralSearch::learn(const LateralForce& force, double lateral) {
  const std::optional<double> there = force(lateral);
  if (there)
    curve_.learn({lateral, *there});
  return there.has_value();
}

/// The model's force, where the model has a solution.
bool LateralSearch::try_at(const LateralForce& force, double lateral) {
  try {
    return curve_(lateral) && learn(force, lateral);
  } catch (const InputError&) { // an influence file may not reach so far
  } catch (const ConvergenceError&) {
  }
  return false;
}

/// Displacements beside the start, if the model bears almost the force there: on a tread the curve is not
/// good enough to tell where the model passes it. The last one is the nearest.
std::vector<double> LateralSearch::beside_start(const LateralForce& force) {
  std::vector<double> out;
  const double start = question_.start;
  if (!curve_.exact().contains(start) && !try_at(force, start))
    return out;
  if (std::abs(*force_at_start() - question_.wanted) > even_lateral_force * question_.resultant)
    return out;
  for (double away = first_look_around; away < lateral_step; away *= 2)
    out.insert(out.begin(), {start - away, start + away});
  return out;
}

double LateralSearch::find(const LateralForce& force) {
  const double tolerance = lateral_tolerance * question_.resultant;
  const auto met = [&](const Point& p) {
    return p.exact && std::abs(*p.force - question_.wanted) <= tolerance;
  };
  std::vector<double> beside = beside_start(force);
  LateralSample last{question_.start, NAN};
  for (int i = 0; i < most_lateral_steps; ++i) {
    const std::optional<Crossing> c = nearest_crossing();
    if (!beside.empty() && (!c || std::abs(c->about - question_.start) > lateral_step)) {
      try_at(force, beside.back());
      beside.pop_back();
      continue;
    }
    if (c && (met(c->low) || met(c->high)))
      return met(c->low) ? c->low.lateral : c->high.lateral;
    if (c && c->low.exact && c->high.exact) {
      const auto learning = [&](double lateral) -> std::optional<double> {
        return learn(force, lateral) ? std::optional(curve_.exact().at(lateral).force) : std::nullopt;
      };
      last = narrow_lateral(learning, question_.wanted,
                            {{c->low.lateral, *c->low.force}, {c->high.lateral, *c->high.force}}, tolerance,
                            narrowest_lateral);
      if (std::abs(last.force - question_.wanted) <= tolerance)
        return last.lateral;
      break;
    }
    const double next = c ? next_after(*c, lateral_root_width * std::exp2(i)) : closest_approach(force);
    if (!c && curve_.exact().contains(next))
      return next;
    if (!learn(force, next)) {
      last = {next, NAN};
      break;
    }
    last = {next, curve_.exact().at(next).force};
    if (std::abs(last.force - question_.wanted) <= tolerance)
      return next;
  }
  refuse_search(question_.wanted, last, tolerance);
}

/// dFy/dy by the nearest solutions of the model whose forces differ enough to tell, N/mm.
std::optional<double> LateralSearch::slope_beside(double found) const {
  const auto& exact = curve_.exact();
  const auto here = exact.find(found);
  std::optional<double> slope;
  double nearest = lateral_step;
  for (const auto& [lateral, there] : exact) {
    const double apart = lateral - found, more = there.force - here->second.force;
    if (std::abs(apart) >= nearest || std::abs(more) < telling_lateral_force * question_.resultant)
      continue;
    nearest = std::abs(apart);
    slope = more / apart;
  }
  return slope;
}

LateralPosition LateralSearch::describe(double found, double error) {
  const LateralSample here{found, question_.wanted};
  const double allowed =
      question_.resultant * (std::isnan(error) ? telling_lateral_force : lateral_tolerance);
  const double within = std::isnan(error) ? allowed : std::max(error, allowed);
  const LateralSample low = curve_.leaves(here, within, -1), high = curve_.leaves(here, within, +1);
  const LateralSample& far = high.lateral - found > found - low.lateral ? high : low;
  LateralPosition out{.lateral = found,
                      .slope = (far.force - here.force) / (far.lateral - found),
                      .error = std::abs(far.lateral - found),
                      .others = {}};
  const std::optional<double> slope = slope_beside(found);
  if (slope && out.error < unsure_lateral) {
    out.slope = *slope;
    out.error = within / std::abs(*slope);
  }
  if (std::isnan(error))
    out.error = error;
  for (const Crossing& c : crossings())
    if (c.about < low.lateral || c.about > high.lateral)
      out.others.push_back(on_curve(c, other_lateral_width));
  return out;
}

std::optional<double> LateralSearch::force_at_start() const {
  const auto there = curve_.exact().find(question_.start);
  return there != curve_.exact().end() ? std::optional(there->second.force) : std::nullopt;
}

} // namespace bem_contact
