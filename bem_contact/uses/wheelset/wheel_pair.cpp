#include "bem_contact/uses/wheelset/wheel_pair.hpp"

#include "bem_contact/geometry/contact_search.hpp"
#include "bem_contact/scene/wheel_rail_geometry.hpp"
#include "bem_contact/sequence/result_warnings.hpp"
#include "bem_contact/sequence/shared_files.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace bem_contact {

Wrench& Wrench::operator+=(const Wrench& other) {
  for (std::size_t i = 0; i < 3; ++i) {
    force[i] += other.force[i];
    moment[i] += other.moment[i];
  }
  return *this;
}

Wrench operator+(Wrench a, const Wrench& b) {
  return a += b;
}

Wrench operator*(double factor, Wrench w) {
  for (std::size_t i = 0; i < 3; ++i) {
    w.force[i] *= factor;
    w.moment[i] *= factor;
  }
  return w;
}

Wrench wrench_at(const Vector3& f, const Vector3& r) {
  return {f, {r[1] * f[2] - r[2] * f[1], r[2] * f[0] - r[0] * f[2], r[0] * f[1] - r[1] * f[0]}};
}

Wrench mirrored(Wrench w) {
  w.force[1] *= -1;
  w.moment[0] *= -1;
  w.moment[2] *= -1;
  return w;
}

namespace {

/// A force and where it acts, both in the track's frame.
struct PlacedForce {
  Vector3 force, at;
};

/// The sum over the elements in contact. `placed`: of an element at (x, row), the force that it has in its
/// section (x, y, z).
template <class Placed>
Wrench sum_over_elements(const SceneResult& result, Point2 centre, const Placed& placed) {
  Wrench out;
  const ContactGrid& grid = result.problem.grid;
  const double area = result.problem.element_area();
  for (int i = 0; i < grid.size(); ++i) {
    if (!(result.result.pn[i] > 0))
      continue;
    const ContactRow& row = result.problem.rows[i / grid.mx];
    const Point2 across =
        area * (result.result.ps[i] * tangent_of(row.delta) + result.result.pn[i] * normal_of(row.delta));
    const PlacedForce one =
        placed(grid.x(i % grid.mx), row.position, Vector3{area * result.result.px[i], across.y, across.z});
    out += wrench_at(one.force, {one.at[0], one.at[1] - centre.y, one.at[2] - centre.z});
  }
  return out;
}

/// Each half-plane through the roller's axis is turned to where it is.
Wrench wrench_on_roller(const SceneResult& result, Point2 centre, const Roller& roller) {
  return sum_over_elements(result, centre, [&](double x, Point2 at, const Vector3& force) {
    return PlacedForce{Roller::seen(force, -roller.angle(x, at)), roller.in_space(x, at)};
  });
}

/// What the slope of a rail adds to the forces that elements have in its frame, at the middle of the
/// pressure.
Wrench wrench_of_slope(const SceneResult& result, Point2 centre, const Vector3& of_elements) {
  Vector3 middle{};
  double pressed = 0;
  for (const PatchSummary& p : result.result.patches) {
    middle[0] += p.fn * p.x, middle[1] += p.fn * p.position.y, middle[2] += p.fn * p.position.z;
    pressed += p.fn;
  }
  if (!(pressed > 0))
    return {};
  const ContactTotals& totals = result.result.totals;
  const Vector3 whole{totals.Fx + result.motion.slope_force.value_or(0), totals.Fy, totals.Fz};
  return wrench_at(between(of_elements, whole),
                   {middle[0] / pressed, middle[1] / pressed - centre.y, middle[2] / pressed - centre.z});
}

/// Elements have their forces in the rail's frame.
Wrench wrench_on_sections(const SceneResult& result, Point2 centre, const RailFrame& frame) {
  const Wrench out = sum_over_elements(result, centre, [&](double x, Point2 at, const Vector3& force) {
    return PlacedForce{frame.in_track(force), frame.point_in_track({x, at.y, at.z})};
  });
  return out + wrench_of_slope(result, centre, out.force);
}

} // namespace

Wrench wrench_of(const SceneResult& result, Point2 centre, const std::optional<Roller>& roller) {
  if (roller)
    return wrench_on_roller(result, centre, *roller);
  if (result.motion.frame)
    return wrench_on_sections(result, centre, *result.motion.frame);
  const auto [fx, fy, fz, mx, my, mz] =
      force_and_moment(result.problem, result.result, result.problem.rows, centre);
  const Wrench out{{fx, fy, fz}, {mx, my, mz}};
  return result.motion.slope_force ? out + wrench_of_slope(result, centre, out.force) : out;
}

namespace {

/// 1. Elements are chosen for so much of the accuracy asked for, because they are chosen near the
/// equilibrium, not at it: a second round costs more than smaller elements.
constexpr double accuracy_reserve = 0.8;
/// 1. Elements of both wheels count as alike if those of one are no more than so many times as long and wide:
/// the smaller ones for both then cost about twice the elements at most.
constexpr double alike_elements = 1.5;

struct Elements {
  double dx = 0, ds = 0; ///< mm
};

/// Those that were chosen for each wheel; the smaller ones for both if they are alike.
std::pair<Elements, Elements> chosen_elements(const WheelsetState& s) {
  const Elements right{s.right.problem.grid.dx, s.right.problem.grid.ds},
      left{s.left.problem.grid.dx, s.left.problem.grid.ds};
  const Elements least{std::min(right.dx, left.dx), std::min(right.ds, left.ds)},
      most{std::max(right.dx, left.dx), std::max(right.ds, left.ds)};
  const bool alike = most.dx <= alike_elements * least.dx && most.ds <= alike_elements * least.ds;
  return alike ? std::pair{least, least} : std::pair{right, left};
}

} // namespace

