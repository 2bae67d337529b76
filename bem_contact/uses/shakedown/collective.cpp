#include "bem_contact/uses/shakedown/collective.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/base/parallel.hpp"
#include "bem_contact/base/place_in_table.hpp"
#include "bem_contact/scene/sweep_file.hpp"
#include "bem_contact/sequence/load_collective.hpp"
#include "bem_contact/sequence/sequence.hpp"
#include "bem_contact/uses/shakedown/fatigue_limits.hpp"
#include "bem_contact/uses/shakedown/patch_columns.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace bem_contact::shakedown {

namespace {

/// 1. Points of the envelope along s at most, and its depths.
constexpr std::size_t most_along = 200, depth_count = 40;
/// 1. Depths of the envelope go as this power: denser near the surface.
constexpr double depth_power = 1.5;

/// A map of a section between its points; 0 beside it.
double value_at(const inside::Section& section, const std::vector<double>& map, double s, double depth) {
  if (s < section.s.front() || s > section.s.back() || depth > section.depths.back())
    return 0;
  const PlaceInTable across(section.s, s), down(section.depths, depth);
  const double u = across.share, v = down.share;
  const auto at = [&](std::size_t i, std::size_t j) {
    return map[section.point(across.line + i, down.line + j)];
  };
  return (1 - u) * ((1 - v) * at(0, 0) + v * at(0, 1)) + u * ((1 - v) * at(1, 0) + v * at(1, 1));
}

struct Case {
  Shakedown found;
  double weight = 1;
};

Envelope envelope_of(const std::vector<Case>& cases, const ShakedownProperties& properties) {
  double first = std::numeric_limits<double>::max(), last = -first, deepest = 0, step = first, weights = 0;
  for (const Case& one : cases) {
    weights += one.weight;
    for (const PatchShakedown& p : one.found.patches) {
      first = std::min(first, p.section.s.front());
      last = std::max(last, p.section.s.back());
      deepest = std::max(deepest, p.section.depths.back());
      for (std::size_t i = 1; i < p.section.s.size(); ++i)
        step = std::min(step, p.section.s[i] - p.section.s[i - 1]);
    }
  }
  Envelope out;
  if (!(first < last))
    return out;
  const std::size_t along =
      std::clamp<std::size_t>(static_cast<std::size_t>((last - first) / step) + 1, 2, most_along);
  for (std::size_t i = 0; i < along; ++i)
    out.s.push_back(std::lerp(first, last, double(i) / double(along - 1)));
  for (std::size_t i = 0; i < depth_count; ++i)
    out.depths.push_back(deepest * std::pow(double(i) / (depth_count - 1), depth_power));
  const double limit = properties.fatigue_limit.value_or(std::numeric_limits<double>::quiet_NaN());
  for (const double s : out.s)
    for (const double depth : out.depths) {
      double largest = 0, damage = std::isnan(limit) ? limit : 0;
      for (const Case& one : cases) {
        double here = 0;
        for (const PatchShakedown& p : one.found.patches)
          here = std::max(here, value_at(p.section, p.maps.dang_van, s, depth));
        largest = std::max(largest, here);
        damage += one.weight / weights / cycles_of(here, limit);
      }
      out.dang_van.push_back(largest);
      out.damage.push_back(damage);
      if (largest > out.worst_dang_van.value)
        out.worst_dang_van = {largest, s, depth};
      if (damage > out.worst_damage.value)
        out.worst_damage = {damage, s, depth};
    }
  if (std::isnan(limit))
    out.worst_damage.value = limit;
  return out;
}

} // namespace

std::size_t CollectiveShakedown::count(Yielding yielding) const {
  return static_cast<std::size_t>(std::ranges::count(patches, yielding, &CollectivePatch::yielding));
}

CollectiveShakedown shakedown_of(const SweepFile& sweep, const ShakedownProperties& properties,
                                 const ShakedownOfCases& of_cases, int at_once,
                                 const std::atomic<bool>* stop) {
  validate(properties);
  if (sweep.first_scene().wheelset.force)
    throw InputError(
        "There is no shakedown of a wheelset", "each of its wheels has its own",
        "Let bem_contact study put one wheel in its place, or give load.force instead of [wheelset].");
  CollectiveShakedown out;
  out.cases = sweep.size();
  std::vector<Case> cases;
  Sequence sequence({.displacements = false});
  for (std::size_t from = 0; from < sweep.size(); from += static_cast<std::size_t>(at_once)) {
    const std::size_t end = std::min(from + static_cast<std::size_t>(at_once), sweep.size());
    std::vector<SceneResult> results;
    for (std::size_t i = from; i < end; ++i)
      results.push_back(solve_of_collective(sequence, sweep, i, stop));
    for (Shakedown& found : of_cases(results))
      cases.push_back({std::move(found), sweep.weight(cases.size())});
  }
  out.envelope = envelope_of(cases, properties);
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const double along = place_of_case(sweep, i);
    std::size_t number = 0;
    for (PatchShakedown& patch : cases[i].found.patches) {
      patch.maps = {};
      patch.section = {};
      out.patches.push_back({std::move(patch), i, ++number, cases[i].weight, along});
    }
    out.too_small += cases[i].found.too_small;
  }
  return out;
}

