#include "bem_contact/sequence/lateral/lateral_search.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/sequence/lateral/settings.hpp"

#include <boost/math/tools/minima.hpp>

#include <algorithm>
#include <cmath>

namespace bem_contact {

namespace {

/// 1 (lateral::unsure). Displacements of the curve are found to a tenth of what a warning tells.
constexpr double finest = 0.1;
/// 1. The model's own extremum is found to 2^-17 of its displacement: a second contact makes it a kink,
/// beside which a force may change by some N in a micrometre.
constexpr int model_extremum_bits = 18;
/// 1, of the resultant. A force that lies no farther beyond the range of rough solutions may be the model's:
/// on worn profiles rough forces are off by some thousandths.
constexpr double near_range = 0.01;

} // namespace

LateralSearch::LateralSearch(const Question& question, const LateralForce& rough, KnownLateralForces& known)
    : question_(question), curve_(rough, question.resultant, known) {}

bool LateralSearch::met(double force) const {
  return std::abs(force - question_.wanted) <= Certificate().tolerance * question_.resultant;
}

bool LateralSearch::start_may_bear() {
  const std::optional<double> there = curve_(question_.start);
  return there && std::abs(*there - question_.wanted) <= lateral::near * question_.resultant;
}

/// All branches, by rough solutions.
void LateralSearch::survey() {
  if (!surveyed_) {
    curve_.survey(question_.start);
    curve_.survey_extrema(question_.wanted);
    if (crossings().empty())
      survey_range();
  }
  surveyed_ = true;
}

/// Where the curve is least and most: between rough solutions it may reach farther than they tell.
void LateralSearch::survey_range() {
  const double even = lateral::uneven * question_.resultant;
  std::optional<double> least, most;
  for (const Point& p : curve_.points())
    if (p.force) {
      least = std::min(least.value_or(*p.force), *p.force);
      most = std::max(most.value_or(*p.force), *p.force);
    }
  if (!least)
    return;
  curve_.survey_extrema(*least - even);
  curve_.survey_extrema(*most + even);
}

std::vector<LateralSearch::Crossing> LateralSearch::crossings() const {
  const std::vector<Point> points = curve_.points();
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

std::optional<LateralSearch::Crossing> LateralSearch::nearest_crossing() const {
  const std::vector<Crossing> all = crossings();
  const auto nearest = std::ranges::min_element(
      all, {}, [&](const Crossing& c) { return std::abs(c.about - question_.start); });
  return nearest == all.end() ? std::nullopt : std::optional(*nearest);
}

/// Where the curve passes the force between two points, mm, to a tenth of what is told apart.
double LateralSearch::on_curve(const Crossing& crossing) {
  return narrow_lateral([&](double at) { return curve_(at); }, question_.wanted,
                        {crossing.low.sample(), crossing.high.sample()}, 0, finest * lateral::unsure)
      .lateral;
}

bool LateralSearch::passes() {
  survey();
  return nearest_crossing().has_value();
}

double LateralSearch::guess() {
  survey();
  const std::optional<Crossing> nearest = nearest_crossing();
  return nearest ? on_curve(*nearest) : question_.start;
}

/// The model's force, which the curve learns; nothing where the model has no solution.
std::optional<double> LateralSearch::try_at(const LateralForce& force, double lateral) {
  if (const std::optional<double> known = curve_.exact(lateral))
    return known;
  std::optional<double> there;
  try {
    there = force(lateral);
  } catch (const InputError&) { // an influence file may not reach so far
  } catch (const ConvergenceError&) {
  }
  if (there)
    curve_.learn({lateral, *there});
  return there;
}

/// If the model bears almost the force at the start: the nearest displacements beside it that bracket the
/// force. On a tread the curve is not good enough to tell where the model passes it.
std::optional<LateralBracket> LateralSearch::beside_start(const LateralForce& force) {
  const std::optional<double> there = force_at_start();
  if (!there || std::abs(*there - question_.wanted) > lateral::uneven * question_.resultant)
    return std::nullopt;
  return bracket_lateral_beside([&](double at) { return try_at(force, at); }, question_.wanted,
                                {question_.start, *there}, lateral::unsure, lateral::spacing);
}

/// The model's own bracket about a displacement where the curve passes the force, from where the model is
/// known `within` (mm) of it. Nothing if the model does not pass it there; the curve then knows better.
std::optional<LateralBracket> LateralSearch::bracket(const LateralForce& force, const Crossing& crossing,
                                                     double within) {
  std::optional<LateralSample> from;
  double force_there = 1; // beyond the wanted one
  for (const int side : {-1, 1}) {
    const std::optional<LateralSample> beside =
        curve_.exact_beside(side < 0 ? crossing.low.lateral : crossing.high.lateral, side);
    if (!beside || std::abs(beside->lateral - crossing.about) > within)
      continue;
    if (met(beside->force))
      return LateralBracket{*beside, *beside};
    if (from && (beside->force - question_.wanted) * force_there < 0)
      return LateralBracket{*from, *beside};
    force_there = beside->force - question_.wanted;
    if (!from || std::abs(beside->lateral - crossing.about) < std::abs(from->lateral - crossing.about))
      from = beside;
  }
  if (!from) {
    const double at = on_curve(crossing);
    const std::optional<double> there = force(at);
    if (!there)
      refuse_search(question_.wanted, {at, NAN}, Certificate().tolerance * question_.resultant);
    curve_.learn({at, *there});
    return std::nullopt;
  }
  // Rough forces are uneven: beside a displacement that almost bears the force, the curve may pass it on the
  // wrong side.
  const double step = crossing.about - from->lateral, least = finest * lateral::unsure;
  return bracket_lateral_beside([&](double at) { return try_at(force, at); }, question_.wanted, *from,
                                std::copysign(std::max(std::abs(step), least), step), lateral::spacing);
}

/// Where the curve comes nearest to a force that it does not pass: the model there, or at its own extremum
/// beside it. Throws InputError where the force is missed by too much.
std::optional<double> LateralSearch::try_extremum(const LateralForce& force, bool last) {
  const auto misses = [&](const LateralSample& s) { return std::abs(s.force - question_.wanted); };
  const auto searched = [&](const Point& p) {
    return std::ranges::any_of(searched_,
                               [&](double at) { return std::abs(at - p.lateral) <= 0.5 * lateral::spacing; });
  };
  std::optional<LateralSample> nearest;
  for (const Point& p : curve_.points())
    if (p.force && !searched(p) && (!nearest || misses(p.sample()) < misses(*nearest)))
      nearest = p.sample();
  if (!nearest || last) {
    refuse(force);
    return std::nullopt;
  }
  if (!curve_.exact_within(nearest->lateral, lateral::unsure)) {
    const std::optional<double> there = try_at(force, nearest->lateral);
    if (there)
      return there;
  }
  // On a tread there are many places with almost the same force: each may have an extremum of its own.
  if (misses(*nearest) > (searched_.empty() ? lateral::near : lateral::uneven) * question_.resultant) {
    refuse(force);
    return std::nullopt;
  }
  searched_.push_back(nearest->lateral);
  const double sign = nearest->force < question_.wanted ? 1 : -1, about = nearest->lateral;
  double best = -sign * nearest->force;
  boost::math::tools::brent_find_minima(
      [&](double at) {
        if (-best >= sign * question_.wanted) // found: no more solutions
          return best;
        const double there = -sign * try_at(force, at).value_or(nearest->force);
        best = std::min(best, there);
        return there;
      },
      std::max(about - 0.5 * lateral::spacing, question_.start - lateral::reach),
      std::min(about + 0.5 * lateral::spacing, question_.start + lateral::reach), model_extremum_bits);
  return nearest->force;
}

/// Throws InputError, or finds out that the model passes the force. What can be reached must not depend on
/// what was wanted. So the curve is surveyed where its force is least and most, and there the model is
/// solved, because on a tread rough forces miss more than the force changes by. A force just beyond what
/// rough solutions reach is looked for wherever they come near to it.
void LateralSearch::refuse(const LateralForce& force) {
  const double even = lateral::uneven * question_.resultant, near = near_range * question_.resultant;
  std::vector<double> tried;
  std::vector<LateralSample> samples;
  const auto look = [&] {
    samples.clear();
    for (const Point& p : curve_.points())
      if (p.force && (p.exact || !curve_.exact_within(p.lateral, lateral::unsure)) &&
          (p.exact || std::ranges::find(tried, p.lateral) == tried.end()))
        samples.push_back(p.sample());
    if (samples.empty())
      refuse_lateral_force(question_.wanted, samples);
    return std::ranges::minmax(samples, {}, &LateralSample::force);
  };
  survey_range();
  for (;;) {
    const auto looked = look();
    const auto &least = looked.min, &most = looked.max;
    const double wanted = question_.wanted;
    const double low = wanted < least.force && wanted > least.force - near ? near : even,
                 high = wanted > most.force && wanted < most.force + near ? near : even;
    const auto next = std::ranges::find_if(samples, [&](const LateralSample& s) {
      return !curve_.exact(s.lateral) && (s.force <= least.force + low || s.force >= most.force - high);
    });
    if (next == samples.end())
      refuse_lateral_force(question_.wanted, samples);
    tried.push_back(next->lateral);
    try_at(force, next->lateral);
    if (!crossings().empty())
      return;
  }
}

double LateralSearch::find(const LateralForce& force) {
  const double wanted = question_.wanted, tolerance = Certificate().tolerance * question_.resultant;
  try_at(force, question_.start);
  if (const std::optional<double> there = force_at_start(); there && met(*there))
    return question_.start;
  std::optional<LateralBracket> found = beside_start(force);
  if (!found)
    survey();
  const int rounds = static_cast<int>(2 * lateral::reach / lateral::spacing); // more do not tell more
  for (int round = 1; !found; ++round) {
    const std::optional<Crossing> crossing = nearest_crossing();
    if (crossing && round > rounds)
      refuse_search(wanted, {crossing->about, NAN}, tolerance);
    if (crossing) {
      // First the curve tells where: it is better than steps from a start that is not near.
      found = bracket(force, *crossing, round == 1 ? lateral::unsure : lateral::spacing);
      continue;
    }
    try_extremum(force, round > rounds);
    if (const std::optional<LateralSample> nearest = curve_.nearest_exact(wanted);
        nearest && met(nearest->force))
      found = {*nearest, *nearest};
  }
  const LateralSample root = narrow_lateral(force, wanted, *found, tolerance, narrowest_bracket());
  if (!met(root.force))
    refuse_search(wanted, root, tolerance);
  curve_.learn(root);
  return root.lateral;
}

LateralPosition LateralSearch::describe(double found, double error) {
  const LateralSpread spread =
      lateral_spread([&](double at) { return curve_.rough(at); }, found, error, question_.resultant);
  LateralPosition out{.lateral = {found, spread.error}, .slope = spread.slope, .others = {}};
  const std::optional<double> slope =
      curve_.slope_beside({found, question_.wanted}, lateral::uneven * question_.resultant);
  if (slope && !(spread.error >= lateral::unsure)) {
    out.slope = *slope;
    out.lateral.error = error / std::abs(*slope);
  }
  const double known = std::isnan(error) ? 0 : 1;
  const double from = found - std::max(known * spread.low, double(lateral::unsure)),
               to = found + std::max(known * spread.high, double(lateral::unsure));
  if (surveyed_)
    for (const Crossing& c : crossings())
      if (c.about < from || c.about > to)
        out.others.push_back(on_curve(c));
  return out;
}

} // namespace bem_contact
