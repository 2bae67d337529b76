#include "bem_contact/uses/wheelset/balance.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/uses/wheelset/equilibrium.hpp"
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

/// 1. A step that does not lessen the residual is halved so often at most.
constexpr int step_halvings = 6;
/// 1. A step leaves each wheel at least this share of its approach, so that no wheel is lifted by accident,
constexpr double least_approach_share = 0.3;
/// 1. and gives it at most so many times of it: forces then grow fivefold.
constexpr double most_approach_share = 3.0;
/// 1. A wheel that bears less than this share of the vertical force, and still too much, lifts.
constexpr double lifted_share = 1e-4;
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
/// mm. Longest step of the lateral displacement together with the other unknowns: on a flange the force
/// changes manifold within some tenths. Chosen.
constexpr double longest_lateral_step = 0.1;

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

/// How forces and moments on one rail change with a number of the wheel's scene, in the frame of its side.
/// Patches keep their places.
Wrench change_of_wheel(const SceneResult& r, Point2 centre, std::string_view number) {
  const auto found = std::ranges::find(r.derivatives, number, &InputDerivatives::name);
  const auto of = [](const std::vector<double>& patch, std::string_view name) {
    const auto names = derived_patch_numbers();
    return patch[std::size_t(std::ranges::find(names, name) - names.begin())];
  };
  Wrench out;
  for (std::size_t k = 0; found != r.derivatives.end() && k < r.result.patches.size(); ++k) {
    const PatchSummary& p = r.result.patches[k];
    const Point2 across = p.position - centre;
    const std::vector<double>& by = found->patches[k];
    out += wrench_at({of(by, "Fx"), of(by, "Fy"), of(by, "Fz")}, {p.x, across.y, across.z});
    out.moment[0] += of(by, "Mx");
  }
  return out;
}

/// The same on both rails, in the track's frame.
Wrench change_of(const WheelsetState& s, std::string_view number) {
  const double y = s.pose.lateral, z = s.pose.vertical - s.wheel_radius;
  return change_of_wheel(s.right, {y, z}, number) + mirrored(change_of_wheel(s.left, {-y, z}, number));
}

} // namespace

std::optional<WheelsetState> Balance::at(const VectorXd& u, bool derivatives) {
  WheelsetPose pose{start_.lateral, start_.vertical + u[0], start_.roll + u[1] / arm_, start_.rolling_radius};
  if (pose.rolling_radius)
    *pose.rolling_radius *= 1 + creepage_scale * u[2];
  if (lateral_force_)
    pose.lateral += u[u.size() - 1];
  ++evaluations;
  try {
    WheelsetState state = wheels_.at(pose, derivatives);
    if (certified(state) && !state.right.result.patches.empty() && !state.left.result.patches.empty())
      return state;
  } catch (const InputError&) { // beyond elastic contact, or off the rail
  } catch (const ConvergenceError&) {
  }
  return std::nullopt;
}

VectorXd Balance::none() const {
  return VectorXd::Zero(2 + (start_.rolling_radius ? 1 : 0) + (lateral_force_ ? 1 : 0));
}

double Balance::resultant() const {
  return std::hypot(force(), *lateral_force_);
}

VectorXd Balance::residual(const WheelsetState& s) const {
  VectorXd f = equations(s, s.sum());
  f[0] -= 1;
  f[1] -= given_.roll_moment / (force() * arm_);
  if (start_.rolling_radius)
    f[2] -= given_.torque / (force() * s.wheel_radius);
  if (lateral_force_)
    f[f.size() - 1] -= *lateral_force_ / resultant();
  return f;
}

MatrixXd Balance::model(const WheelsetState& s) const {
  const WheelsetStiffness k = stiffness_of(s, wheels_.scene());
  MatrixXd out(none().size(), none().size());
  out.col(0) = equations(s, k.by_height);
  out.col(1) = equations(s, 1 / arm_ * k.by_roll);
  if (start_.rolling_radius)
    out.col(2) = equations(s, creepage_scale * *start_.rolling_radius * k.by_rolling_radius);
  return out;
}

MatrixXd Balance::derivatives(const WheelsetState& s) const {
  MatrixXd out(none().size(), none().size());
  out.col(0) = equations(s, change_of(s, "load"));
  out.col(1) = equations(s, 1 / arm_ * change_of(s, "roll"));
  if (start_.rolling_radius)
    out.col(2) = equations(s, creepage_scale * *start_.rolling_radius * change_of(s, "rolling_radius"));
  if (lateral_force_)
    out.col(out.cols() - 1) = equations(s, change_of(s, "lateral"));
  return out;
}

double Balance::share_of(const WheelsetState& s, const VectorXd& step) const {
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
  if (start_.rolling_radius && step[2] != 0)
    share = std::min(share, largest_creepage_step / creepage_scale / std::abs(step[2]));
  if (lateral_force_ && step[step.size() - 1] != 0)
    share = std::min(share, longest_lateral_step / std::abs(step[step.size() - 1]));
  return share;
}

void Balance::set_arm(const WheelsetState& s) {
  arm_ = 0.5 * (s.right.motion.reference.position.y + s.left.motion.reference.position.y);
}

VectorXd Balance::equations(const WheelsetState& s, const Wrench& w) const {
  VectorXd f = none();
  f[0] = w.force[2] / force();
  f[1] = s.roll_moment(w) / (force() * arm_);
  if (start_.rolling_radius)
    f[2] = s.torque(w) / (force() * s.wheel_radius);
  if (lateral_force_)
    f[f.size() - 1] = w.force[1] / resultant();
  return f;
}

bool BalanceSearch::step(WheelsetState& here) {
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

} // namespace bem_contact
