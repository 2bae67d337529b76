#include "bem_contact/uses/wheelset/lateral_equilibrium.hpp"

#include "bem_contact/uses/wheelset/balance.hpp"

#include <Eigen/LU>

#include <cmath>

namespace bem_contact {

namespace {

/// 1. Steps that may be taken: 3 or 4 are usual from within some hundredths of a millimetre. A bound.
constexpr int lateral_steps = 10;
/// mm. So far from its start the search may go: rough displacements are better than this. Chosen.
constexpr double lateral_trust = 0.5;

} // namespace

std::optional<Equilibrium> find_lateral_equilibrium(WheelPair& wheels, const WheelsetState& near,
                                                    double tolerance) {
  Balance balance(wheels, near.pose, *wheels.scene().wheelset.force_y);
  balance.set_arm(near);
  BalanceSearch search{balance};
  search.u = balance.none();
  std::optional<WheelsetState> here = balance.at(search.u, true);
  if (!here)
    return std::nullopt;
  search.f = balance.residual(*here);
  search.slope = balance.derivatives(*here);
  const Eigen::Index others = search.u.size() - 1;
  if (!search.slope.allFinite() || !search.slope.fullPivLu().isInvertible())
    return std::nullopt;
  for (int i = 0; i < lateral_steps && std::abs(search.u[others]) < lateral_trust; ++i) {
    const double residual = search.f.lpNorm<Eigen::Infinity>();
    if (residual <= tolerance) {
      const Eigen::MatrixXd slope = search.slope.topLeftCorner(others, others);
      return Equilibrium{
          std::move(*here), residual, balance.evaluations, {slope.data(), slope.data() + slope.size()}};
    }
    if (!search.step(*here))
      break;
  }
  return std::nullopt;
}

} // namespace bem_contact
