#include "bem_contact/uses/wheelset/solve_wheelset.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/base/stopwatch.hpp"
#include "bem_contact/scene/warnings.hpp"
#include "bem_contact/sequence/asked_error.hpp"
#include "bem_contact/sequence/lateral/lateral_curve.hpp"
#include "bem_contact/sequence/lateral/lateral_force.hpp"
#include "bem_contact/sequence/lateral/settings.hpp"
#include "bem_contact/sequence/quantities.hpp"
#include "bem_contact/sequence/result_warnings.hpp"
#include "bem_contact/sequence/sequence.hpp"
#include "bem_contact/sequence/shared_files.hpp"
#include "bem_contact/uses/wheelset/equilibrium_finder.hpp"
#include "bem_contact/uses/wheelset/settings.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
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

/// Steps from the start of a search to one side, until the force passes the wanted one.
class Walk {
public:
  /// `side`: -1 or 1; `up`: 1 where the force must grow from the start to be met, else -1.
  Walk(const LateralForce& force, const LateralSample& start, double side, double up, double wanted)
      : best(start), force_(force), start_(start), here_(start), side_(side), up_(up), wanted_(wanted) {}

  /// One step. True if the force passes the wanted one between `before` and `beyond`.
  bool step() {
    const double at = here_.lateral + side_ * step_;
    const std::optional<double> there = force_(at);
    if (!there) {
      step_ *= 0.5;
      ended |= step_ < least_lateral_step;
      return false;
    }
    beyond = {at, *there};
    ended |= std::abs(at - start_.lateral) >= lateral_search_reach;
    if (up_ * (*there - wanted_) >= 0) {
      before = here_;
      return true;
    }
    if (up_ * (*there - best.force) > 0) {
      before = here_;
      best = beyond;
    }
    here_ = beyond;
    step_ = std::min(lateral_step_growth * step_, largest_lateral_step);
    return false;
  }

  bool ended = false;
  LateralSample best, before = best, beyond = best; ///< the best so far, and the one before it

private:
  const LateralForce& force_;
  LateralSample start_, here_;
  double side_, up_, wanted_;
  double step_ = first_lateral_step;
};

/// The displacement nearest to `start` at which the lateral forces on both rails add up to about `wanted`, N;
/// within rough_lateral_width. `force`: this sum at a displacement, nothing where the wheelset does not
/// stand. The force grows with the displacement until a wheel climbs its rail, so the search goes to that
/// side; and to the other one too where the force at first does not do so. `best` is the one on the way that
/// is nearest to the wanted one; nothing if that is not met.
std::optional<LateralRoot> search_lateral(const LateralForce& force, const LateralSample& start,
                                          double wanted, LateralSample& best) {
  const double up = start.force < wanted ? 1 : -1;
  Walk walk(force, start, up, up, wanted), back(force, start, -up, up, wanted);
  const auto bracketed = [&](const Walk& w) { return narrow(force, w.before, w.beyond, wanted); };
  bool falls = false, first = true;
  while (!walk.ended || (falls && !back.ended)) {
    if (!walk.ended && walk.step())
      return bracketed(walk);
    falls |= first && up * (walk.beyond.force - start.force) < 0;
    first &= walk.beyond.lateral == start.lateral;
    if (falls && !back.ended && back.step())
      return bracketed(back);
  }
  best = walk.best;
  climb(force, up, wanted, best);
  return up * (best.force - wanted) >= 0 ? std::optional(narrow(force, walk.before, best, wanted))
                                         : std::nullopt;
}

