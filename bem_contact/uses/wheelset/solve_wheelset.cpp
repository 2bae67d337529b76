#include "bem_contact/uses/wheelset/solve_wheelset.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/base/stopwatch.hpp"
#include "bem_contact/scene/warnings.hpp"
#include "bem_contact/sequence/asked_error.hpp"
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

/// mm. First step of the lateral search, and factor by which the next one is longer as long as the force is
/// not passed.
constexpr double first_lateral_step = 0.25;
/// 1. As above.
constexpr double lateral_step_growth = 1.4;
/// mm. Longest step: a flange takes up its force within a few tenths, and holds it for some millimetres.
constexpr double largest_lateral_step = 1.0;
/// mm. Shortest step towards displacements at which the wheelset does not stand: two flanges in their gauge
/// corners have some hundredths.
constexpr double least_lateral_step = 2e-3;
/// mm. The search ends so far from position.lateral: a wheelset has some 7 mm to either side.
constexpr double lateral_search_reach = 14.0;
/// 1. Elements of the rough half-space solutions are so many times as long and wide.
constexpr double rough_elements = 2.0;
/// 1. Residuals of rough solutions: on the tread the lateral force changes by some 1e-3 of the vertical one
/// in rough_lateral_width.
constexpr double rough_tolerance = 1e-5;
/// 1. An interval that holds such a displacement gets narrower by at least this share of it.
constexpr double least_narrowing = 0.15;
/// mm. Rough displacements are found within this.
constexpr double rough_lateral_width = 0.03;
/// 1. Most rounds in which elements are chosen again for the accuracy asked for.
constexpr int most_element_rounds = 3;

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
  return slope * first_slope > 0
             ? LateralRoot{a.lateral + (wanted - a.force) / slope, slope}
             : LateralRoot{a.lateral, first_slope}; // rough forces so near to each other say nothing
}

/// How a search for a lateral force ended that is not met.
struct FailedSearch {
  double wanted = 0, start = 0;
  LateralSample best; ///< the force nearest to it
  bool lifts = false; ///< a wheel lifts beyond
  double roll_moment = 0;
  double of_curve = 0; ///< N, in `wanted`
};

