#include "bem_contact/uses/fit/undetermined.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace bem_contact::fit {

namespace {

/// 1. Two keys whose estimates are correlated by more are known together only.
constexpr double high_correlation = 0.95;
/// 1. A key whose interval is wider than so many times its value is hardly known.
constexpr double wide_interval = 2;
/// 1. Where a force is less than this share of slope times creepage, it says little of the slope.
constexpr double nearly_straight = 0.9;

std::string with_unit(double value, const std::string& unit) {
  return fmt::format("{:.3g}", value) + (unit.empty() ? "" : " " + unit);
}

std::string of_key(const FittedKey& k) {
  if (!k.determined)
    return fmt::format("No point depends on {}: leave it out, or measure where it matters.", k.key);
  if (k.bound != Bound::none)
    return fmt::format(
        "{} ended at the {} end of its range, {}: the points would have it {} still; they bound it by {}.",
        k.key, k.bound == Bound::lower ? "lower" : "upper", with_unit(k.value, k.unit),
        k.bound == Bound::lower ? "smaller" : "larger",
        with_unit(k.bound == Bound::lower ? k.high : k.low, k.unit));
  if (k.high - k.low > wide_interval * std::abs(k.value))
    return fmt::format("The points say little of {}: it may be anything from {} to {}.", k.key,
                       with_unit(k.low, k.unit), with_unit(k.high, k.unit));
  return "";
}

/// The creepage at which nothing slides, as the points count it; nothing where it is not known.
std::optional<double> middle_of(const CurveFit& fit, const MeasuredForces& measured) {
  const SceneResult& solution = fit.solution;
  if (measured.which == CreepKind::xi && solution.motion.free_rolling)
    return fit.scene.motion.from_free_rolling ? 0 : solution.motion.free_rolling->xi.value;
  return fit.scene.kind == SceneKind::patch ? std::optional(0.0) : std::nullopt;
}

/// Of the slope of the force: measured only by points where little slips.
std::string of_slope(const CurveFit& fit) {
  if (!fit.curves)
    return "";
  const MeasuredForces& m = fit.measured.forces.front();
  const auto force = static_cast<std::size_t>(m.force), which = static_cast<std::size_t>(m.which);
  const double slope = fit.curves->slopes.values[force][which];
  const std::optional<double> middle = middle_of(fit, m);
  if (!middle || m.force == CreepForce::Mz || !std::isfinite(slope) || slope == 0)
    return "";
  const auto distance = [&](std::size_t i) { return std::abs(m.creepage[i] - *middle); };
  std::size_t nearest = 0;
  for (std::size_t i = 1; i < m.creepage.size(); ++i)
    if (distance(i) < distance(nearest))
      nearest = i;
  const double share = m.computed[nearest].forces[force] / (slope * (m.creepage[nearest] - *middle));
  if (!(distance(nearest) > 0) || share > nearly_straight)
    return "";
  return fmt::format(
      "No point lies nearer to zero creepage than {} = {:.3g}, where {} has fallen to {:.2g} of what "
      "its slope there would give: the points do not measure that slope, it follows from the theory.",
      name_of(m.which), m.creepage[nearest], name_of(m.force), share);
}

} // namespace

std::vector<std::string> undetermined(const CurveFit& fit) {
  std::vector<std::string> out;
  const auto add = [&](std::string text) {
    if (!text.empty())
      out.push_back(std::move(text));
  };
  const std::size_t count = fit.keys.size();
  for (std::size_t k = 0; k < count; ++k) {
    add(of_key(fit.keys[k]));
    for (std::size_t j = 0; j < k; ++j)
      if (const double r = fit.correlation[k * count + j]; std::abs(r) > high_correlation)
        add(fmt::format(
            "The points know {} and {} together, not each (correlation {:.3f}): give one of them a "
            "value from elsewhere.",
            fit.keys[j].key, fit.keys[k].key, r));
  }
  add(of_slope(fit));
  return out;
}

} // namespace bem_contact::fit
