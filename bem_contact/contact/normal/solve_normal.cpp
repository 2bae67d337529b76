#include "bem_contact/contact/normal/solve_normal.hpp"

#include "bem_contact/contact/normal/active_set.hpp"
#include "bem_contact/contact/normal/mprgp.hpp"
#include "bem_contact/contact/normal/settings.hpp"

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <functional>
#include <limits>

namespace bem_contact::contact {
namespace {

using Eigen::VectorXd;

/// Products that MPRGP may take: this and so many an element. Chosen.
constexpr int mprgp_products = 2000;
constexpr int mprgp_products_per_element = 20;
/// Doublings of that step, and steps inside the bracket. Chosen: far more than are ever needed.
constexpr int most_bracket_doublings = 60;
constexpr int most_approach_steps = 100;

/// The result where the pressure has nothing to carry.
void carry_nothing(const NormalLoad& load, Eigen::Index n, NormalState& state) {
  state.sides.assign(n, NormalSide::apart);
  state.p.setZero(n);
  state.u.setZero(n);
  state.solver = "none";
  state.converged = load.force == 0;
  state.approach = 0;
  if (load.force < 0)
    state.remark = "the shear tractions alone carry more than the force prescribed";
}

/// N, by the limit of the pressure on all of the grid.
double most_borne(const NormalSystem& system) {
  return system.limit * system.cosine.cwiseMax(0.0).sum() * system.element_area;
}

/// The result where the grid is too small to bear the force: the limit of the pressure everywhere.
void carry_too_little(const NormalSystem& system, NormalState& state, WorkBudget& work) {
  state.p.setConstant(system.cosine.size(), system.limit);
  state.u = system.apply(state.p, work);
  state.set_sides(system.limit);
  state.solver = "none";
  state.converged = false;
  state.approach = 0;
  state.remark =
      "the limit of the pressure bears less on the whole grid than the force prescribed: give a larger "
      "grid";
}

/// The lowest approach at which an element touches.
double first_touch(const NormalSystem& system, const VectorXd& gap) {
  double low = std::numeric_limits<double>::infinity();
  for (Eigen::Index i = 0; i < gap.size(); ++i)
    if (system.cosine[i] > least_cosine)
      low = std::min(low, gap[i] / system.cosine[i]);
  return low;
}

/// Finds the approach q at which missing_at(q), which grows with q, is 0 up to `close`. The bracket starts at
/// `low`, where `at_low` < 0 is missing. The last call of missing_at is the one at the result. False if it is
/// not found.
bool bracket_approach(const std::function<double(double)>& missing_at, double low, double at_low, double step,
                      double close) {
  const auto at = [&](double q) {
    const double missing = missing_at(q);
    return std::abs(missing) <= close ? 0.0 : missing;
  };
  double high = low + approach_bracket_start * step, at_high = at(high);
  for (int k = 0; k < most_bracket_doublings && at_high < 0; ++k) {
    low = high;
    at_low = at_high;
    high += step *= 2;
    at_high = at(high);
  }
  if (at_high <= 0)
    return at_high == 0;
  std::uintmax_t calls = most_approach_steps;
  const auto never = [](double, double) { return false; }; // only a root ends the search
  const auto [from, to] = boost::math::tools::toms748_solve(at, low, high, at_low, at_high, never, calls);
  return from == to;
}

} // namespace

void solve_normal_safely(const NormalSystem& system, const VectorXd& gap, const NormalLoad& load,
                         const SolverOptions& options, WorkBudget& work, NormalState& state) {
  const int most = mprgp_products + mprgp_products_per_element * static_cast<int>(gap.size());
  const double tolerance = std::max(mprgp_precision * options.tolerance, finest_mprgp_precision);
  state.solver = "MPRGP";
  state.p = VectorXd::Zero(gap.size());
  const auto force_at = [&](double q) {
    const MprgpOutcome outcome = solve_mprgp(system, q * system.cosine - gap, tolerance, most, work, state.p);
    state.iterations += outcome.products;
    state.converged = outcome.converged;
    state.approach = q;
    return system.cosine.dot(state.p) * system.element_area;
  };
  if (load.kind == LoadKind::approach) {
    force_at(load.approach);
    return;
  }
  const bool found = bracket_approach(
      [&](double q) { return force_at(q) - load.force; }, first_touch(system, gap), -load.force,
      load.force / system.element_area * system.self, force_precision * options.tolerance * load.force);
  state.converged = state.converged && found;
}

void solve_normal(const NormalSystem& system, const VectorXd& gap, const NormalLoad& load,
                  const SolverOptions& options, WorkBudget& work, NormalState& state) {
  if (load.kind == LoadKind::force && load.force <= 0)
    return carry_nothing(load, gap.size(), state);
  if (load.kind == LoadKind::force && load.force > most_borne(system))
    return carry_too_little(system, state, work);
  state.solver = "active set";
  ActiveSet active_set(system, gap, load, options, work, state);
  state.converged = active_set.run();
  state.u = active_set.displacement();
  if (!state.converged) {
    solve_normal_safely(system, gap, load, options, work, state);
    state.u = system.apply(state.p, work);
  }
  state.p = state.p.cwiseMax(0.0).cwiseMin(system.limit);
  state.set_sides(system.limit);
}

} // namespace bem_contact::contact
