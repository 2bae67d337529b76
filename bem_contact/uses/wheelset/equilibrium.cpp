#include "bem_contact/uses/wheelset/equilibrium.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/geometry/level_roll.hpp"
#include "bem_contact/sequence/quantities.hpp"
#include "bem_contact/uses/wheelset/settings.hpp"

#include <Eigen/LU>

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
/// 1. A step that does not lessen the residual is halved so often at most.
constexpr int step_halvings = 6;
/// 1. A step leaves each wheel at least this share of its approach, so that no wheel is lifted by accident,
constexpr double least_approach_share = 0.3;
/// 1. and gives it at most so many times of it: forces then grow fivefold.
constexpr double most_approach_share = 3.0;
/// 1. A wheel that bears less than this share of the vertical force, and still too much, lifts.
constexpr double lifted_share = 1e-4;
/// 1. A wheel of whose elements in contact fewer adhere slides: near full slip some stay in adhesion about
/// the spin's pole. Chosen.
constexpr double sliding_adhesion = 0.05;
/// 1. Step of differences, over the smaller approach: forces then change by some percent.
constexpr double difference_share = 0.02;
/// 1. Kalker's C11 of a circle of steel (4.2): the slope of the longitudinal force at small creepage.
constexpr double kalker_c11 = 4.2;
/// 1. Least share of that slope that is left when friction is used up: of the theory of Vermeulen and
/// Johnson, whose slope vanishes there, and a search could go anywhere.
constexpr double least_creep_slope = 0.03;
/// 1. Creepage that counts in steps like an approach of 1 mm: both then change forces by about their own
/// size.
constexpr double creepage_scale = 0.05;
/// 1. Most that the rolling radius changes in one step, as a creepage: more lies beyond full slip.
constexpr double largest_creepage_step = 3e-3;
/// mm. Heights of both wheels on their rails, before anything is solved, agree within this.
constexpr double stand_tolerance = 1e-4;

/// How forces and moments on both rails change, per mm and rad of the wheelset's motion: a model, good to
/// some ten percent.
struct WheelsetStiffness {
  Wrench by_height, by_roll; ///< down; right side down
  Wrench by_rolling_radius;  ///< at a constant forward speed
};

/// dFx over the longitudinal creepage, N.
double creep_slope(const PatchSummary& p, const SceneResult& r, const SceneFile& scene) {
  const double shear_modulus = shear_modulus_of_pair(scene.rail.material, scene.wheel.material);
  const double bound = r.problem.largest_friction() * p.fn;
  const double used = std::min(1.0, std::hypot(p.fx, p.fs) / bound);
  return kalker_c11 * shear_modulus * p.area / std::numbers::pi *
         std::max(least_creep_slope, std::pow(1 - used, 2.0 / 3));
}

/// Of one wheel, in the frame of its side.
WheelsetStiffness stiffness_of_wheel(const SceneResult& r, Point2 centre, const WheelsetState& state,
                                     const SceneFile& scene) {
  WheelsetStiffness out;
  for (const PatchSummary& p : r.result.patches) {
    const Point2 across = p.position - centre;
    const Vector3 arm{p.x, across.y, across.z};
    const Wrench force = wrench_at({p.fx, p.fy, p.fz}, arm);
    const double by_height = hertz_exponent * std::cos(p.delta) / p.overlap;
    const double lever = across.y + across.z * std::tan(p.delta); // of the normal, over its vertical part
    out.by_height += by_height * force;
    out.by_roll += by_height * lever * force;
    if (state.pose.rolling_radius) {
      const double creepage = across.z / std::pow(*state.pose.rolling_radius, 2); // xi = 1 - r / R
      out.by_rolling_radius += wrench_at({creep_slope(p, r, scene) * creepage, 0, 0}, arm);
    }
  }
  return out;
}

/// Each patch keeps the direction of its force, and its size grows with its approach as Hertz's law has it.
/// The longitudinal force grows with creepage as Kalker's linear theory has it for a circle of the patch's
/// size, and less near full slip (Vermeulen and Johnson 1964).
WheelsetStiffness stiffness_of(const WheelsetState& state, const SceneFile& scene) {
  const double y = state.pose.lateral, z = state.pose.vertical - state.wheel_radius;
  WheelsetStiffness out = stiffness_of_wheel(state.right, {y, z}, state, scene);
  const WheelsetStiffness left = stiffness_of_wheel(state.left, {-y, z}, state, scene);
  out.by_height += mirrored(left.by_height);
  out.by_roll += -1 * mirrored(left.by_roll); // the mirror image rolls the other way
  out.by_rolling_radius += mirrored(left.by_rolling_radius);
  return out;
}

/// The other wheel bears all: the moment of its forces, scaled to wheelset.force, is the largest roll moment.
[[noreturn]] void refuse_lift(WheelSide side, const WheelsetState& state, const SceneFile::Wheelset& given) {
  const Wrench sum = state.sum();
  const double most = state.roll_moment(sum) * *given.force / sum.force[2];
  throw LiftError(
      fmt::format("The {} wheel lifts from its rail", name_of(side)),
      fmt::format("at a lateral displacement of {:g} mm the forces on the other rail, if it bears "
                  "wheelset.force alone, have a moment of about {:.2g} N mm about the wheelset's centre, and "
                  "wheelset.roll_moment is {:g} N mm",
                  state.pose.lateral, most, given.roll_moment),
      fmt::format("Give {}another position.lateral{}.",
                  given.roll_moment != 0 ? "a wheelset.roll_moment nearer to 0, or " : "",
                  given.force_y ? ", or a wheelset.force_y nearer to 0" : ""));
}

