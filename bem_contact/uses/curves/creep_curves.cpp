#include "bem_contact/uses/curves/creep_curves.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/scene/derivative_inputs.hpp"
#include "bem_contact/sequence/models.hpp"
#include "bem_contact/sequence/plan/hertz_model.hpp"
#include "bem_contact/sequence/quantities.hpp"
#include "bem_contact/sequence/shared_files.hpp"
#include "bem_contact/uses/curves/creep_derivatives.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>
#include <utility>

namespace bem_contact {

namespace {

/// 1. A curve whose range is not given reaches so many times the creepage at which linear theory reaches the
/// friction bound: at three times of it a Hertz contact slips everywhere (Vermeulen and Johnson 1964).
constexpr double automatic_reach = 3.0;
/// 1. Points of such a curve: four on each rising part.
constexpr int automatic_points = 25;
/// 1. More points of all curves are refused: at 0.1 s each they take 20 minutes.
constexpr std::size_t most_curve_points = 10000;
/// 1, of the same creepage. Step of the differences that give slopes at zero creepage. Forces are known to
/// 1e-8 of the bound, so that a slope has 5 digits; slip at the trailing edge takes 1e-3 of it off, and the
/// extrapolation from two steps takes that out.
constexpr double slope_step = 3e-3;
/// 1, of the same creepage. Step of the differences that give sensitivities at a solution. With smaller ones
/// the change of state of single elements shows.
constexpr double sensitivity_step = 0.04;
/// 1. Kalker's coefficients in place of unknown ones, for the steps and ranges of a contact that is no
/// ellipse: 4 is that of a circle.
constexpr double usual_coefficient = 4.0;
/// 1. Longest ratio of the semi-axes at which linear theory is compared: its table ends there.
constexpr double longest_ellipse = 10.0;

} // namespace

double LinearTheory::c() const {
  return std::sqrt(semi_axis_x * semi_axis_s);
}

std::optional<LinearTheory> linear_theory(const SceneResult& result, const Material& rail,
                                          const Material& wheel) {
  if (result.result.patches.size() != 1)
    return std::nullopt;
  const std::optional<HertzModel> hertz = fit_hertz(result.problem, rail, wheel);
  if (!hertz || !(hertz->contact.force > 0))
    return std::nullopt;
  LinearTheory out;
  out.semi_axis_x = hertz->contact.semi_axis_x;
  out.semi_axis_s = hertz->contact.semi_axis_s;
  // Its own x axis may lie nearer to s.
  const double quarter = 0.5 * std::numbers::pi, turns = std::round(hertz->angle / quarter);
  if (std::fmod(std::abs(turns), 2) == 1)
    std::swap(out.semi_axis_x, out.semi_axis_s);
  out.tilt = hertz->angle - turns * quarter;
  out.deviation = hertz->deviation;
  const double ratio = out.semi_axis_x / out.semi_axis_s;
  if (!(ratio < longest_ellipse && ratio > 1 / longest_ellipse))
    return std::nullopt;
  // Equal bodies with the same sums of compliances (Kalker 1990, section 1.4).
  out.shear_modulus = shear_modulus_of_pair(rail, wheel);
  out.poisson =
      0.5 * out.shear_modulus * (rail.poisson / rail.shear_modulus + wheel.poisson / wheel.shear_modulus);
  out.coefficients = reference::creep_coefficients(ratio, out.poisson);
  const double c = out.c(), cc = c * c * out.shear_modulus;
  const reference::CreepCoefficients& k = out.coefficients;
  out.slopes = {
      {{cc * k.c11, 0, 0}, {0, cc * k.c22, cc * c * k.c23}, {0, -cc * c * k.c23, cc * c * c * k.c33}}};
  return out;
}

void require_creepages(const SceneFile& scene, std::span<const CreepRange> ranges) {
  refuse_derivatives(scene, "a creep curve");
  const auto refuse = [](const char* why, const char* what_to_do) {
    throw InputError("This scene has no creep curves", why, what_to_do);
  };
  if (scene.motion.kind != MotionKind::steady)
    refuse("its motion is no steady rolling", "Set motion.kind = \"steady\".");
  if (scene.motion.frictionless)
    refuse("it has no friction", "Set motion.friction.");
  if (scene.load.force_x || scene.load.force_s)
    refuse("it prescribes a shear force, so that a creepage is found and not given",
           "Leave out load.force_x and load.force_s.");
  if (!scene.motion.slip_table.empty())
    refuse("its slip comes from a table", "Leave out motion.slip_table.");
  std::size_t points = 0;
  for (const CreepRange& range : ranges) {
    points += range.values.empty() ? automatic_points : range.values.size();
    for (const double value : range.values)
      if (!std::isfinite(value))
        throw InputError(fmt::format("The range of {} cannot be used", name_of(range.which)),
                         "one of its values is not a number", "Give finite values.");
  }
  if (points > most_curve_points)
    throw InputError(fmt::format("{} points of creep curves are too many", points),
                     fmt::format("{} are allowed", most_curve_points),
                     "Give fewer, or use bem_contact sweep.");
}

HeldContact held_by(const SceneFile& scene, const SceneResult& first) {
  HeldContact out{.model = first.choice.model,
                  .dx = first.problem.grid.dx,
                  .ds = first.problem.grid.ds,
                  .lateral = {},
                  .layer_compliance = {}};
  if (scene.load.force_y)
    out.lateral = first.motion.lateral.value_or(scene.position.lateral);
  if (scene.layer.slope && !first.layer.shear.empty())
    out.layer_compliance = first.layer.shear.front();
  if (scene.motion.from_free_rolling)
    out.offset = first.motion.xi - scene.motion.xi;
  return out;
}

namespace {

SceneFile held_scene(const SceneFile& given, const HeldContact& held) {
  SceneFile scene = with_elements(with_model(given, held.model), held.dx, held.ds);
  scene.stresses.depths.clear();
  scene.motion.free_rolling = scene.motion.from_free_rolling = false;
  if (held.lateral)
    scene = with_lateral(scene, *held.lateral);
  if (held.layer_compliance) {
    scene.layer.slope.reset();
    scene.layer.compliance = held.layer_compliance;
  }
  return scene;
}

SceneFile scene_at(const SceneFile& held_scene, double offset, const Creepages& creepages) {
  SceneFile scene = held_scene;
  scene.motion.xi = creepages[0] + offset;
  scene.motion.eta = creepages[1];
  scene.motion.phi = creepages[2];
  return scene;
}

/// Of the forces by each number that the scene names; none where the solution bends.
std::vector<CreepForceValues> slopes_of(const SceneFile& scene, const SceneResult& r) {
  std::vector<CreepForceValues> out;
  for (const std::string& name : scene.derivatives) {
    const InputDerivatives& by = *std::ranges::find(r.derivatives, name, &InputDerivatives::name);
    if (!(by.below > 0 && by.above > 0))
      return {};
    CreepForceValues& one = out.emplace_back();
    for (std::size_t i = 0; i < one.size(); ++i)
      one[i] = by.totals[std::size_t(std::ranges::find(derived_totals(), EnumNames<CreepForce>::names[i]) -
                                     derived_totals().begin())];
  }
  return out;
}

/// Creepages at which linear theory reaches the friction bound: of Fx, Fs, and Fs again for spin.
Creepages saturation(const CreepCurves& c, const SceneFile& scene) {
  const double modulus = shear_modulus_of_pair(scene.rail.material, scene.wheel.material);
  const double usual = usual_coefficient * modulus * c.radius * c.radius;
  const CreepMatrix slopes =
      c.linear ? c.linear->slopes : CreepMatrix{{{usual, 0, 0}, {0, usual, 0.4 * usual * c.radius}, {}}};
  return {c.bound / slopes[0][0], c.bound / slopes[1][1], c.bound / slopes[1][2]};
}

/// The values of a curve; `middle`: of those that are chosen here.
std::vector<double> values_of(const CreepRange& range, double middle, const Creepages& scale) {
  std::vector<double> values = range.values;
  for (int i = 0; range.values.empty() && i < automatic_points; ++i)
    values.push_back(middle +
                     automatic_reach * scale[index(range.which)] * (2.0 * i / (automatic_points - 1) - 1));
  return values;
}

/// The scene's creepages less those of the rigid slip: nothing moves over the other.
Creepages at_rest(const Creepages& asked, const SceneResult& solution) {
  const Creepages rigid = rigid_creepages(solution);
  Creepages out{};
  for (const CreepKind kind : creep_kinds)
    out[index(kind)] = asked[index(kind)] - rigid[index(kind)];
  out[0] -= solution.result.totals.creepage_x;
  return out;
}

/// Free rolling, as motion.xi counts it; 0 for a patch.
double free_xi(const SceneResult& first, const HeldContact& held) {
  return held.offset != 0 || !first.motion.free_rolling ? 0 : first.motion.free_rolling->xi.value;
}

} // namespace

bool certified(const CreepCurves& all) {
  return certified(all.solution) && std::ranges::all_of(all.curves, [](const CreepCurve& curve) {
           return std::ranges::all_of(curve.points, &CreepPoint::certified);
         });
}

SceneResult solve_held(const SceneFile& scene, const HeldContact& held, const std::atomic<bool>* stop) {
  const Creepages own{scene.motion.xi, scene.motion.eta, scene.motion.phi};
  return Sequence({.displacements = false}, shared_files())
      .solve(scene_at(held_scene(scene, held), held.offset, own), stop);
}

std::vector<CreepPoint> creep_points(Sequence& sequence, const SceneFile& given, const HeldContact& held,
                                     std::span<const Creepages> points, const std::atomic<bool>* stop) {
  const SceneFile scene = held_scene(given, held);
  std::vector<CreepPoint> out;
  for (const Creepages& at : points) {
    const SceneResult r = sequence.solve(scene_at(scene, held.offset, at), stop);
    out.push_back({0, forces_of(r), coarse_forces_of(r), r.result.totals.adhesion_share, certified(r), {}});
    if (!r.derivatives.empty())
      out.back().slopes = slopes_of(scene, r);
  }
  return out;
}

std::vector<CreepPoint> creep_points(const SceneFile& scene, const HeldContact& held,
                                     std::span<const Creepages> points, const std::atomic<bool>* stop) {
  Sequence sequence({.displacements = false}, shared_files());
  return creep_points(sequence, scene, held, points, stop);
}

CreepCurves creep_curves(const SceneFile& scene, std::span<const CreepRange> ranges,
                         const std::atomic<bool>* stop, const CreepSolver& solve) {
  require_creepages(scene, ranges);
  const auto files = std::make_shared<SequenceFiles>();
  Sequence sequence({.displacements = false}, files), on_larger({.displacements = false}, files);
  CreepCurves out;
  out.solution = sequence.solve(scene, stop);
  out.bound = friction_bound(out.solution.problem, out.solution.result);
  if (!(out.bound > 0))
    throw InputError("This scene has no creep curves", "its bodies do not touch, or their friction is zero",
                     "Press them together, and set motion.friction.");
  out.linear = linear_theory(out.solution, scene.rail.material, scene.wheel.material);
  out.radius = out.linear ? out.linear->c() : std::sqrt(out.solution.result.totals.area / std::numbers::pi);
  const HeldContact held = held_by(scene, out.solution);
  const Creepages scale = saturation(out, scene), asked{scene.motion.xi, scene.motion.eta, scene.motion.phi};
  const auto part = [&](double share) {
    return Creepages{share * scale[0], share * scale[1], share * scale[2]};
  };
  const CreepSolvers solvers{
      [&](const HeldContact& contact, std::span<const Creepages> some) {
        if (!solve)
          return creep_points(sequence, scene, contact, some, stop);
        out.contact_problems += int(some.size());
        return solve(contact, some);
      },
      [&](const SceneFile& named, const HeldContact& contact, const Creepages& at) {
        return creep_points(contact == held ? sequence : on_larger, named, contact, {&at, 1}, stop).front();
      }};
  const DerivedContact contact{scene, held, count_elements(out.solution.result).contact};
  out.sensitivities = creep_derivatives(contact, {asked, part(sensitivity_step), 2}, solvers);
  out.slopes = creep_derivatives(contact, {at_rest(asked, out.solution), part(slope_step), 1}, solvers);
  std::vector<Creepages> points;
  for (const CreepRange& range : ranges)
    for (const double value : values_of(range, free_xi(out.solution, held), scale)) {
      points.push_back(asked);
      points.back()[index(range.which)] = value;
    }
  const std::vector<CreepPoint> solved = solvers.points(held, points);
  for (std::size_t first = 0; const CreepRange& range : ranges) {
    CreepCurve& curve = out.curves.emplace_back(CreepCurve{range.which, {}});
    for (const double value : values_of(range, free_xi(out.solution, held), scale)) {
      curve.points.push_back(solved[first++]);
      curve.points.back().creepage = value;
    }
  }
  out.contact_problems += sequence.counts().solves + on_larger.counts().solves;
  return out;
}

} // namespace bem_contact
