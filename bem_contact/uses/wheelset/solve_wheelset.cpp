#include "bem_contact/uses/wheelset/solve_wheelset.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/base/stopwatch.hpp"
#include "bem_contact/scene/warnings.hpp"
#include "bem_contact/sequence/asked_error.hpp"
#include "bem_contact/sequence/lateral/lateral_curve.hpp"
#include "bem_contact/sequence/lateral/lateral_force.hpp"
#include "bem_contact/sequence/result_warnings.hpp"
#include "bem_contact/sequence/sequence.hpp"
#include "bem_contact/sequence/shared_files.hpp"
#include "bem_contact/uses/wheelset/equilibrium.hpp"
#include "bem_contact/uses/wheelset/settings.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <utility>

namespace bem_contact {

namespace {

/// Narrows an interval at whose ends the force is on different sides of `wanted`: where the line between
/// both meets it, but not too near to an end, because on a flange the force is no line. Where no equilibrium
/// is found, nearer to `a`: an equilibrium leads to those beside it.
LateralRoot narrow(const LateralForce& force, LateralSample a, LateralSample b, double wanted) {
  const double first_slope = (b.force - a.force) / (b.lateral - a.lateral);
  const auto met = [&] { return (wanted - a.force) / (b.force - a.force); };
  double reach = 1; // share of the way to b that leads to an equilibrium
  while (std::abs(b.lateral - a.lateral) > rough_lateral_width) {
    const double share = reach * std::clamp(met(), least_narrowing, 1 - least_narrowing);
    const double between = a.lateral + share * (b.lateral - a.lateral);
    const std::optional<double> there = force(between);
    if (!there) {
      reach *= 0.5;
      if (reach * std::abs(b.lateral - a.lateral) < least_lateral_step)
        break;
      continue;
    }
    reach = std::min(1.0, 2 * reach);
    auto& replaced = (*there - wanted) * (a.force - wanted) > 0 ? a : b;
    replaced = {between, *there};
  }
  const double slope = (b.force - a.force) / (b.lateral - a.lateral);
  return slope > 0 ? LateralRoot{a.lateral + (wanted - a.force) / slope, slope}
                   : LateralRoot{a.lateral, first_slope}; // rough forces so near to each other say nothing
}

/// How a search for a lateral force ended that is not met.
struct FailedSearch {
  double wanted = 0, start = 0;
  LateralSample best; ///< the force nearest to it
  bool lifts = false; ///< a wheel lifts beyond
  double roll_moment = 0;
};

[[noreturn]] void refuse_lateral(const FailedSearch& f) {
  const bool more = f.best.force < f.wanted;
  throw InputError(
      fmt::format("No lateral displacement gives the wheelset a lateral force of {:g} N", f.wanted),
      fmt::format(
          "by a search with larger elements, from {:g} mm on the rails bear {} about {:.1e} N, at about "
          "{:.1f} mm; beyond that {}",
          f.start, more ? "up to" : "down to", f.best.force, f.best.lateral,
          f.lifts ? "a wheel lifts from its rail" : "the flange climbs the rail"),
      fmt::format("Give a wheelset.force_y {} that, {}, or another position.lateral.",
                  more ? "below" : "above",
                  f.lifts && f.roll_moment != 0 ? "a wheelset.roll_moment nearer to 0" : "less friction"));
}

/// Moves `best` to where the force is largest (side -1: least) around it, or to the first one that reaches
/// `wanted`. The last displacement that is tried lies beyond it.
void climb(const LateralForce& force, double side, double wanted, LateralSample& best) {
  for (double step = 0.5 * largest_lateral_step; step > least_lateral_step;) {
    const double before = best.lateral;
    for (const double way : {-side, side}) {
      const double at = before + way * step;
      const std::optional<double> there = force(at);
      if (there && side * (*there - best.force) > 0)
        best = {at, *there};
      if (side * (best.force - wanted) >= 0)
        return;
    }
    if (best.lateral == before)
      step *= 0.5;
  }
}

/// The first displacement from `start` on at which the lateral forces on both rails add up to about
/// `wanted`, N; within rough_lateral_width. `force`: this sum at a displacement, nothing where the wheelset
/// does not stand. The force grows with the displacement until a wheel climbs its rail, so the search goes
/// to that side. `best` is the one on the way that is nearest to the wanted one; nothing if that is not
/// met.
std::optional<LateralRoot> search_lateral(const LateralForce& force, const LateralSample& start,
                                          double wanted, LateralSample& best) {
  const double side = start.force < wanted ? 1 : -1;
  LateralSample here = start, before = start; // before the best one
  best = start;
  double step = first_lateral_step;
  while (std::abs(here.lateral - start.lateral) < lateral_search_reach) {
    const double at = here.lateral + side * step;
    const std::optional<double> there = force(at);
    if (there && side * (*there - wanted) >= 0)
      return narrow(force, here, {at, *there}, wanted);
    if (!there) {
      step *= 0.5;
      if (step < least_lateral_step)
        break;
      continue;
    }
    if (side * (*there - best.force) > 0) {
      before = here;
      best = {at, *there};
    }
    here = {at, *there};
    step = std::min(lateral_step_growth * step, largest_lateral_step);
  }
  climb(force, side, wanted, best);
  return side * (best.force - wanted) >= 0 ? std::optional(narrow(force, before, best, wanted))
                                           : std::nullopt;
}

/// Whether the rolling radius of the axle follows from its torque.
bool finds_rolling_radius(const SceneFile& scene) {
  const SceneFile::Motion& m = scene.motion;
  return !m.frictionless && !m.rolling_radius && !m.pitch_rate;
}

/// Of the wheel where its largest patch lies, mm.
double radius_at_contact(const SceneResult& r, double wheel_radius) {
  return wheel_radius + (r.patch_places.empty() ? 0.0 : r.patch_places.front().wheel_z);
}

/// Approaches and rolling radius by rule of thumb.
EquilibriumStart first_guess(const SceneFile& scene) {
  const double softer = std::min(scene.rail.material.young(), scene.wheel.material.young());
  const double share = 0.5 * *scene.wheelset.force / 1e5 * Material().young() / softer;
  const double approach = usual_approach * std::pow(share, 1 / hertz_exponent);
  return {approach, approach, 0, {}};
}

/// The start for the equations, from a solution at the guess: elements are chosen there and kept, `factor`
/// times as large.
EquilibriumStart begin(WheelPair& wheels, double lateral, double factor = 1) {
  EquilibriumStart start = first_guess(wheels.scene());
  const WheelsetState s = wheels.choose_elements(stand(wheels, lateral, start), factor);
  start.roll = s.pose.roll;
  const double half = 0.5 * *wheels.scene().wheelset.force;
  const auto nearer = [&](const SceneResult& r) {
    const double ratio = std::clamp(half / std::max(r.result.Fz, 0.1 * half), 0.1, 10.0);
    return r.result.approach * std::pow(ratio, 1 / hertz_exponent);
  };
  start.right = nearer(s.right);
  start.left = nearer(s.left);
  if (finds_rolling_radius(wheels.scene()))
    start.rolling_radius =
        0.5 * (radius_at_contact(s.right, s.wheel_radius) + radius_at_contact(s.left, s.wheel_radius));
  return start;
}

/// The same question for half-spaces.
SceneFile rough_scene(const SceneFile& scene) {
  SceneFile out = with_model(scene, Model::halfspace);
  out.stresses.depths.clear();
  return out;
}

/// An equilibrium at each displacement that is tried, from the nearest one before.
class Follower {
public:
  Follower(WheelPair& wheels, double lateral, const EquilibriumStart& start, double tolerance)
      : wheels_(wheels), tolerance_(tolerance), known_{{lateral, start}} {}

