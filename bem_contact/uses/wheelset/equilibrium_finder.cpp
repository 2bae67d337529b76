#include "bem_contact/uses/wheelset/equilibrium_finder.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/sequence/models.hpp"
#include "bem_contact/uses/wheelset/settings.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace bem_contact {

namespace {

/// Whether the rolling radius of the axle follows from its torque.
bool finds_rolling_radius(const SceneFile& scene) {
  const SceneFile::Motion& m = scene.motion;
  return !m.frictionless && !m.rolling_radius && !m.pitch_rate;
}

/// Of the wheel where its largest patch lies, mm.
double radius_at_contact(const SceneResult& r, double wheel_radius) {
  return wheel_radius + (r.patch_places.empty() ? 0.0 : r.patch_places.front().wheel_z);
}

/// The start for the equations, from a solution at the guess: elements are chosen there and kept, `factor`
/// times as large.
EquilibriumStart begin_at(WheelPair& wheels, double lateral, double factor) {
  EquilibriumStart start = first_guess(wheels.scene());
  const WheelsetState s = wheels.choose_elements(stand(wheels, lateral, start), factor);
  start.roll = s.pose.roll;
  const double half = 0.5 * *wheels.scene().wheelset.force;
  const auto nearer = [&](const SceneResult& r) {
    const double ratio = std::clamp(half / std::max(r.result.totals.Fz.value, 0.1 * half), 0.1, 10.0);
    return r.result.totals.approach * std::pow(ratio, 1 / hertz_exponent);
  };
  start.right = nearer(s.right);
  start.left = nearer(s.left);
  if (finds_rolling_radius(wheels.scene()))
    start.rolling_radius =
        0.5 * (radius_at_contact(s.right, s.wheel_radius) + radius_at_contact(s.left, s.left_wheel_radius));
  return start;
}

/// Whether half-spaces with the same elements come near the model.
bool half_spaces_are_near(const SceneFile& scene) {
  const bool files = scene.rail.has_influence() || scene.wheel.has_influence() ||
                     !scene.wheelset.left_rail.influence.empty() ||
                     !scene.wheelset.left_wheel.influence.empty();
  return scene.solver.model ? turns_with_rows(*scene.solver.model) : !files;
}

/// `a` with `factor` times `b` added to its height, roll and rolling radius.
WheelsetPose moved(WheelsetPose a, double factor, const WheelsetPose& b) {
  a.vertical += factor * b.vertical;
  a.roll += factor * b.roll;
  if (a.rolling_radius)
    *a.rolling_radius += factor * b.rolling_radius.value_or(0);
  return a;
}

} // namespace

SceneFile with_half_spaces(const SceneFile& scene) {
  SceneFile out = with_model(scene, rough_model);
  out.stresses.depths.clear();
  return out;
}

EquilibriumStart first_guess(const SceneFile& scene) {
  const double softer = std::min(scene.rail.material.young(), scene.wheel.material.young());
  const double share = 0.5 * *scene.wheelset.force / 1e5 * Material().young() / softer;
  const double approach = usual_approach * std::pow(share, 1 / hertz_exponent);
  return {approach, approach, 0, {}};
}

EquilibriumFinder::EquilibriumFinder(const SceneFile& scene, const std::atomic<bool>* stop,
                                     const std::shared_ptr<SequenceFiles>& files)
    : wheels_(scene, stop, files),
      quick_(half_spaces_are_near(scene) ? std::make_unique<WheelPair>(with_half_spaces(scene), stop, files)
                                         : nullptr) {}

EquilibriumStart EquilibriumFinder::begin(double lateral, double factor) {
  first_.reset();
  if (quick_) {
    try {
      Equilibrium quick =
          find_equilibrium(*quick_, lateral, begin_at(*quick_, lateral, factor), equilibrium_tolerance);
      const EquilibriumStart start = quick.start();
      WheelsetState state = wheels_.choose_model(quick.state.pose, *quick_);
      if (certified(state))
        first_ = {std::move(quick), std::move(state)};
      return start;
    } catch (const InputError&) { // the model itself says what is wrong
    } catch (const ConvergenceError&) {
    }
    quick_.reset();
  }
  return begin_at(wheels_, lateral, factor);
}

void EquilibriumFinder::choose_elements(const WheelsetPose& pose) {
  first_.reset();
  if (!quick_) {
    wheels_.choose_elements(pose);
    return;
  }
  quick_->choose_elements(pose);
  wheels_.choose_model(pose, *quick_);
}

void EquilibriumFinder::choose_elements_again(const WheelsetPose& pose) {
  first_.reset();
  wheels_.choose_elements(pose);
}

std::optional<Equilibrium> EquilibriumFinder::by_half_spaces(double lateral, const EquilibriumStart& start,
                                                             double tolerance) {
  try {
    if (quick_)
      return find_equilibrium(*quick_, lateral, start, tolerance);
  } catch (const InputError&) { // the model itself says what is wrong
  } catch (const ConvergenceError&) {
  }
  return std::nullopt;
}

Equilibrium EquilibriumFinder::at(double lateral, const EquilibriumStart& start, double tolerance) {
  const std::optional<First> first = std::move(first_);
  first_.reset();
  const bool known = first && first->state.pose.lateral == lateral;
  const std::optional<Equilibrium> quick =
      known ? std::optional(first->quick) : by_half_spaces(lateral, start, tolerance);
  if (!quick)
    return find_equilibrium(wheels_, lateral, start, tolerance);
  const WheelsetPose& pose = quick->state.pose;
  try {
    Equilibrium out = known ? find_equilibrium(wheels_, pose, tolerance, quick->slope, &first->state)
                            : find_equilibrium(wheels_, moved(pose, 1, beyond_), tolerance, quick->slope);
    beyond_ = moved(out.state.pose, -1, pose);
    return out;
  } catch (const InputError&) { // it may be found from the other start
  } catch (const ConvergenceError&) {
  }
  return find_equilibrium(wheels_, lateral, start, tolerance);
}

int EquilibriumFinder::contact_problems() const {
  return wheels_.contact_problems() + (quick_ ? quick_->contact_problems() : 0);
}

} // namespace bem_contact
