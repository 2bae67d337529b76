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
#include "bem_contact/uses/wheelset/lateral_walk.hpp"
#include "bem_contact/uses/wheelset/settings.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <utility>

namespace bem_contact {

namespace {

/// 1. Elements of the rough half-space solutions are so many times as long and wide.
constexpr double rough_elements = 2.0;
/// 1. Residuals of rough solutions: on the tread the lateral force changes by some 1e-3 of the vertical one
/// in rough_lateral_width.
constexpr double rough_tolerance = 1e-5;
/// 1. Most rounds in which elements are chosen again for the accuracy asked for.
constexpr int most_element_rounds = 3;

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
    if (last_ && last_->state.pose.lateral == lateral)
      return last_->state.sum().force[1];
    last_ = finder_.at(lateral, near(lateral), tolerance_);
    const double force = last_->state.sum().force[1];
    add(lateral, last_->start(), force);
    return force;
  }
  /// An equilibrium that somebody else has found.
  void add(double lateral, const EquilibriumStart& start, double force) {
    known_.push_back({lateral, start, force});
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
  if (follower.force(guess.lateral) && !meets(given, follower.last()))
    if (std::optional<Equilibrium> found =
            finder.under_lateral_force(follower.last().state, equilibrium_tolerance)) {
      const double lateral = found->state.pose.lateral, lateral_force = found->state.sum().force[1];
      follower.add(lateral, found->start(), lateral_force);
      return {std::move(*found), follower.slope_at(lateral, lateral::uneven * resultant)};
    }
  const LateralForce force = [&](double y) { return follower.force(y); };
  const double lateral = solve_lateral_force(force, *given.force_y, guess, lateral_balance * resultant);
  if (follower.last().state.pose.lateral != lateral)
    follower.required_force(lateral);
  return {follower.last(), follower.slope_at(lateral, lateral::uneven * resultant)};
}

bool has_both_files(const SceneFile& scene, WheelSide side) {
  const SceneFile one = one_wheel(scene, side);
  return one.rail.has_influence() && one.wheel.has_influence();
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
    for (const Warning& warning : out.state.solved(side).warnings)
      all.push_back({fmt::format("{} wheel", name_of(side)), warning});
  out.warnings = once_each(all);
  warn_of_kilonewtons("wheelset.force", *scene.wheelset.force, 2, out.warnings);
  if (std::string models = files_of_one_side(scene, out.state); !models.empty())
    out.warnings.add(WarningKind::files_of_one_side, std::move(models));
  if (too_coarse(scene, out.state))
    out.warnings.add(WarningKind::missed_accuracy,
                     "the accuracy asked for was not reached: the equilibrium is found on the elements that "
                     "were chosen near it");
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
