#include "bem_contact/uses/fatigue/fatigue_of_result.hpp"

#include "bem_contact/base/counted.hpp"
#include "bem_contact/base/error.hpp"
#include "bem_contact/scene/sweep_file.hpp"
#include "bem_contact/sequence/load_collective.hpp"
#include "bem_contact/sequence/sequence.hpp"
#include "bem_contact/sequence/uncertified.hpp"
#include "bem_contact/uses/fatigue/settings.hpp"
#include "bem_contact/uses/fatigue/shakedown.hpp"
#include "bem_contact/uses/shakedown/shakedown_in_body.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <span>
#include <utility>
#include <vector>

namespace bem_contact::fatigue {

namespace {

void require_positive(double value, const char* name) {
  if (!(std::isfinite(value) && value > 0))
    throw InputError(fmt::format("{} cannot be {}", name, value), "it must be a positive number",
                     "Correct it.");
}

} // namespace

void require_yield_shear(double yield_shear) {
  require_positive(yield_shear, "The yield stress in shear");
}

double surface_index(const ShakedownPoint& point) {
  require_positive(point.load, "p0/k");
  return point.traction - 1 / point.load;
}

double element_index(double shear_traction, double pressure, double yield_shear) {
  return std::max(least_element_index, (shear_traction - yield_shear) / pressure);
}

double damage_of(const DamageFunction& f, double t_gamma) {
  const std::vector<double>& nodes = f.t_gamma;
  if (t_gamma < nodes.front() || (t_gamma > nodes.back() && !f.wear_is_negative))
    return 0;
  const auto above = std::ranges::upper_bound(nodes, t_gamma) - nodes.begin();
  const std::size_t right = std::min<std::size_t>(above, nodes.size() - 1), left = right - 1;
  const double share = (t_gamma - nodes[left]) / (nodes[right] - nodes[left]);
  return std::lerp(f.damage[left], f.damage[right], share);
}

void validate(const DamageFunction& f) {
  const auto finite = [](double value) { return std::isfinite(value); };
  const auto refuse = [](const std::string& why) {
    throw InputError("The damage function cannot have these nodes", why,
                     "Give rising values of T-gamma, and one damage for each.");
  };
  if (f.t_gamma.size() < 2 || f.t_gamma.size() != f.damage.size())
    refuse(fmt::format("it has {} of T-gamma and {} of damage", counted(f.t_gamma.size(), "value", "values"),
                       f.damage.size()));
  if (!std::ranges::all_of(f.t_gamma, finite) || !std::ranges::all_of(f.damage, finite) ||
      f.t_gamma.front() < 0 ||
      std::ranges::adjacent_find(f.t_gamma, std::greater_equal<>()) != f.t_gamma.end())
    refuse("T-gamma must be finite, not negative, and rise");
}

namespace {

/// `largest_index`: of the elements of the patch.
PatchFatigue fatigue_of_patch(const PatchSummary& patch, double largest_index, bool power,
                              const FatigueProperties& properties) {
  PatchFatigue out;
  out.s = patch.s;
  out.y = patch.position.y;
  out.normal_force = patch.fn;
  out.pmax = patch.pmax;
  out.point = {patch.pmax / properties.yield_shear, std::hypot(patch.fx, patch.fs) / patch.fn};
  out.limit_below = limit_below(out.point.traction);
  out.surface_index = surface_index(out.point);
  out.largest_index = largest_index;
  out.t_gamma = power ? patch.T_gamma : 0.0;
  out.damage = damage_of(properties.damage, out.t_gamma);
  return out;
}

std::vector<double> index_of_elements(const ContactResult& r, double yield_shear) {
  std::vector<double> out(r.pn.size(), least_element_index);
  for (std::size_t i = 0; i < out.size(); ++i)
    if (r.pn[i] > 0)
      out[i] = element_index(std::hypot(r.px[i], r.ps[i]), r.pn[i], yield_shear);
  return out;
}

} // namespace

namespace {

/// Without the body's part.
Fatigue of_surface(const SceneResult& solved, const FatigueProperties& properties) {
  const ContactResult& r = solved.result;
  require_certified(solved);
  const bool power = solved.problem.motion != MotionKind::shift; // it is work by area there
  Fatigue out;
  out.element_index = index_of_elements(r, properties.yield_shear);
  const std::vector<std::vector<int>> elements = patch_elements(solved.problem, r);
  for (std::size_t k = 0; k < r.patches.size(); ++k) {
    double largest = least_element_index;
    if (k < elements.size()) // a small Hertz contact may have none
      for (const int i : elements[k])
        largest = std::max(largest, out.element_index[i]);
    out.patches.push_back(fatigue_of_patch(r.patches[k], largest, power, properties));
  }
  return out;
}

bool is_worse(const shakedown::PatchShakedown& a, const std::optional<shakedown::PatchShakedown>& b) {
  return !b || a.lower.value < b->lower.value;
}

void add_body(const SceneResult& solved, const inside::StressesInside& stresses,
              const FatigueProperties& properties, Fatigue& out) {
  const ContactGrid& grid = solved.problem.grid;
  const double depth = least_depth * std::min(grid.dx, grid.ds);
  if (properties.stresses && !out.patches.empty()) {
    out.peaks = stress_peaks(stresses, false, depth);
    out.halfspace_peaks = stress_peaks(stresses, true, depth);
  }
  shakedown::Shakedown found = shakedown::shakedown_of(stresses, {.yield_shear = properties.yield_shear});
  const std::vector<std::size_t> told = shakedown::patches_told(solved);
  for (std::size_t i = 0; i < found.patches.size(); ++i) {
    shakedown::PatchShakedown& p = found.patches[i];
    PatchFatigue& patch = out.patches.at(told.at(i));
    patch.shakedown = p.lower.value;
    patch.shakedown_upper = p.upper.value;
    patch.limit_below = p.limit_pressure();
    p.maps = {};
    if (is_worse(p, out.worst))
      out.worst = std::move(p);
  }
}

/// Of each result, in their order.
std::vector<Fatigue> fatigue_of_all(std::span<const SceneResult> results, const FatigueProperties& properties,
                                    int threads) {
  std::vector<Fatigue> out;
  for (const SceneResult& solved : results)
    out.push_back(of_surface(solved, properties));
  if (!properties.body.empty())
    shakedown::for_each_in_body(results, properties.body, threads,
                                [&](std::size_t i, const inside::StressesInside& stresses) {
                                  add_body(results[i], stresses, properties, out[i]);
                                });
  else if (properties.stresses)
    for (std::size_t i = 0; i < out.size(); ++i)
      if (!out[i].patches.empty())
        out[i].peaks = stress_peaks(results[i].problem, results[i].result, results[i].bodies.rail_poisson);
  return out;
}

} // namespace

Fatigue fatigue_of(const SceneResult& solved, const FatigueProperties& properties) {
  require_yield_shear(properties.yield_shear);
  validate(properties.damage);
  return std::move(fatigue_of_all({&solved, 1}, properties, 1).front());
}

namespace {

void add_case(const SweepFile& sweep, std::size_t index, const Fatigue& f, CollectiveFatigue& out) {
  const double along = place_of_case(sweep, index), weight = sweep.weight(index);
  std::size_t number = 0;
  for (const PatchFatigue& patch : f.patches) {
    out.patches.push_back({patch, index, ++number, weight, along, f.peaks.value_or(StressPeaks{}),
                           f.halfspace_peaks.value_or(StressPeaks{})});
    out.beyond_surface += patch.beyond_surface();
    out.beyond_below += patch.beyond_below() && !patch.beyond_surface();
    out.damage += weight * patch.damage;
  }
  if (f.worst && is_worse(*f.worst, out.worst))
    out.worst = f.worst;
}

} // namespace

CollectiveFatigue fatigue_of(const SweepFile& sweep, const FatigueProperties& properties,
                             const std::atomic<bool>* stop, int threads) {
  require_yield_shear(properties.yield_shear);
  validate(properties.damage);
  if (sweep.first_scene().wheelset.force)
    throw InputError(
        "There is no fatigue of a wheelset",
        "[fatigue] is of the patches of one wheel, and [wheelset] is given",
        "Let bem_contact study put one wheel in its place, or give load.force instead of [wheelset].");
  CollectiveFatigue out;
  out.cases = sweep.size();
  const std::size_t at_once = properties.body.empty() ? 1 : shakedown::most_cases_in_body;
  Sequence sequence({.displacements = false});
  double weights = 0;
  for (std::size_t from = 0; from < sweep.size(); from += at_once) {
    std::vector<SceneResult> results;
    for (std::size_t i = from; i < std::min(from + at_once, sweep.size()); ++i)
      results.push_back(solve_of_collective(sequence, sweep, i, stop));
    const std::vector<Fatigue> found = fatigue_of_all(results, properties, threads);
    for (std::size_t i = 0; i < found.size(); ++i) {
      add_case(sweep, from + i, found[i], out);
      weights += sweep.weight(from + i);
    }
  }
  out.damage /= weights;
  return out;
}

} // namespace bem_contact::fatigue
