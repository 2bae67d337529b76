#include "bem_contact/sequence/lateral/lateral_force.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/sequence/lateral/settings.hpp"

#include <boost/math/tools/toms748_solve.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace bem_contact {

namespace {

/// What ends a search from a callback of the library.
struct NoForce {};

} // namespace

LateralSample narrow_lateral(const LateralForce& force, double wanted, const LateralBracket& bracket,
                             double tolerance, double width) {
  LateralSample best = std::abs(bracket.low.force - wanted) < std::abs(bracket.high.force - wanted)
                           ? bracket.low
                           : bracket.high;
  const auto excess = [&](double lateral) {
    const std::optional<double> there = force(lateral);
    if (!there)
      throw NoForce{};
    if (std::abs(*there - wanted) < std::abs(best.force - wanted))
      best = {lateral, *there};
    return std::abs(*there - wanted) <= tolerance ? 0.0 : *there - wanted;
  };
  const auto enough = [&](double a, double b) {
    return std::abs(best.force - wanted) <= tolerance || std::abs(b - a) < width;
  };
  std::uintmax_t calls = most_lateral_calls;
  try {
    boost::math::tools::toms748_solve(excess, bracket.low.lateral, bracket.high.lateral,
                                      bracket.low.force - wanted, bracket.high.force - wanted, enough, calls);
  } catch (const NoForce&) { // the best sample stands
  }
  return best;
}

void refuse_search(double wanted, const LateralSample& last, double tolerance) {
  throw ConvergenceError(
      fmt::format("No lateral displacement with a lateral force of {:g} N was found", wanted),
      std::isnan(last.force)
          ? fmt::format("at {:.9g} mm, where it should be, there is no solution", last.lateral)
          : fmt::format(
                "the search ended at {:.9g} mm with {:.9g} N: {:.2g} N are missing, and {:.2g} N allowed",
                last.lateral, last.force, std::abs(wanted - last.force), tolerance),
      "Give position.lateral near the displacement, or another force_y.");
}

double solve_lateral_force(const LateralForce& force, double wanted, const LateralRoot& start,
                           double tolerance) {
  const auto at = [&](double lateral) {
    const std::optional<double> there = force(lateral);
    if (!there)
      refuse_search(wanted, {lateral, NAN}, tolerance);
    return LateralSample{lateral, *there};
  };
  LateralSample here = at(start.lateral);
  double slope = start.slope;
  for (int i = 0; i < most_lateral_steps; ++i) {
    const double missing = wanted - here.force;
    if (std::abs(missing) <= tolerance)
      return here.lateral;
    // Beyond the force by a little, so that the next step brackets it.
    const double step =
        std::clamp(lateral_overshoot * missing / slope, -longest_lateral_step, +longest_lateral_step);
    const LateralSample next = at(here.lateral + step);
    if ((next.force - wanted) * missing >= 0) {
      const LateralBracket bracket = step > 0 ? LateralBracket{here, next} : LateralBracket{next, here};
      const LateralSample root = narrow_lateral(force, wanted, bracket, tolerance, narrowest_lateral);
      if (std::abs(root.force - wanted) <= tolerance)
        return root.lateral;
      refuse_search(wanted, root, tolerance);
    }
    const double secant = (next.force - here.force) / step;
    slope = secant * slope > 0 ? secant : slope; // a search that turned round would end on another branch
    here = next;
  }
  refuse_search(wanted, here, tolerance);
}

void refuse_lateral_force(double wanted, const std::vector<LateralSample>& samples) {
  if (samples.empty())
    throw InputError(fmt::format("No lateral displacement gives a lateral force of {:g} N", wanted),
                     "wheel and rail have no elastic contact at any displacement that was looked at",
                     "Check load, gauge and profiles, or give another position.lateral.");
  const auto [least, most] = std::ranges::minmax(samples, {}, &LateralSample::force);
  throw InputError(
      fmt::format("No lateral displacement gives a lateral force of {:g} N", wanted),
      fmt::format("from {:.4g} to {:.4g} mm the force on the rail is between about {:.4g} and {:.4g} N, at "
                  "{:.2f} and {:.2f} mm; positive is towards the side of this wheel",
                  samples.front().lateral, samples.back().lateral, least.force, most.force, least.lateral,
                  most.lateral),
      "Give a load.force_y between them, or another position.lateral, which moves this range of "
      "displacements.");
}

} // namespace bem_contact