/// The equations of equilibrium at one lateral displacement. Unknowns, all in mm: height; roll times half the
/// distance of the contacts; and, if it is looked for, the rolling radius as a creepage over creepage_scale.
class Balance {
public:
  Balance(WheelPair& wheels, double lateral, const WheelsetPose& start)
      : wheels_(wheels), given_(wheels.scene().wheelset), lateral_(lateral), start_(start) {}

  /// Nothing where the wheels cannot be solved, or one of them hangs.
  std::optional<WheelsetState> at(const VectorXd& u) {
    WheelsetPose pose{lateral_, start_.vertical + u[0], start_.roll + u[1] / arm_, start_.rolling_radius};
    if (pose.rolling_radius)
      *pose.rolling_radius *= 1 + creepage_scale * u[2];
    ++evaluations;
    try {
      WheelsetState state = wheels_.at(pose);
      if (certified(state) && !state.right.result.patches.empty() && !state.left.result.patches.empty())
        return state;
    } catch (const InputError&) { // beyond elastic contact, or off the rail
    } catch (const ConvergenceError&) {
    }
    return std::nullopt;
  }

  VectorXd none() const { return VectorXd::Zero(start_.rolling_radius ? 3 : 2); }

  VectorXd residual(const WheelsetState& s) const {
    VectorXd f = equations(s, s.sum());
    f[0] -= 1;
    f[1] -= given_.roll_moment / (force() * arm_);
    if (f.size() > 2)
      f[2] -= given_.torque / (force() * s.wheel_radius);
    return f;
  }

  /// By the model of the stiffness.
  MatrixXd model(const WheelsetState& s) const {
    const WheelsetStiffness k = stiffness_of(s, wheels_.scene());
    MatrixXd out(none().size(), none().size());
    out.col(0) = equations(s, k.by_height);
    out.col(1) = equations(s, 1 / arm_ * k.by_roll);
    if (out.cols() > 2)
      out.col(2) = equations(s, creepage_scale * *start_.rolling_radius * k.by_rolling_radius);
    return out;
  }

  /// How much of a step can be taken: within the bounds of settings.hpp. Throws InputError for a wheel that
  /// lifts.
  double share_of(const WheelsetState& s, const VectorXd& step) const {
    double share = 1;
    for (const WheelSide side : both_sides) {
      const double sign = side == WheelSide::right ? 1 : -1;
      const double approach = s.solved(side).result.totals.approach, more = step[0] + sign * step[1];
      if (more < 0 && s.wrench(side).force[2] < lifted_share * force())
        refuse_lift(side, s, given_);
      if (more < 0)
        share = std::min(share, (1 - least_approach_share) * approach / -more);
      else if (more > 0)
        share = std::min(share, (most_approach_share - 1) * approach / more);
    }
    if (step.size() > 2 && step[2] != 0)
      share = std::min(share, largest_creepage_step / creepage_scale / std::abs(step[2]));
    return share;
  }

  void set_arm(const WheelsetState& s) {
    arm_ = 0.5 * (s.right.motion.reference.position.y + s.left.motion.reference.position.y);
  }

  int evaluations = 0;

private:
  double force() const { return *given_.force; }
  /// What forces on the rails contribute to each equation.
  VectorXd equations(const WheelsetState& s, const Wrench& w) const {
    VectorXd f = none();
    f[0] = w.force[2] / force();
    f[1] = s.roll_moment(w) / (force() * arm_);
    if (f.size() > 2)
      f[2] = s.torque(w) / (force() * s.wheel_radius);
    return f;
  }

  WheelPair& wheels_;
  const SceneFile::Wheelset& given_;
  double lateral_;
  WheelsetPose start_;
  double arm_ = 1; ///< half the distance of the contacts, mm
};

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

/// Newton's method with Broyden's updates.
struct Search {
  Balance& balance;
  double tolerance;
  VectorXd u{}, f{};
  MatrixXd slope{};
  bool exact = false; ///< slope is by differences, here

  /// One step, halved until it lessens the residual. False if none does.
  bool step(WheelsetState& here) {
    VectorXd by = slope.fullPivLu().solve(-f);
    by *= balance.share_of(here, by);
    for (int i = 0; i <= step_halvings; ++i, by *= 0.5) {
      std::optional<WheelsetState> next = balance.at(u + by);
      if (!next)
        continue;
      const VectorXd there = balance.residual(*next);
      slope += (there - f - slope * by) * by.transpose() / by.squaredNorm();
      exact = false;
      if (there.norm() >= f.norm())
        continue;
      u += by;
      f = there;
      here = std::move(*next);
      return true;
    }
    return false;
  }
};

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
  Balance balance(wheels, first.lateral, first);
  Search search{balance, tolerance};
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