  std::optional<double> force(double lateral) {
    lifts_ = false;
    try {
      return required_force(lateral);
    } catch (const LiftError&) {
      lifts_ = true;
    } catch (const InputError&) { // a wheel leaves its rail
    } catch (const ConvergenceError&) {
    }
    return std::nullopt;
  }

  /// The same; throws what find_equilibrium() throws.
  double required_force(double lateral) {
    last_ = find_equilibrium(wheels_, lateral, near(lateral), tolerance_);
    known_.push_back({lateral, last_->start()});
    return last_->state.sum().force[1];
  }

  bool lifts() const { return lifts_; } ///< whether a wheel lifted where a force was asked for last
  const Equilibrium& last() const { return *last_; } ///< once there is one
  const EquilibriumStart& near(double lateral) const {
    return std::ranges::min_element(known_, {}, [&](const Known& k) { return std::abs(k.lateral - lateral); })
        ->start;
  }

private:
  struct Known {
    double lateral = 0;
    EquilibriumStart start;
  };
  WheelPair& wheels_;
  double tolerance_;
  std::vector<Known> known_;
  std::optional<Equilibrium> last_;
  bool lifts_ = false;
};

/// About where the lateral force is met.
struct RoughPlace {
  LateralRoot guess;
  WheelsetPose pose;      ///< of the last equilibrium that was tried, near it
  EquilibriumStart start; ///< there
  int contact_problems = 0;
};
RoughPlace search_roughly(const SceneFile& scene, const std::atomic<bool>* stop,
                          const std::shared_ptr<SequenceFiles>& files) {
  WheelPair wheels(rough_scene(scene), stop, files);
  const double start = scene.position.lateral, wanted = *scene.wheelset.force_y;
  Follower follower(wheels, start, begin(wheels, start, rough_elements), rough_tolerance);
  LateralSample best;
  const std::optional<LateralRoot> guess = search_lateral(
      [&](double y) { return follower.force(y); }, {start, follower.required_force(start)}, wanted, best);
  if (!guess)
    refuse_lateral({wanted, start, best, follower.lifts(), scene.wheelset.roll_moment});
  return {*guess, follower.last().state.pose, follower.near(guess->lateral), wheels.contact_problems()};
}

/// The equilibrium under wheelset.force_y.
Equilibrium at_lateral_force(WheelPair& wheels, const EquilibriumStart& start, const LateralRoot& guess) {
  const SceneFile::Wheelset& given = wheels.scene().wheelset;
  Follower follower(wheels, guess.lateral, start, equilibrium_tolerance / 10);
  const double lateral =
      solve_lateral_force([&](double y) { return follower.force(y); }, *given.force_y, guess,
                          lateral_balance * std::hypot(*given.force, *given.force_y));
  if (follower.last().state.pose.lateral != lateral)
    return find_equilibrium(wheels, lateral, follower.near(lateral), equilibrium_tolerance / 10);
  return follower.last();
}

/// Whether some wheel's elements are too large for the accuracy asked for, or to tell.
bool too_coarse(const SceneFile& scene, const WheelsetState& s) {
  const auto coarse = [&](const SceneResult& r) {
    const double error = asked_error(scene.grid, r);
    return error < 0 || error > *scene.grid.accuracy;
  };
  return scene.grid.accuracy && (coarse(s.right) || coarse(s.left));
}

void add_warnings(const SceneFile& scene, WheelsetResult& out) {
  std::vector<PlacedWarning> all;
  for (const WheelSide side : both_sides)
    for (const std::string& warning : out.state.solved(side).warnings)
      all.push_back({fmt::format("{} wheel", name_of(side)), warning});
  out.warnings = once_each(all);
  warn_of_kilonewtons("wheelset.force", *scene.wheelset.force, 2, out.warnings);
  if (too_coarse(scene, out.state))
    out.warnings.push_back("the accuracy asked for was not reached: the equilibrium is found on the elements "
                           "that were chosen near it");
}

void require_wheelset(const SceneFile& scene) {
  if (!scene.wheelset.force)
    throw InputError(
        "This scene is of one wheel", "wheelset.force is not given",
        "Give the vertical force on the axle as force in a table [wheelset], instead of [load].");
}

} // namespace

WheelsetDescription check_wheelset(const SceneFile& scene) {
  require_wheelset(scene);
  WheelPair wheels(scene);
  const WheelsetPose pose = stand(wheels, scene.position.lateral, first_guess(scene));
  WheelsetDescription out{pose.lateral, pose.roll, wheels.check(WheelSide::right, pose),
                          wheels.check(WheelSide::left, pose)};
  warn_of_kilonewtons("wheelset.force", *scene.wheelset.force, 2, out.warnings);
  return out;
}

SceneDescription describe_scene(const SceneFile& scene) {
  if (!scene.wheelset.force)
    return Sequence().check(scene);
  const WheelsetDescription both = check_wheelset(scene);
  SceneDescription out{
      {fmt::format("wheelset: the search for its equilibrium begins at a lateral displacement "
                   "of {:g} mm and a roll of {:.3g} rad",
                   both.lateral, both.roll)},
      both.warnings};
  for (const auto& [title, wheel] :
       {std::pair{"right wheel", &both.right}, std::pair{"left wheel (y, s to the left)", &both.left}}) {
    out.lines.push_back(title);
    out.add(*wheel);
  }
  return out;
}

WheelsetResult solve_wheelset(const SceneFile& scene, const std::atomic<bool>* stop,
                              std::shared_ptr<SequenceFiles> files) {
  require_wheelset(scene);
  const Stopwatch clock;
  if (!files)
    files = shared_files();
  WheelPair wheels(scene, stop, files);
  RoughPlace rough{{scene.position.lateral, 0}, {}, {}};
  if (scene.wheelset.force_y) {
    rough = search_roughly(scene, stop, files);
    wheels.choose_elements(rough.pose);
  } else {
    rough.start = begin(wheels, scene.position.lateral);
  }
  std::optional<Equilibrium> found;
  for (int round = 1;; ++round) {
    found = scene.wheelset.force_y
                ? at_lateral_force(wheels, rough.start, rough.guess)
                : find_equilibrium(wheels, rough.guess.lateral, rough.start, equilibrium_tolerance);
    if (round == most_element_rounds || !too_coarse(scene, found->state))
      break;
    wheels.choose_elements(found->state.pose);
    rough.start = found->start();
    rough.guess.lateral = found->state.pose.lateral;
  }
  WheelsetResult out{.state = std::move(found->state), .residual = found->residual};
  if (scene.wheelset.force_y)
    out.lateral_residual =
        std::abs(out.state.sum().force[1] - *scene.wheelset.force_y) / *scene.wheelset.force;
  out.contact_problems = wheels.contact_problems() + rough.contact_problems;
  add_warnings(scene, out);
  out.seconds = clock.seconds();
  return out;
}

} // namespace bem_contact