CollectiveShakedown shakedown_of(const SweepFile& sweep, const ShakedownProperties& properties, int threads,
                                 const std::atomic<bool>* stop) {
  const auto of_halfspaces = [&](std::span<const SceneResult> results) {
    std::vector<Shakedown> out(results.size());
    in_parts(threads, static_cast<int>(results.size()), [&](int first, int end, int) {
      for (auto i = static_cast<std::size_t>(first); i < static_cast<std::size_t>(end); ++i)
        out[i] = shakedown_of(results[i], properties);
    });
    return out;
  };
  return shakedown_of(sweep, properties, of_halfspaces, std::max(1, threads), stop);
}

std::string in_words(const CollectiveShakedown& found, const ShakedownProperties& properties) {
  if (found.patches.empty())
    return "no contact that is large enough to tell";
  const CollectivePatch& worst =
      *std::ranges::min_element(found.patches, {}, [](const CollectivePatch& p) { return p.lower.value; });
  std::string out =
      fmt::format("of {} patches {} yield never, {} once, {} for ever", found.patches.size(),
                  found.count(Yielding::never), found.count(Yielding::once), found.count(Yielding::for_ever));
  if (const std::size_t open = found.count(Yielding::open))
    out += fmt::format(", {} once or for ever", open);
  out += fmt::format(
      " (least shakedown factor {:.2f} to {:.2f}, case {}); largest Dang Van stress {:.0f} MPa {:.2f} mm "
      "below s = {:.2f} mm",
      worst.lower.value, worst.upper.value, worst.index, found.envelope.worst_dang_van.value,
      found.envelope.worst_dang_van.depth, found.envelope.worst_dang_van.s);
  if (properties.fatigue_limit)
    out += fmt::format(", {:.0f} % of the fatigue limit; damage of one passage {:.3g}",
                       100 * found.envelope.worst_dang_van.value / *properties.fatigue_limit,
                       found.envelope.worst_damage.value);
  return out;
}

std::span<const ColumnOf<CollectivePatch>> collective_columns() {
  using P = CollectivePatch;
  static const std::vector<ColumnOf<P>> columns = [] {
    std::vector<ColumnOf<P>> all = columns_of_case<P>();
    all.insert(all.end(), columns_of_patch<P>().begin(), columns_of_patch<P>().end());
    return all;
  }();
  return columns;
}

record::Record record_of(const CollectiveShakedown& found, const ShakedownProperties& properties) {
  using record::field;
  using record::Number;
  const Envelope& e = found.envelope;
  const std::vector<std::size_t> shape{e.s.size(), e.depths.size()};
  record::Record out = properties_record(properties);
  out.add("in_words", record::Text{in_words(found, properties)})
      .add("cases", Number{double(found.cases), "1", "of the collective", {}, true})
      .add("too_small",
           Number{double(found.too_small), "1", "patches with too few elements to tell", {}, true});
  for (const auto& [yielding, name] : {std::pair{Yielding::never, "yield_never"},
                                       {Yielding::once, "yield_once"},
                                       {Yielding::for_ever, "yield_for_ever"},
                                       {Yielding::open, "yield_once_or_for_ever"}})
    out.add(name, Number{double(found.count(yielding)), "1", "patches of all cases that do so", {}, true});
  const auto least = [&](const char* name, const char* meaning, AtPoint PatchShakedown::*which) {
    double value = std::numeric_limits<double>::quiet_NaN();
    for (const CollectivePatch& p : found.patches)
      value = std::isnan(value) ? (p.*which).value : std::min(value, (p.*which).value);
    out.add(name, Number{value, "1", meaning});
  };
  least("first_yield", "load factor up to which nothing yields, worst patch", &PatchShakedown::first_yield);
  least("shakedown", "load factor up to which it shakes down, worst patch", &PatchShakedown::lower);
  least("shakedown_upper", "load factor from which it does not, worst patch", &PatchShakedown::upper);
  const auto worst = [&](const std::string& name, const AtPoint& at, const char* unit, const char* meaning) {
    out.add(name, Number{at.value, unit, meaning})
        .add(name + "_s", Number{at.s, "mm", "where that is"})
        .add(name + "_depth", Number{at.depth, "mm", "how deep"});
  };
  worst("dang_van", e.worst_dang_van, "MPa", "largest shear stress of Dang Van of all cases");
  worst("damage", e.worst_damage, "1",
        "of one passage after Miner, mean over the collective; a crack begins at 1");
  out.add("patches",
          record::as_rows(record::table_of("patch of a case", collective_columns(), found.patches)));
  out.add("envelope",
          record::Record{
              {"s", field(e.s, "mm", "of the points, arc length along the rail")},
              {"depth", field(e.depths, "mm", "of the points below the surface")},
              {"dang_van", field(e.dang_van, "MPa", "largest shear stress of Dang Van of all cases", shape)},
              {"damage", field(e.damage, "1", "of one passage, mean over the collective", shape)}});
  return out;
}

} // namespace bem_contact::shakedown