[[noreturn]] void refuse_lateral(const FailedSearch& f) {
  const bool more = f.best.force < f.wanted;
  throw InputError(
      fmt::format("No lateral displacement gives the wheelset a lateral force of {:g} N{}", f.wanted,
                  f.of_curve != 0 ? fmt::format(" (in which {:g} N are the curve's)", f.of_curve) : ""),
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
/// stand. On the flange the force grows with the displacement until a wheel climbs its rail, so the search
/// goes to that side. On the tread it may fall, too: to the other side as well where the start is `near` the
/// force, or where the force at first falls. `best` is the one on the way that is nearest to the wanted one;
/// nothing if that is not met.
std::optional<LateralRoot> search_lateral(const LateralForce& force, const LateralSample& start,
                                          double wanted, bool near, LateralSample& best) {
  const double up = start.force < wanted ? 1 : -1;
  Walk walk(force, start, up, up, wanted), back(force, start, -up, up, wanted);
  const auto bracketed = [&](const Walk& w) { return narrow(force, w.before, w.beyond, wanted); };
  bool falls = near, first = true;
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

  bool lifts() const { return lifts_; } ///< whether a wheel lifted where a force was asked for last
  const Equilibrium& last() const { return *last_; } ///< once there is one
  /// Change of the force with the displacement, N/mm, from there to the nearest one with a force that differs
  /// by `telling`, N. Nothing where no such one was tried.
  std::optional<double> slope_at(double lateral, double telling) const {
    const auto there = std::ranges::find(known_, lateral, &Known::lateral);
    const Known* nearest = nullptr;
    for (const Known& k : known_)
      if (there != known_.end() && there->force && k.force && std::abs(*k.force - *there->force) >= telling &&
          (!nearest || std::abs(k.lateral - lateral) < std::abs(nearest->lateral - lateral)))
        nearest = &k;
    if (!nearest || std::abs(nearest->lateral - lateral) > largest_lateral_step)
      return std::nullopt;
    return (*nearest->force - *there->force) / (nearest->lateral - lateral);
  }
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
        wanted_(*scene.wheelset.force_y),
        curve_force_(scene.track.curve_radius ? curve_demand(scene).force : 0) {}

  /// Whether the start may bear the force.
  bool near() const {
    const double resultant = std::hypot(*finder_.scene().wheelset.force, wanted_);
    return std::abs(start_.force - wanted_) <= lateral::near * resultant;
  }
  std::optional<double> force(double lateral) { return follower_.force(lateral); }

  RoughPlace place() {
    LateralSample best;
    const std::optional<LateralRoot> guess =
        search_lateral([&](double y) { return follower_.force(y); }, start_, wanted_, near(), best);
    if (!guess)
      refuse_lateral({wanted_, start_.lateral, best, follower_.lifts(), finder_.scene().wheelset.roll_moment,
                      curve_force_});
    return {*guess, follower_.last().state.pose, follower_.near(guess->lateral)};
  }
  int contact_problems() const { return finder_.contact_problems(); }

private:
  EquilibriumFinder finder_;
  Follower follower_;
  LateralSample start_;
  double wanted_, curve_force_;
};

/// An equilibrium under wheelset.force_y.
struct AtLateralForce {
  Equilibrium equilibrium;
  std::optional<double>
      slope; ///< of the lateral force by the displacement there, N/mm, if the search tells it
};

/// How far the displacement is off where the forces are off by their stated errors, mm. Where these are not
/// known: by what larger elements change, and no less than forces are uneven by. Half-spaces tell the slope
/// where the search does not: bodies with structures stand elsewhere on the curve under the same force.
double error_of_lateral(RoughSearch& rough, const AtLateralForce& solved, double resultant) {
  const WheelsetState& found = solved.equilibrium.state;
  const Quantity& lateral = quantity("Fy");
  double error = std::hypot(lateral.error(found.right), lateral.error(found.left));
  const double at = found.pose.lateral;
  if (std::isnan(error))
    error = std::max(lateral::uneven * resultant,
                     std::abs(rough.force(at).value_or(found.sum().force[1]) - found.sum().force[1]));
  if (solved.slope)
    return std::min(error / std::abs(*solved.slope), double(lateral::reach));
  return lateral_spread([&](double y) { return rough.force(y); }, at, error, resultant).error;
}

/// Whether the lateral force is met.
bool meets(const SceneFile::Wheelset& given, const Equilibrium& e) {
  return std::abs(e.state.sum().force[1] - *given.force_y) <=
         lateral_balance * std::hypot(*given.force, *given.force_y);
}

/// Whether some wheel's elements are too large for the accuracy asked for, or to tell.
bool too_coarse(const SceneFile& scene, const WheelsetState& s) {
  const auto coarse = [&](const SceneResult& r) {
    const double error = asked_error(scene.grid, r.result);
    return error < 0 || error > *scene.grid.accuracy;
  };
  return scene.grid.accuracy && (coarse(s.right) || coarse(s.left));
}

AtLateralForce at_lateral_force(EquilibriumFinder& finder, const EquilibriumStart& start,
                                const LateralRoot& guess) {
  const SceneFile::Wheelset& given = finder.scene().wheelset;
  const double resultant = std::hypot(*given.force, *given.force_y);
  Follower follower(finder, guess.lateral, start, equilibrium_tolerance / 10);
  const LateralForce force = [&](double y) { return follower.force(y); };
  const double lateral = solve_lateral_force(force, *given.force_y, guess, lateral_balance * resultant);
  if (follower.last().state.pose.lateral != lateral)
    follower.required_force(lateral);
  return {follower.last(), follower.slope_at(lateral, lateral::uneven * resultant)};
}

bool has_both_files(const SceneFile& scene, WheelSide side) {
  const SceneFile one = one_wheel(scene, side);
  return !one.rail.influence.empty() && !one.wheel.influence.empty();
}

/// Which wheel has which model, where influence files are given for one side alone; "" else.
std::string files_of_one_side(const SceneFile& scene, const WheelsetState& s) {
  const bool right = has_both_files(scene, WheelSide::right), left = has_both_files(scene, WheelSide::left);
  if (right == left || s.right.choice.model == s.left.choice.model)
    return "";
  return fmt::format(
      "influence files are given for the {} side alone: the right wheel is solved by {}, the left one by {} "
      "(left_rail.influence and left_wheel.influence are files of the left profiles)",
      right ? "right" : "left", name_of(s.right.choice.model), name_of(s.left.choice.model));
}

void add_warnings(const SceneFile& scene, WheelsetResult& out) {
  std::vector<PlacedWarning> all;
  for (const WheelSide side : both_sides)
    for (const std::string& warning : out.state.solved(side).warnings)
      all.push_back({fmt::format("{} wheel", name_of(side)), warning});
  out.warnings = once_each(all);
  warn_of_kilonewtons("wheelset.force", *scene.wheelset.force, 2, out.warnings);
  if (std::string models = files_of_one_side(scene, out.state); !models.empty())
    out.warnings.push_back(std::move(models));
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
/// where rough solutions meet it, or the start itself where that meets it. `rough`: null: no lateral force.
RoughPlace first_place(EquilibriumFinder& finder, RoughSearch* rough) {
  const double start = finder.scene().position.lateral;
  RoughPlace out{{start, 0}, {}, {}};
  if (!rough) {
    out.start = finder.begin(start);
    return out;
  }
  const SceneFile::Wheelset& given = finder.scene().wheelset;
  const auto start_meets = [&] {
    try {
      const Equilibrium there = finder.at(start, finder.begin(start), equilibrium_tolerance / 10);
      out = {{start, 0}, {}, there.start()};
      return meets(given, there);
    } catch (const InputError&) { // the search may lead to where there is one
    } catch (const ConvergenceError&) {
    }
    return false;
  };
  if (rough->near() && start_meets())
    return out;
  out = rough->place();
  const RoughPlace place = out;
  // On a flange rough forces miss much, but their displacements do not.
  if (!rough->near() && std::abs(place.guess.lateral - start) <= lateral::unsure && start_meets())
    return out;
  finder.choose_elements(place.pose);
  return place;
}

} // namespace

WheelsetResult solve_wheelset(const SceneFile& given, const std::atomic<bool>* stop,
                              std::shared_ptr<SequenceFiles> files) {
  require_wheelset(given);
  const SceneFile scene = with_curve_force(given);
  const Stopwatch clock;
  if (!files)
    files = shared_files();
  EquilibriumFinder finder(scene, stop, files);
  std::optional<RoughSearch> rough;
  if (scene.wheelset.force_y)
    rough.emplace(scene, stop, files);
  RoughPlace place = first_place(finder, rough ? &*rough : nullptr);
  std::optional<AtLateralForce> solved;
  for (int round = 1;; ++round) {
    solved = rough ? at_lateral_force(finder, place.start, place.guess)
                   : AtLateralForce{finder.at(place.guess.lateral, place.start, equilibrium_tolerance), {}};
    const Equilibrium& found = solved->equilibrium;
    if (round == most_element_rounds || !too_coarse(scene, found.state))
      break;
    finder.choose_elements_again(found.state.pose);
    place.start = found.start();
    place.guess.lateral = found.state.pose.lateral;
  }
  const Equilibrium& found = solved->equilibrium;
  WheelsetResult out{.state = found.state, .residual = found.residual, .curve = curve_demand(scene)};
  if (rough) {
    const double wanted = *scene.wheelset.force_y, force = *scene.wheelset.force;
    out.lateral_residual = std::abs(out.state.sum().force[1] - wanted) / force;
    out.lateral_error = error_of_lateral(*rough, *solved, std::hypot(force, wanted));
  }
  out.contact_problems = finder.contact_problems() + (rough ? rough->contact_problems() : 0);
  add_warnings(scene, out);
  out.seconds = clock.seconds();
  return out;
}

} // namespace bem_contact
