#include "bem_contact/sequence/lateral/lateral_force.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/sequence/lateral/settings.hpp"
#include "bem_contact/sequence/scene_result.hpp"

#include <boost/math/tools/toms748_solve.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace bem_contact {

namespace {

/// What ends a search from a callback of the library.
struct NoForce {};

/// Distance from `from` on the side of `direction` (-1 or 1) at which the force differs by `by`, N, and this
/// difference; the largest distance that was looked at where it nowhere does.
LateralSample leaves(const LateralForce& force, const LateralSample& from, double by, int direction) {
  LateralSample last;
  for (double away = lateral::unsure; last.lateral < lateral::reach; away *= 2) {
    const double distance = std::min(away, double(lateral::reach));
    const std::optional<double> there = force(from.lateral + direction * distance);
    if (!there)
      break;
    const LateralSample next{distance, *there - from.force};
    if (std::abs(next.force) >= by) {
      const double bound = std::copysign(by, next.force);
      return {std::lerp(last.lateral, next.lateral, (bound - last.force) / (next.force - last.force)), bound};
    }
    last = next;
  }
  return last;
}

} // namespace

LateralSpread lateral_spread(const LateralForce& shape, double found, double error, double resultant) {
  const double even = lateral::uneven * resultant;
  const double telling = std::isnan(error) ? even : std::max(error, even);
  const std::optional<double> here = shape(found);
  const LateralSample low = here ? leaves(shape, {found, *here}, telling, -1) : LateralSample{},
                      high = here ? leaves(shape, {found, *here}, telling, +1) : LateralSample{};
  const LateralSample& far = high.lateral > low.lateral ? high : low;
  LateralSpread out{.low = low.lateral, .high = high.lateral, .slope = 0, .error = lateral::reach};
  if (far.lateral > 0)
    out.slope = (&far == &high ? 1 : -1) * far.force / far.lateral;
  if (!(std::abs(far.force) < error)) // else no displacement that was looked at has another force
    out.error = std::min(error / std::abs(out.slope), double(lateral::reach));
  return out;
}

double narrowest_bracket() {
  return lateral::unsure * Certificate().tolerance;
}

LateralSample narrow_lateral(const LateralForce& force, double wanted, const LateralBracket& bracket,
                             double tolerance, double width) {
  const auto [low, high] =
      std::minmax(bracket.a, bracket.b,
                  [](const LateralSample& a, const LateralSample& b) { return a.lateral < b.lateral; });
  const auto misses = [&](const LateralSample& s) { return std::abs(s.force - wanted); };
  LateralSample best = misses(low) < misses(high) ? low : high;
  const auto excess = [&](double lateral) {
    const std::optional<double> there = force(lateral);
    if (!there)
      throw NoForce{};
    const LateralSample sample{lateral, *there};
    if (misses(sample) < misses(best))
      best = sample;
    return misses(sample) <= tolerance ? 0.0 : *there - wanted;
  };
  const auto enough = [&](double a, double b) {
    return misses(best) <= tolerance || std::abs(b - a) < width;
  };
  std::uintmax_t calls = boost::math::policies::get_max_root_iterations<boost::math::policies::policy<>>();
  if (misses(best) > tolerance && low.lateral < high.lateral) {
    try {
      boost::math::tools::toms748_solve(excess, low.lateral, high.lateral, low.force - wanted,
                                        high.force - wanted, enough, calls);
    } catch (const NoForce&) { // the best sample stands
    }
  }
  return best;
}

std::optional<LateralBracket> bracket_lateral_beside(const LateralForce& force, double wanted,
                                                     const LateralSample& from, double step,
                                                     double farthest) {
  std::array<std::optional<LateralSample>, 2> last{from, from};
  for (double away = step; std::abs(away) <= farthest && (last[0] || last[1]) && step != 0; away *= 2)
    for (const std::size_t side : {0, 1}) {
      const double at = from.lateral + (side == 0 ? away : -away);
      const std::optional<double> there = last[side] ? force(at) : std::nullopt;
      if (there && (*there - wanted) * (last[side]->force - wanted) <= 0)
        return LateralBracket{*last[side], {at, *there}};
      last[side] = there ? std::optional(LateralSample{at, *there}) : std::nullopt;
    }
  return std::nullopt;
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
  const std::optional<double> there = force(start.lateral);
  LateralSample best{start.lateral, there.value_or(NAN)};
  if (!there)
    refuse_search(wanted, best, tolerance);
  const double missing = wanted - best.force;
  if (std::abs(missing) <= tolerance)
    return best.lateral;
  const double step = std::clamp(missing / start.slope, -lateral::unsure, +lateral::unsure);
  const auto bracket = bracket_lateral_beside(force, wanted, best, step, lateral::reach);
  if (bracket)
    best = narrow_lateral(force, wanted, *bracket, tolerance, narrowest_bracket());
  if (std::abs(best.force - wanted) > tolerance)
    refuse_search(wanted, best, tolerance);
  return best.lateral;
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
