#include "bem_contact/contact/normal/active_set.hpp"

#include "bem_contact/base/counted.hpp"
#include "bem_contact/contact/normal/settings.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace bem_contact::contact {
namespace {

using Eigen::VectorXd;

/// 1. Tension below this share of the largest pressure, and penetration likewise, is rounding.
constexpr double rounding_of_sets = 1e-11;
/// Steps without fewer changes than before; then the sets cycle. Chosen.
constexpr int most_steps_without_progress = 12;

std::vector<int> touching_of(const std::vector<NormalSide>& sides) {
  std::vector<int> list;
  for (std::size_t i = 0; i < sides.size(); ++i)
    if (sides[i] == NormalSide::touching)
      list.push_back(static_cast<int>(i));
  return list;
}

bool is_direct(const std::vector<int>& list) {
  return static_cast<int>(list.size()) <= dense_normal_elements;
}

double largest_on(const std::vector<int>& list, const VectorXd& field) {
  double largest = 0;
  for (const int i : list)
    largest = std::max(largest, std::abs(field[i]));
  return largest;
}

} // namespace

std::vector<NormalSide> first_guess(const NormalSystem& system, const VectorXd& gap, const NormalLoad& load,
                                    WorkBudget& work, double& approach) {
  const int n = static_cast<int>(gap.size());
  const auto overlapping = [&](double q) {
    std::vector<NormalSide> sides(n, NormalSide::apart);
    for (int i = 0; i < n; ++i)
      if (gap[i] - q * system.cosine[i] < 0)
        sides[i] = NormalSide::touching;
    return sides;
  };
  if (load.kind == LoadKind::approach)
    return overlapping(load.approach);
  double low = std::numeric_limits<double>::infinity(), cosine = 1;
  for (int i = 0; i < n; ++i)
    if (system.cosine[i] > least_cosine && gap[i] / system.cosine[i] < low) {
      low = gap[i] / system.cosine[i];
      cosine = system.cosine[i];
    }
  // The energy is convex in the force and at most that of this element alone: twice its approach lies beyond
  // every answer, however high the walls are.
  double high = low + 2 * load.force / (system.element_area * cosine * cosine) * system.self;
  high += 1e-12 * std::abs(low); // rounding
  for (int step = 0; step < first_guess_bisections; ++step) {
    const double q = 0.5 * (low + high);
    const std::vector<NormalSide> sides = overlapping(q);
    VectorXd one = VectorXd::Zero(n);
    double overlap = 0, cosines = 0;
    for (int i = 0; i < n; ++i)
      if (sides[i] == NormalSide::touching) {
        one[i] = 1;
        overlap += q * system.cosine[i] - gap[i];
        cosines += system.cosine[i];
      }
    const double compliance = one.dot(system.apply(one, work));
    const double carried = compliance > 0 ? overlap / compliance * cosines * system.element_area : 0;
    (carried < load.force ? low : high) = q;
  }
  approach = high;
  return overlapping(high);
}

ActiveSet::ActiveSet(const NormalSystem& system, const VectorXd& gap, const NormalLoad& load,
                     const SolverOptions& options, WorkBudget& work, NormalState& state)
    : system_(system), gap_(gap), load_(load), options_(options), work_(work), state_(state),
      by_force_(load.kind == LoadKind::force),
      wanted_(std::clamp(normal_precision * options.tolerance, finest_normal_precision,
                         coarsest_normal_precision)),
      precision_(wanted_), whole_{{{0, 0, system.grid.mx, system.grid.ms}}},
      fewest_changes_(static_cast<int>(gap.size()) + 1) {
  const auto n = static_cast<std::size_t>(gap.size());
  const double start = state.approach;
  state.approach = load.approach;
  if (state.sides.size() != n || !state.in_contact()) {
    state.sides = first_guess(system, gap, load, work, state.approach);
    state.p.setZero(gap.size());
    precision_ = cold_normal_precision;
  } else {
    precision_ = std::max(wanted_, warm_normal_precision);
    if (by_force_)
      state.approach = start;
  }
  if (state.p.size() != gap.size())
    state.p.setZero(gap.size());
  const VectorXd zero = VectorXd::Zero(gap.size());
  at_limit_ = under_limit_ = zero;
  pressure_ = {state.p, zero, {}};
  unit_ = {state.unit.size() == gap.size() ? state.unit : zero, zero, {}};
}

/// The pressure of the elements at its limit is known, and so is what it displaces.
void ActiveSet::take_limited(bool direct) {
  limited_ = std::ranges::find(state_.sides, NormalSide::at_limit) != state_.sides.end();
  if (!limited_ && !at_limit_.any())
    return;
  for (Eigen::Index i = 0; i < at_limit_.size(); ++i)
    at_limit_[i] = state_.sides[i] == NormalSide::at_limit ? system_.limit : 0.0;
  under_limit_ = direct ? system_.apply_directly(at_limit_, work_) : system_.apply(at_limit_, work_);
}