/// An equilibrium at each displacement that is tried, from the nearest one before.
class Follower {
public:
  Follower(EquilibriumFinder& finder, double lateral, const EquilibriumStart& start, double tolerance)
      : finder_(finder), tolerance_(tolerance), known_{{lateral, start, {}}} {}

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
    last_ = finder_.at(lateral, near(lateral), tolerance_);
    const double force = last_->state.sum().force[1];
    known_.push_back({lateral, last_->start(), force});
    return force;
  }

  /// dFy/dy from `here` to the nearest displacement that was tried whose force differs by `telling`, N; N/mm.
  std::optional<double> slope_beside(const LateralSample& here, double telling) const {
    std::optional<double> slope;
    double nearest = std::numeric_limits<double>::infinity();
    for (const Known& k : known_) {
      const double apart = k.lateral - here.lateral, more = k.force.value_or(here.force) - here.force;
      if (std::abs(more) < telling || std::abs(apart) >= nearest)
        continue;
      nearest = std::abs(apart);
      slope = more / apart;
    }
    return slope;
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
    std::optional<double> force; ///< N; nothing of the first one
  };
  EquilibriumFinder& finder_;
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
};

/// The same question on larger elements, with half-spaces.
class RoughSearch {
public:
  RoughSearch(const SceneFile& scene, const std::atomic<bool>* stop,
              const std::shared_ptr<SequenceFiles>& files)
      : finder_(with_half_spaces(scene), stop, files),
        follower_(finder_, scene.position.lateral, finder_.begin(scene.position.lateral, rough_elements),
                  rough_tolerance),
        start_{scene.position.lateral, follower_.required_force(scene.position.lateral)},
        wanted_(*scene.wheelset.force_y) {}

  double start_misses() const { return std::abs(start_.force - wanted_); } ///< N

  RoughPlace place() {
    LateralSample best;
    const std::optional<LateralRoot> guess =
        search_lateral([&](double y) { return follower_.force(y); }, start_, wanted_, best);
    if (!guess)
      refuse_lateral(
          {wanted_, start_.lateral, best, follower_.lifts(), finder_.scene().wheelset.roll_moment});
    return {*guess, follower_.last().state.pose, follower_.near(guess->lateral)};
  }
  int contact_problems() const { return finder_.contact_problems(); }

private:
  EquilibriumFinder finder_;
  Follower follower_;
  LateralSample start_;
  double wanted_;
};

/// An equilibrium, with the error of its lateral displacement where that was found (WheelsetResult).
struct FoundEquilibrium {
  Equilibrium equilibrium;
  double lateral_error = unknown_error;
};

/// How far the displacement is off where the forces are off by their stated errors, mm.
double error_of_lateral(Follower& follower, const Equilibrium& found, double resultant) {
  const Quantity& lateral = quantity("Fy");
  const double error = std::hypot(lateral.error(found.state.right), lateral.error(found.state.left));
  if (std::isnan(error))
    return unknown_error;
  const LateralSample here{found.state.pose.lateral, found.state.sum().force[1]};
  const double telling = telling_lateral_force * resultant;
  std::optional<double> slope = follower.slope_beside(here, telling);
  for (double away = first_lateral_step; !slope && away <= lateral_search_reach; away *= 2) {
    for (const double side : {+away, -away})
      follower.force(here.lateral + side);
    slope = follower.slope_beside(here, telling);
  }
  return slope ? error / std::abs(*slope) : unknown_error;
}

/// Whether the lateral force is met.
bool meets(const SceneFile::Wheelset& given, const Equilibrium& e) {
  return std::abs(e.state.sum().force[1] - *given.force_y) <=
         lateral_balance * std::hypot(*given.force, *given.force_y);
}

/// Whether some wheel's elements are too large for the accuracy asked for, or to tell.
bool too_coarse(const SceneFile& scene, const WheelsetState& s) {
  const auto coarse = [&](const SceneResult& r) {
    const double error = asked_error(scene.grid, r);
    return error < 0 || error > *scene.grid.accuracy;
  };
  return scene.grid.accuracy && (coarse(s.right) || coarse(s.left));
}