double WheelsetState::roll_moment(const Wrench& w) const {
  return dot(w.moment, {std::cos(yaw), std::sin(yaw), 0});
}

double WheelsetState::torque(const Wrench& w) const {
  const double c = std::cos(pose.roll);
  return -dot(w.moment, {-std::sin(yaw) * c, std::cos(yaw) * c, std::sin(pose.roll)});
}

WheelPair::WheelPair(const SceneFile& scene, const std::atomic<bool>* stop,
                     std::shared_ptr<SequenceFiles> files)
    : scene_(scene), stop_(stop), files_(files ? std::move(files) : shared_files()), right_({}, files_),
      left_({}, files_) {
  free_elements();
}

SceneFile WheelPair::wheel_scene(WheelSide side, const WheelsetPose& pose, bool derivatives) const {
  SceneFile out = scene_of(side);
  out.position.lateral = pose.lateral;
  out.position.vertical = pose.vertical + larger(side); // a wheel's own counts from its own radius
  out.position.roll = pose.roll;
  out.motion.free_rolling = false; // one wheel of an axle does not roll freely
  if (pose.rolling_radius) {
    out.motion.rolling_radius = pose.rolling_radius;
    out.motion.pitch_rate.reset();
  }
  if (derivatives)
    out.derivatives = {"load", "lateral", "roll"};
  if (derivatives && pose.rolling_radius)
    out.derivatives.emplace_back("rolling_radius");
  return out;
}

WheelsetState WheelPair::at(const WheelsetPose& pose, bool derivatives) {
  const double yaw = scene_.position.yaw, radius = scene_.position.wheel_radius;
  WheelsetState out{.pose = pose,
                    .yaw = yaw,
                    .wheel_radius = radius,
                    .left_wheel_radius = radius + larger(WheelSide::left),
                    .right = right_.solve(wheel_scene(WheelSide::right, pose, derivatives), stop_),
                    .left = left_.solve(wheel_scene(WheelSide::left, pose, derivatives), stop_)};
  if (right_choice_)
    take_choice(*right_choice_, out.right);
  if (left_choice_)
    take_choice(*left_choice_, out.left);
  const double height = pose.vertical - radius;
  std::optional<Roller> roller;
  if (scene_.position.roller_radius > 0)
    roller = Roller{scene_.position.roller_radius + scene_.position.rail_vertical};
  out.right_wrench = wrench_of(out.right, {pose.lateral, height}, roller);
  out.left_wrench = mirrored(wrench_of(out.left, {-pose.lateral, height}, roller));
  return out;
}

SceneDescription WheelPair::check(WheelSide side, const WheelsetPose& pose) {
  return (side == WheelSide::right ? right_ : left_).check(wheel_scene(side, pose));
}

WheelsetState WheelPair::choose_elements(const WheelsetPose& pose, double factor) {
  free_elements();
  WheelsetState out = at(pose);
  const auto [right, left] = chosen_elements(out);
  right_scene_ = with_elements(std::move(right_scene_), factor * right.dx, factor * right.ds);
  left_scene_ = with_elements(std::move(left_scene_), factor * left.dx, factor * left.ds);
  keep_models(out);
  return out;
}

WheelsetState WheelPair::choose_model(const WheelsetPose& pose, const WheelPair& like) {
  free_elements();
  const SceneFile::Grid &right = like.right_scene_.grid, &left = like.left_scene_.grid;
  right_scene_ = with_elements(std::move(right_scene_), right.dx, right.ds);
  left_scene_ = with_elements(std::move(left_scene_), left.dx, left.ds);
  WheelsetState out = at(pose);
  keep_models(out);
  return out;
}

void WheelPair::keep_models(const WheelsetState& s) {
  right_scene_ = with_model(std::move(right_scene_), s.right.choice.model);
  left_scene_ = with_model(std::move(left_scene_), s.left.choice.model);
  if (scene_.solver.model)
    return;
  right_choice_ = s.right.choice;
  left_choice_ = s.left.choice;
}

void WheelPair::free_elements() {
  right_choice_.reset();
  left_choice_.reset();
  right_scene_ = one_wheel(scene_, WheelSide::right);
  left_scene_ = one_wheel(scene_, WheelSide::left);
  for (SceneFile* scene : {&right_scene_, &left_scene_})
    if (scene->grid.accuracy)
      *scene->grid.accuracy *= accuracy_reserve;
}

double WheelPair::lowered(WheelSide side, double lateral, double roll) {
  const SceneFile& scene = scene_of(side);
  const WheelRailProfiles profiles = read_profiles(scene, *files_);
  WheelsetPosition position = scene.position;
  position.lateral = lateral;
  position.roll = roll;
  WheelOnRail pair = placed_bodies(scene, profiles, position);
  const double before = pair.wheel_pose.origin.z;
  lower_to_touch(pair);
  return pair.wheel_pose.origin.z - before - larger(side);
}

int WheelPair::contact_problems() const {
  return right_.counts().solves + left_.counts().solves;
}

} // namespace bem_contact
