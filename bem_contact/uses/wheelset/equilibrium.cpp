#include "bem_contact/uses/wheelset/equilibrium.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/geometry/level_roll.hpp"
#include "bem_contact/sequence/quantities.hpp"
#include "bem_contact/uses/wheelset/balance.hpp"
#include "bem_contact/uses/wheelset/settings.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

namespace bem_contact {

namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// 1. Most steps to the equilibrium at one lateral displacement: 3 to 5 are usual. A bound.
constexpr int equilibrium_steps = 40;
/// 1. A wheel of whose elements in contact fewer adhere slides: near full slip some stay in adhesion about
/// the spin's pole. Chosen.
constexpr double sliding_adhesion = 0.05;
/// 1. Step of differences, over the smaller approach: forces then change by some percent.
constexpr double difference_share = 0.02;
/// mm. Heights of both wheels on their rails, before anything is solved, agree within this.
constexpr double stand_tolerance = 1e-4;

/// By differences of the size of `step`.
std::optional<MatrixXd> differences(Balance& balance, const VectorXd& u, const VectorXd& f, double step) {
  MatrixXd out(f.size(), f.size());
  for (Eigen::Index i = 0; i < f.size(); ++i) {
    const auto there = balance.at(u + step * VectorXd::Unit(f.size(), i));
    if (!there)
      return std::nullopt;
    out.col(i) = (balance.residual(*there) - f) / step;
  }
  return out;
}

/// Whether friction is used up: hardly an element adheres on either wheel.
bool slides(const WheelsetState& s) {
  return std::max(s.right.result.totals.adhesion_share, s.left.result.totals.adhesion_share) <
         sliding_adhesion;
}

[[noreturn]] void refuse_search(const WheelsetState& s, const SceneFile::Wheelset& given, double residual) {
  const double torque = s.torque(s.sum());
  const bool torque_is_worst =
      std::abs(given.torque - torque) >= 0.99 * residual * *given.force * s.wheel_radius;
  if (s.pose.rolling_radius && std::abs(given.torque) > std::abs(torque) && (torque_is_worst || slides(s)))
    throw InputError(fmt::format("The rails cannot bear a torque of {:g} N mm", given.torque),
                     fmt::format("with friction used up they bear about {:.2g} N mm", torque),
                     "Give a wheelset.torque nearer to 0, or more friction.");
  throw ConvergenceError(
      "The wheelset does not stand",
      fmt::format("at a lateral displacement of {:g} mm no height and roll balance the forces; the search "
                  "ended at a roll of {:.4g} rad with Fz {:.5g} N on the right rail, {:.5g} N on the left "
                  "one, and {:.1e} of a force or moment missing",
                  s.pose.lateral, s.pose.roll, s.right_wrench.force[2], s.left_wrench.force[2], residual),
      "Give another position.lateral or smaller forces on the axle.");
}

} // namespace

WheelsetPose stand(WheelPair& wheels, double lateral, const EquilibriumStart& start) {
  double right = 0, left = 0;
  const auto lean = [&](double roll) { // by how much the right wheel stands lower than the left one
    right = wheels.lowered(WheelSide::right, lateral, roll) + start.right;
    left = wheels.lowered(WheelSide::left, lateral, roll) + start.left;
    return right - left;
  };
  const double roll = level_roll(lean, start.roll, wheels.scene().position.gauge, stand_tolerance);
  return {lateral, 0.5 * (right + left), roll, start.rolling_radius};
}

EquilibriumStart Equilibrium::start() const {
  return {state.right.result.totals.approach, state.left.result.totals.approach, state.pose.roll,
          state.pose.rolling_radius};
}

namespace {

/// `slope`: null: by the model of the stiffness. `solved`: at `first`; null: it is solved here.
Equilibrium search_equilibrium(WheelPair& wheels, const WheelsetPose& first, double tolerance,
                               const std::vector<double>* slope, const WheelsetState* solved) {
  Balance balance(wheels, first);
  BalanceSearch search{balance};
  search.u = balance.none();
  std::optional<WheelsetState> begin = solved ? std::optional(*solved) : balance.at(search.u);
  if (!begin)
    begin = wheels.at(first); // says why
  WheelsetState here = std::move(*begin);
  balance.set_arm(here);
  search.f = balance.residual(here);
  const Eigen::Index size = search.f.size();
  search.slope =
      slope ? MatrixXd(Eigen::Map<const MatrixXd>(slope->data(), size, size)) : balance.model(here);
  for (int i = 0; i < equilibrium_steps; ++i) {
    const double residual = search.f.lpNorm<Eigen::Infinity>();
    if (residual <= tolerance)
      return {std::move(here),
              residual,
              balance.evaluations,
              {search.slope.data(), search.slope.data() + search.slope.size()}};
    if (search.step(here))
      continue;
    const double approach = std::min(here.right.result.totals.approach, here.left.result.totals.approach);
    const auto better =
        search.exact ? std::nullopt : differences(balance, search.u, search.f, difference_share * approach);
    if (!better)
      break;
    search.slope = *better;
    search.exact = true;
  }
  refuse_search(here, wheels.scene().wheelset, search.f.lpNorm<Eigen::Infinity>());
}

} // namespace

Equilibrium find_equilibrium(WheelPair& wheels, double lateral, const EquilibriumStart& start,
                             double tolerance) {
  return search_equilibrium(wheels, stand(wheels, lateral, start), tolerance, nullptr, nullptr);
}

Equilibrium find_equilibrium(WheelPair& wheels, const WheelsetPose& first, double tolerance,
                             const std::vector<double>& slope, const WheelsetState* solved) {
  return search_equilibrium(wheels, first, tolerance, &slope, solved);
}

} // namespace bem_contact