/// The equilibrium under wheelset.force_y. `guess` without a slope: that of the first step is taken.
FoundEquilibrium at_lateral_force(EquilibriumFinder& finder, const SceneFile& scene,
                                  const EquilibriumStart& start, LateralRoot guess, bool last_round) {
  const SceneFile::Wheelset& given = scene.wheelset;
  const double resultant = std::hypot(*given.force, *given.force_y);
  Follower follower(finder, guess.lateral, start, equilibrium_tolerance / 10);
  const LateralForce force = [&](double y) { return follower.force(y); };
  if (guess.slope == 0 && follower.force(guess.lateral) && !meets(given, follower.last())) {
    const double here = follower.last().state.sum().force[1];
    if (const auto beside = follower.force(guess.lateral + first_lateral_step))
      guess.slope = (*beside - here) / first_lateral_step;
  }
  const double lateral = solve_lateral_force(force, *given.force_y, guess, lateral_balance * resultant);
  if (follower.last().state.pose.lateral != lateral)
    follower.required_force(lateral);
  FoundEquilibrium out{follower.last()};
  if (last_round || !too_coarse(scene, out.equilibrium.state))
    out.lateral_error = error_of_lateral(follower, out.equilibrium, resultant);
  return out;
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

namespace {

/// Where the search for the equilibrium begins; elements are chosen there. Under a lateral force that is
/// where rough solutions meet it, or the start itself where that meets it.
RoughPlace first_place(EquilibriumFinder& finder, const std::atomic<bool>* stop,
                       const std::shared_ptr<SequenceFiles>& files, int& contact_problems) {
  const SceneFile& scene = finder.scene();
  const double start = scene.position.lateral;
  RoughPlace out{{start, 0}, {}, {}};
  if (!scene.wheelset.force_y) {
    out.start = finder.begin(start);
    return out;
  }
  const SceneFile::Wheelset& given = scene.wheelset;
  RoughSearch rough(scene, stop, files);
  contact_problems = rough.contact_problems();
  if (rough.start_misses() <= near_lateral_force * std::hypot(*given.force, *given.force_y)) {
    try {
      out.start = finder.begin(start);
      const Equilibrium there = finder.at(start, out.start, equilibrium_tolerance / 10);
      out.start = there.start();
      if (meets(given, there))
        return out;
    } catch (const InputError&) { // the search may lead to where there is one
    } catch (const ConvergenceError&) {
    }
  }
  out = rough.place();
  contact_problems = rough.contact_problems();
  finder.choose_elements(out.pose);
  return out;
}

} // namespace

WheelsetResult solve_wheelset(const SceneFile& scene, const std::atomic<bool>* stop,
                              std::shared_ptr<SequenceFiles> files) {
  require_wheelset(scene);
  const Stopwatch clock;
  if (!files)
    files = shared_files();
  EquilibriumFinder finder(scene, stop, files);
  int rough_problems = 0;
  RoughPlace place = first_place(finder, stop, files, rough_problems);
  std::optional<FoundEquilibrium> found;
  for (int round = 1;; ++round) {
    found = scene.wheelset.force_y
                ? at_lateral_force(finder, scene, place.start, place.guess, round == most_element_rounds)
                : FoundEquilibrium{finder.at(place.guess.lateral, place.start, equilibrium_tolerance)};
    const Equilibrium& there = found->equilibrium;
    if (round == most_element_rounds || !too_coarse(scene, there.state))
      break;
    finder.choose_elements_again(there.state.pose);
    place.start = there.start();
    place.guess.lateral = there.state.pose.lateral;
  }
  Equilibrium& there = found->equilibrium;
  WheelsetResult out{.state = std::move(there.state), .residual = there.residual};
  if (scene.wheelset.force_y) {
    out.lateral_residual =
        std::abs(out.state.sum().force[1] - *scene.wheelset.force_y) / *scene.wheelset.force;
    out.lateral_error = found->lateral_error;
  }
  out.contact_problems = finder.contact_problems() + rough_problems;
  add_warnings(scene, out);
  out.seconds = clock.seconds();
  return out;
}

} // namespace bem_contact