/// Solves for the pressure at the present approach and, by force, for the unit response.
bool ActiveSet::solve_linear(const std::vector<int>& list) {
  const VectorXd rhs = state_.approach * system_.cosine - gap_ - under_limit_;
  if (!is_direct(list)) {
    // The unit response corrects a force that is nearly right, and need not be precise at first.
    return conjugate_gradients(system_, list, rhs, precision_ * largest_on(list, rhs), work_, pressure_) &&
           (!by_force_ ||
            conjugate_gradients(system_, list, system_.cosine, std::sqrt(precision_), work_, unit_));
  }
  Eigen::MatrixXd right(list.size(), 2);
  for (std::size_t a = 0; a < list.size(); ++a)
    right.row(a) << rhs[list[a]], system_.cosine[list[a]];
  if (!system_.solve_dense(list, right))
    return false;
  pressure_.p.setZero();
  unit_.p.setZero();
  for (std::size_t a = 0; a < list.size(); ++a) {
    pressure_.p[list[a]] = right(a, 0);
    unit_.p[list[a]] = right(a, 1);
  }
  return true;
}

/// By force: changes the approach so that the pressure carries the force. Returns how far u may be off,
/// because the unit response is not precise.
double ActiveSet::balance_force(bool direct) {
  if (!by_force_)
    return 0;
  const double more = (load_.force / system_.element_area - system_.cosine.dot(pressure_.p + at_limit_)) /
                      system_.cosine.dot(unit_.p);
  state_.approach += more;
  pressure_.p += more * unit_.p;
  if (direct)
    return 0;
  pressure_.u += more * unit_.u;
  return std::abs(more) * std::sqrt(precision_);
}

/// Elements with tension leave the contact, and elements with penetration enter it. Those with more than the
/// limit of the pressure get that, and those at the limit that are apart no longer have it. The residual of
/// the conjugate gradients and rounding must not change a set. Returns how many elements changed.
int ActiveSet::change_sides(const Boxes& where, double largest_u) {
  const double least_p = -std::max(precision_, rounding_of_sets) * state_.p.cwiseAbs().maxCoeff();
  const double least_e = -std::max(precision_, rounding_of_sets) * largest_u;
  int changes = 0;
  for (const Box& box : where.boxes)
    for (int is = box.first_s; is < box.first_s + box.ms; ++is)
      for (int ix = box.first_x; ix < box.first_x + box.mx; ++ix) {
        const int i = is * system_.grid.mx + ix;
        NormalSide side = state_.sides[i];
        if (side == NormalSide::touching) {
          if (state_.p[i] < least_p)
            side = NormalSide::apart;
          else if (state_.p[i] > system_.limit - least_p)
            side = NormalSide::at_limit;
        } else {
          const double e = gap_[i] - state_.approach * system_.cosine[i] + pressure_.u[i];
          if (side == NormalSide::apart ? e < least_e : e > -least_e)
            side = NormalSide::touching;
        }
        changes += side != state_.sides[i];
        state_.sides[i] = side;
      }
  return changes;
}

/// Sets the precision of the next step: sets that hardly change are worth knowing better. False if the sets
/// have not come closer for many steps.
bool ActiveSet::progresses(int changes) {
  precision_ = changes == 0 ? wanted_
                            : std::max(wanted_, std::min(precision_, precision_of_changes * changes /
                                                                         static_cast<double>(gap_.size())));
  without_progress_ = changes < fewest_changes_ ? 0 : without_progress_ + 1;
  fewest_changes_ = std::min(fewest_changes_, changes);
  return without_progress_ < most_steps_without_progress;
}

bool ActiveSet::run() {
  for (int step = 0; step < options_.max_normal; ++step) {
    const std::vector<int> list = touching_of(state_.sides);
    ++state_.iterations;
    if (list.empty() && by_force_)
      break;
    const bool direct = is_direct(list);
    if (direct)
      precision_ = wanted_;
    take_limited(direct);
    const int products = pressure_.products + unit_.products;
    const bool solved = solve_linear(list);
    state_.products += pressure_.products + unit_.products - products;
    if (!solved) {
      state_.remark = "active set: a linear system was not positive definite";
      return false;
    }
    const double off = balance_force(direct);
    state_.p = pressure_.p + at_limit_;
    state_.unit = unit_.p;
    if (direct)
      pressure_.u = system_.apply_directly(state_.p, work_);
    else if (limited_)
      pressure_.u = system_.apply(state_.p, work_);
    const double largest_u = limited_ ? pressure_.u.cwiseAbs().maxCoeff() : largest_on(list, pressure_.u);
    int changes = change_sides(direct || limited_ ? whole_ : pressure_.known, largest_u);
    const bool precise = precision_ <= wanted_ && off <= precision_ * largest_u;
    if (changes == 0 && precise && !direct) { // all is well in the boxes; and outside?
      pressure_.u = system_.apply(state_.p, work_);
      changes = change_sides(whole_, largest_u);
    }
    if (changes == 0 && precise)
      return true;
    if (!progresses(changes)) {
      state_.remark = "active set: the sets cycled";
      return false;
    }
  }
  state_.remark = "active set: no answer in " + counted(options_.max_normal, "step", "steps");
  return false;
}

} // namespace bem_contact::contact
