#include "bem_contact/sequence/lateral_force.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/sequence/settings.hpp"

#include <boost/math/tools/toms748_solve.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace bem_contact {

namespace {

/// The displacement where the parabola through three samples, equally far apart or not, has its extremum.
double vertex(const LateralSample& a, const LateralSample& b, const LateralSample& c) {
  const double left = (b.force - a.force) / (b.lateral - a.lateral);
  const double right = (c.force - b.force) / (c.lateral - b.lateral);
  const double curvature = (right - left) / (c.lateral - a.lateral);
  return 0.5 * (a.lateral + b.lateral) - 0.5 * left / curvature;
}

/// Adds a sample wherever three of them have an extremum that falls short of `wanted` and whose parabola does
/// not.
void sample_extrema(const LateralForce& force, double wanted, std::vector<LateralSample>& samples) {
  std::vector<LateralSample> more;
  for (std::size_t i = 1; i + 1 < samples.size(); ++i) {
    const LateralSample &a = samples[i - 1], &b = samples[i], &c = samples[i + 1];
    const double sign = b.force < wanted ? 1 : -1;
    const bool short_extremum = sign * (b.force - a.force) > 0 && sign * (b.force - c.force) >= 0 &&
                                c.lateral - a.lateral < 2.5 * lateral_step;
    if (!short_extremum)
      continue;
    const double at = vertex(a, b, c);
    if (const std::optional<double> there = at > a.lateral && at < c.lateral ? force(at) : std::nullopt)
      more.push_back({at, *there});
  }
  samples.insert(samples.end(), more.begin(), more.end());
  std::ranges::sort(samples, {}, &LateralSample::lateral);
}

/// What ends a search from a callback of the library.
struct NoForce {};

[[noreturn]] void refuse_search(double wanted, double lateral, double force) {
  throw ConvergenceError(
      fmt::format("No lateral displacement with a lateral force of {:g} N was found", wanted),
      fmt::format("the search ended at {:.6f} mm with {:.6g} N", lateral, force),
      "Give position.lateral near the displacement, or another load.force_y.");
}

/// Both ends of an interval over which the force passes `wanted`.
struct Bracket {
  LateralSample low, high;
};

/// Narrows a bracket until the force is met within `tolerance` or the interval is narrower than `width`.
/// Returns the sample that is nearest to `wanted`.
LateralSample narrow(const LateralForce& force, double wanted, const Bracket& bracket, double tolerance,
                     double width) {
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

} // namespace

std::vector<LateralSample> sample_lateral_force(const LateralForce& force, double around) {
  std::vector<LateralSample> samples;
  const int each_side = static_cast<int>(std::lround(lateral_reach / lateral_step));
  for (int i = -each_side; i <= each_side; ++i) {
    const double lateral = around + i * lateral_step;
    if (const std::optional<double> there = force(lateral))
      samples.push_back({lateral, *there});
  }
  return samples;
}

std::vector<LateralRoot> find_lateral_roots(const LateralForce& force, std::vector<LateralSample> samples,
                                            double wanted) {
  sample_extrema(force, wanted, samples);
  std::vector<LateralRoot> roots;
  for (std::size_t i = 0; i + 1 < samples.size(); ++i) {
    const LateralSample &a = samples[i], &b = samples[i + 1];
    const double apart = b.lateral - a.lateral;
    // A force that is met at a sample counts for the interval to its right.
    if ((a.force - wanted) * (b.force - wanted) > 0 || b.force == wanted || apart > 1.5 * lateral_step)
      continue;
    const LateralSample root = narrow(force, wanted, {a, b}, 0, lateral_root_width);
    roots.push_back({root.lateral, (b.force - a.force) / apart});
  }
  return roots;
}

double solve_lateral_force(const LateralForce& force, double wanted, const LateralRoot& start,
                           double tolerance) {
  const auto at = [&](double lateral, double last) {
    const std::optional<double> there = force(lateral);
    if (!there)
      refuse_search(wanted, lateral, last);
    return LateralSample{lateral, *there};
  };
  LateralSample here = at(start.lateral, wanted);
  double slope = start.slope;
  for (int i = 0; i < most_lateral_steps; ++i) {
    const double missing = wanted - here.force;
    if (std::abs(missing) <= tolerance)
      return here.lateral;
    // Beyond the force by a little, so that the next step brackets it.
    const double step =
        std::clamp(lateral_overshoot * missing / slope, -longest_lateral_step, +longest_lateral_step);
    const LateralSample next = at(here.lateral + step, here.force);
    if ((next.force - wanted) * missing >= 0) {
      const Bracket bracket = step > 0 ? Bracket{here, next} : Bracket{next, here};
      const LateralSample root = narrow(force, wanted, bracket, tolerance, narrowest_lateral);
      if (std::abs(root.force - wanted) <= tolerance)
        return root.lateral;
      refuse_search(wanted, root.lateral, root.force);
    }
    const double secant = (next.force - here.force) / step;
    slope = secant * slope > 0 ? secant : slope; // a search that turned round would end on another branch
    here = next;
  }
  refuse_search(wanted, here.lateral, here.force);
}

void refuse_lateral_force(double wanted, const std::vector<LateralSample>& samples) {
  if (samples.empty())
    throw InputError(fmt::format("No lateral displacement gives a lateral force of {:g} N", wanted),
                     "wheel and rail have no elastic contact at any displacement that was looked at",
                     "Check load, gauge and profiles, or give another position.lateral.");
  const auto [least, most] = std::ranges::minmax(samples, {}, &LateralSample::force);
  throw InputError(
      fmt::format("No lateral displacement gives a lateral force of {:g} N", wanted),
      fmt::format("from {:.4g} to {:.4g} mm the force on the rail is between {:.4g} and {:.4g} N",
                  samples.front().lateral, samples.back().lateral, least.force, most.force),
      "Give load.force_y in this range (its sign: towards the side of this wheel), or another "
      "position.lateral.");
}

} // namespace bem_contact
