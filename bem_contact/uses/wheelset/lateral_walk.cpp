#include "bem_contact/uses/wheelset/lateral_walk.hpp"

#include "bem_contact/base/error.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace bem_contact {

namespace {

/// mm. First step of the lateral search, and factor by which the next one is longer as long as the force is
/// not passed.
constexpr double first_lateral_step = 0.25;
/// 1. Factor by which the next step is longer. Chosen.
constexpr double lateral_step_growth = 1.4;
/// mm. Shortest step towards displacements at which the wheelset does not stand: two flanges in their gauge
/// corners have some hundredths.
constexpr double least_lateral_step = 2e-3;
/// mm. The search ends so far from position.lateral: a wheelset has some 7 mm to either side.
constexpr double lateral_search_reach = 14.0;
/// 1. An interval that holds such a displacement gets narrower by at least this share of it.
constexpr double least_narrowing = 0.15;
/// mm. Rough displacements are found within this.
constexpr double rough_lateral_width = 0.03;

/// Narrows an interval at whose ends the force is on different sides of `wanted`: where the line between
/// both meets it, but not too near to an end, because on a flange the force is no line. Where no equilibrium
/// is found, nearer to `a`: an equilibrium leads to those beside it.
LateralRoot narrow(const LateralForce& force, LateralSample a, LateralSample b, double wanted) {
  const double first_slope = (b.force - a.force) / (b.lateral - a.lateral);
  const auto met = [&] { return (wanted - a.force) / (b.force - a.force); };
  double reach = 1; // share of the way to b that leads to an equilibrium
  while (std::abs(b.lateral - a.lateral) > rough_lateral_width) {
    const double share = reach * std::clamp(met(), least_narrowing, 1 - least_narrowing);
    const double between = a.lateral + share * (b.lateral - a.lateral);
    const std::optional<double> there = force(between);
    if (!there) {
      reach *= 0.5;
      if (reach * std::abs(b.lateral - a.lateral) < least_lateral_step)
        break;
      continue;
    }
    reach = std::min(1.0, 2 * reach);
    auto& replaced = (*there - wanted) * (a.force - wanted) > 0 ? a : b;
    replaced = {between, *there};
  }
  const double slope = (b.force - a.force) / (b.lateral - a.lateral);
  return slope * first_slope > 0
             ? LateralRoot{a.lateral + (wanted - a.force) / slope, slope}
             : LateralRoot{a.lateral, first_slope}; // rough forces so near to each other say nothing
}

/// Moves `best` to where the force is largest (side -1: least) around it, or to the first one that reaches
/// `wanted`. The last displacement that is tried lies beyond it.
void climb(const LateralForce& force, double side, double wanted, LateralSample& best) {
  for (double step = 0.5 * largest_lateral_step; step > least_lateral_step;) {
    const double before = best.lateral;
    for (const double way : {-side, side}) {
      const double at = before + way * step;
      const std::optional<double> there = force(at);
      if (there && side * (*there - best.force) > 0)
        best = {at, *there};
      if (side * (best.force - wanted) >= 0)
        return;
    }
    if (best.lateral == before)
      step *= 0.5;
  }
}

/// Steps from the start of a search to one side, until the force passes the wanted one.
class Walk {
public:
  /// `side`: -1 or 1; `up`: 1 where the force must grow from the start to be met, else -1.
  Walk(const LateralForce& force, const LateralSample& start, double side, double up, double wanted)
      : best(start), force_(force), start_(start), here_(start), side_(side), up_(up), wanted_(wanted) {}

  /// One step. True if the force passes the wanted one between `before` and `beyond`.
  bool step() {
    const double at = here_.lateral + side_ * step_;
    const std::optional<double> there = force_(at);
    if (!there) {
      step_ *= 0.5;
      ended |= step_ < least_lateral_step;
      return false;
    }
    beyond = {at, *there};
    ended |= std::abs(at - start_.lateral) >= lateral_search_reach;
    if (up_ * (*there - wanted_) >= 0) {
      before = here_;
      return true;
    }
    if (up_ * (*there - best.force) > 0) {
      before = here_;
      best = beyond;
    }
    here_ = beyond;
    step_ = std::min(lateral_step_growth * step_, largest_lateral_step);
    return false;
  }

  bool ended = false;
  LateralSample best, before = best, beyond = best; ///< the best so far, and the one before it

private:
  const LateralForce& force_;
  LateralSample start_, here_;
  double side_, up_, wanted_;
  double step_ = first_lateral_step;
};

} // namespace

std::optional<LateralRoot> search_lateral(const LateralForce& force, const LateralSample& start,
                                          double wanted, bool near, LateralSample& best) {
  const double up = start.force < wanted ? 1 : -1;
  Walk walk(force, start, up, up, wanted), back(force, start, -up, up, wanted);
  const auto bracketed = [&](const Walk& w) { return narrow(force, w.before, w.beyond, wanted); };
  bool falls = near, first = true;
  while (!walk.ended || (falls && !back.ended)) {
    if (!walk.ended && walk.step())
      return bracketed(walk);
    falls |= first && up * (walk.beyond.force - start.force) < 0;
    first &= walk.beyond.lateral == start.lateral;
    if (falls && !back.ended && back.step())
      return bracketed(back);
  }
  best = walk.best;
  climb(force, up, wanted, best);
  return up * (best.force - wanted) >= 0 ? std::optional(narrow(force, walk.before, best, wanted))
                                         : std::nullopt;
}

void refuse_lateral(const FailedSearch& f) {
  const bool more = f.best.force < f.wanted;
  throw InputError(
      fmt::format("No lateral displacement gives the wheelset a lateral force of {:g} N{}", f.wanted,
                  f.of_curve != 0 ? fmt::format(" (in which {:g} N are the curve's)", f.of_curve) : ""),
      fmt::format(
          "by a search with larger elements, from {:g} mm on the rails bear {} about {:.1e} N, at about "
          "{:.1f} mm; beyond that {}",
          f.start, more ? "up to" : "down to", f.best.force, f.best.lateral,
          f.lifts ? "a wheel lifts from its rail" : "the flange climbs the rail"),
      fmt::format("Give a wheelset.force_y {} that, {}, or another position.lateral.",
                  more ? "below" : "above",
                  f.lifts && f.roll_moment != 0 ? "a wheelset.roll_moment nearer to 0" : "less friction"));
}

} // namespace bem_contact
