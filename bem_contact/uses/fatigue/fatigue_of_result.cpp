#include "bem_contact/uses/fatigue/fatigue_of_result.hpp"

#include "bem_contact/base/counted.hpp"
#include "bem_contact/base/error.hpp"
#include "bem_contact/scene/sweep_file.hpp"
#include "bem_contact/sequence/load_collective.hpp"
#include "bem_contact/sequence/sequence.hpp"
#include "bem_contact/sequence/uncertified.hpp"
#include "bem_contact/uses/fatigue/shakedown.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
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

Fatigue fatigue_of(const SceneResult& solved, const FatigueProperties& properties) {
  require_yield_shear(properties.yield_shear);
  validate(properties.damage);
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
  if (properties.stresses && !out.patches.empty())
    out.peaks = stress_peaks(solved.problem, r, solved.bodies.rail_poisson);
  return out;
}

namespace {

/// Of PatchFatigue and of what is derived from it.
template <class P>
constexpr std::array<ColumnOf<P>, 11> columns_of{
    {{"s", "mm", "centre of pressure, arc length along the rail", [](const P& p) { return p.s; }},
     {"y", "mm", "centre of pressure, track frame", [](const P& p) { return p.y; }},
     {"Fn", "N", "sum of the pressure", [](const P& p) { return p.normal_force; }},
     {"pmax", "MPa", "largest pressure", [](const P& p) { return p.pmax; }},
     {"p0_over_k", "1", "largest pressure over the yield stress in shear",
      [](const P& p) { return p.point.load; }},
     {"mu_used", "1", "shear force over normal force", [](const P& p) { return p.point.traction; }},
     {"FI_surf", "1", "mu used less k/p0: above 0 the surface fatigues",
      [](const P& p) { return p.surface_index; }},
     {"FI_worst_element", "1", "the same of the worst element", [](const P& p) { return p.largest_index; }},
     {"p0_over_k_limit", "1", "shakedown limit below the surface with this mu used, of a long contact",
      [](const P& p) { return p.limit_below; }},
     {"T_gamma", "N", "dissipated by friction by rolled distance", [](const P& p) { return p.t_gamma; }},
     {"damage", "1", "of one passage", [](const P& p) { return p.damage; }}}};

} // namespace

std::span<const ColumnOf<PatchFatigue>> patch_columns() {
  return columns_of<PatchFatigue>;
}

CollectiveFatigue fatigue_of(const SweepFile& sweep, const FatigueProperties& properties,
                             const std::atomic<bool>* stop) {
  require_yield_shear(properties.yield_shear);
  validate(properties.damage);
  if (sweep.first_scene().wheelset.force)
    throw InputError(
        "There is no fatigue of a wheelset",
        "[fatigue] is of the patches of one wheel, and [wheelset] is given",
        "Let bem_contact study put one wheel in its place, or give load.force instead of [wheelset].");
  CollectiveFatigue out;
  out.cases = sweep.size();
  Sequence sequence({.displacements = false});
  double weights = 0;
  for (std::size_t i = 0; i < sweep.size(); ++i) {
    const SceneResult result = solve_of_collective(sequence, sweep, i, stop);
    const Fatigue f = fatigue_of(result, properties);
    const double along = place_of_case(sweep, i);
    std::size_t number = 0;
    for (const PatchFatigue& patch : f.patches) {
      out.patches.push_back({patch, i, ++number, sweep.weight(i), along, f.peaks.value_or(StressPeaks{})});
      out.beyond_surface += patch.beyond_surface();
      out.beyond_below += patch.beyond_below() && !patch.beyond_surface();
      out.damage += sweep.weight(i) * patch.damage;
    }
    weights += sweep.weight(i);
  }
  out.damage /= weights;
  return out;
}

std::span<const ColumnOf<CollectivePatch>> collective_columns() {
  using P = CollectivePatch;
  static const std::vector<ColumnOf<P>> columns = [] {
    std::vector<ColumnOf<P>> all = columns_of_case<P>();
    all.insert(all.end(), columns_of<P>.begin(), columns_of<P>.end());
    all.insert(
        all.end(),
        {{"von_mises", "MPa", "largest below the surface of the case",
          [](const P& p) { return p.peaks.von_mises.stress; }},
         {"von_mises_depth", "mm", "where that is", [](const P& p) { return p.peaks.von_mises.depth; }},
         {"tresca", "MPa", "largest shear stress below the surface of the case",
          [](const P& p) { return p.peaks.tresca.stress; }},
         {"tresca_depth", "mm", "where that is", [](const P& p) { return p.peaks.tresca.depth; }}});
    return all;
  }();
  return columns;
}

record::Record record_of(const Fatigue& f, const ContactGrid& grid) {
  using record::Number;
  const auto peak = [](const StressPeak& p, const char* meaning) {
    return record::Record{{"stress", Number{p.stress, "MPa", meaning}},
                          {"x", Number{p.x, "mm", "where that is, rolling direction"}},
                          {"s", Number{p.s, "mm", "where that is, arc length along the rail"}},
                          {"depth", Number{p.depth, "mm", "where that is, below the surface"}}};
  };
  record::Record out{{"FI", record::Field{"1",
                                          "mu used less k/p0 of each element; -0.5 outside the contact",
                                          {std::size_t(grid.ms), std::size_t(grid.mx)},
                                          f.element_index}},
                     {"patches", record::as_rows(record::table_of("patch", patch_columns(), f.patches))}};
  if (f.peaks)
    out.add("von_mises", peak(f.peaks->von_mises, "largest below the surface"))
        .add("tresca", peak(f.peaks->tresca, "largest shear stress below the surface"));
  return out;
}

record::Record record_of(const CollectiveFatigue& f, const FatigueProperties& properties) {
  using record::Number;
  return {
      {"cases", Number{double(f.cases), "1", "of the collective", {}, true}},
      {"beyond_surface_limit",
       Number{double(f.beyond_surface), "1", "patches beyond the shakedown limit of the surface", {}, true}},
      {"beyond_limit_below", Number{double(f.beyond_below),
                                    "1",
                                    "other patches beyond the shakedown limit below the surface",
                                    {},
                                    true}},
      {"damage", Number{f.damage, "1", "of one passage, mean over the collective"}},
      {"yield_shear", Number{properties.yield_shear, "MPa", "k, the yield stress in shear"}},
      {"patches", record::as_rows(record::table_of("patch of a case", collective_columns(), f.patches))}};
}

} // namespace bem_contact::fatigue
