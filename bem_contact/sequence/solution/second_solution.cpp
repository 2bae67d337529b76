#include "bem_contact/sequence/solution/second_solution.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/contact/flash_temperature.hpp"

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <fmt/format.h>
#include <numeric>
#include <optional>
#include <tuple>

namespace bem_contact {

namespace {

/// 1. Two solutions with falling friction are two if their shear forces differ by more than this share of the
/// sum of mu p_n: a hundred times what the certificate allows.
constexpr double least_branch_difference = 1e-4;
/// 1. Sliding as a whole: steps between friction and heat, the part of each that is taken, and the change of
/// a bound over that of cold friction at which they end. A fifth settles where mu falls by as much as four
/// times its own change.
constexpr int most_heat_changes = 100;
constexpr double heat_damping = 0.2;
constexpr double least_heat_change = 1e-4;
/// 1. Most steps of the search for its slip velocity, and bits of it: it is said with three digits.
constexpr int most_sliding_steps = 60;
constexpr int sliding_bits = 12;

/// What an element bears that slides, MPa, of the friction that it has at this velocity cold.
double borne_at(const ContactProblem& problem, double friction, double temperature) {
  if (problem.friction_falls_with_heat())
    friction *= problem.heating->friction->factor(temperature);
  return problem.yield ? std::min(friction, problem.yield->at(temperature)) : friction;
}

/// The shear force, N, where all elements slide in one direction at one velocity, mm/s: mu of each row at
/// that velocity, and mu and layer at the temperature that this sliding makes. Nothing where these do not
/// settle.
std::optional<double> force_of_sliding(const ContactProblem& problem, const ContactResult& result,
                                       double velocity) {
  const int n = problem.grid.size();
  std::vector<double> friction(n), borne(n), heat(n);
  std::vector<char> in_contact(n);
  for (int i = 0; i < n; ++i) {
    const int row = i / problem.grid.mx;
    friction[i] = problem.friction_of(row) * problem.falling_factor(row, velocity) * result.pn[i];
    borne[i] = problem.yield ? std::min(friction[i], problem.yield->shear) : friction[i];
    in_contact[i] = result.pn[i] > 0;
  }
  const auto force = [&] { return problem.element_area() * std::reduce(borne.begin(), borne.end()); };
  if (!problem.heat_acts())
    return force();
  for (int k = 0; k < most_heat_changes; ++k) {
    for (int i = 0; i < n; ++i)
      heat[i] = borne[i] * velocity;
    const SurfaceTemperatures at =
        flash_temperatures(problem.grid, *problem.heating, problem.speed, heat, in_contact);
    double change = 0;
    for (int i = 0; i < n; ++i) {
      if (!in_contact[i])
        continue;
      const double step = borne_at(problem, friction[i], at.mean(i)) - borne[i];
      borne[i] += heat_damping * step; // less friction makes less heat: whole steps would swing
      change = std::max(change, std::abs(step) / friction[i]);
    }
    if (change < least_heat_change)
      return force();
  }
  return std::nullopt;
}

/// The slip velocity above that of `result` at which sliding as a whole carries the prescribed force too,
/// mm/s. The faster it slides, the less it carries; beyond the rolling speed nothing is looked for.
std::optional<double> velocity_of_sliding(const ContactProblem& problem, const ContactResult& result) {
  const double wanted = std::hypot(problem.force_x.value_or(0), problem.force_s.value_or(0));
  double low = problem.speed * std::hypot(result.totals.creepage_x, result.totals.creepage_s),
         high = problem.speed;
  bool settled = true;
  const auto carries = [&](double velocity) {
    const std::optional<double> force = force_of_sliding(problem, result, velocity);
    settled = settled && force;
    return force.value_or(0) - wanted;
  };
  if (!(low < high) || carries(low) <= 0 || carries(high) >= 0)
    return std::nullopt;
  boost::uintmax_t steps = most_sliding_steps;
  std::tie(low, high) = boost::math::tools::toms748_solve(
      carries, low, high, boost::math::tools::eps_tolerance<double>(sliding_bits), steps);
  return settled ? std::optional((low + high) / 2) : std::nullopt;
}

std::string larger_creepage(const ContactProblem& problem, const ContactResult& result) {
  const std::optional<double> velocity = velocity_of_sliding(problem, result);
  if (!velocity)
    return "";
  return fmt::format("{}, and two creepages give the shear force: the "
                     "smaller one was taken "
                     "({:.3g} along x, {:.3g} along s); sliding as a whole at some {:.3g} (slip velocity "
                     "{:.3g} mm/s) carries it "
                     "too. Give a creepage (motion.xi, eta) to choose.",
                     problem.friction_falls()    ? "friction falls with the slip velocity"
                     : problem.friction_varies() ? "friction falls with temperature"
                                                 : "the layer softens by heat",
                     result.totals.creepage_x.value, result.totals.creepage_s.value,
                     *velocity / problem.speed, *velocity);
}

std::string forces_text(const ContactResult& result) {
  const ElementCounts count = count_elements(result);
  return fmt::format("Fx {:.1f} N, Fs {:.1f} N, {} of {} elements in adhesion", result.totals.Fx.value,
                     result.totals.Fs.value, count.adhesion, count.contact);
}

} // namespace

std::string second_solution(const ContactProblem& problem, const ContactResult& result, SolverOptions options,
                            WorkBudget& work) {
  if (!problem.has_friction() || !problem.bounds_vary() || problem.motion != MotionKind::steady ||
      !result.certified())
    return "";
  if ((problem.force_x || problem.force_s) && (problem.memory || problem.hardens()))
    return ""; // how fast all slides with it depends on the place, or on how far the layer has yielded
  if (problem.force_x || problem.force_s)
    return larger_creepage(problem, result);
  options.from_sliding = true;
  options.estimate_discretisation = options.displacements = false;
  options.early_end = nullptr;
  try {
    const ContactResult other = solve(problem, options, work);
    const double change = std::hypot(other.totals.Fx - result.totals.Fx, other.totals.Fs - result.totals.Fs);
    if (!other.certified() || change <= least_branch_difference * friction_bound(problem, result))
      return "";
    return fmt::format(
        "{} so steeply that this contact has two solutions: taken is the one that comes "
        "from adhesion ({}); from sliding comes {}. Which one occurs depends on what was before.",
        problem.friction_varies() ? "friction falls" : "the layer softens by heat", forces_text(result),
        forces_text(other));
  } catch (const Error&) { // no such solution, or no work left to look for it
    return "";
  }
}

} // namespace bem_contact
