#include "bem_contact/record/record.hpp"
#include "bem_contact/uses/shakedown/patch_columns.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace bem_contact::shakedown {

std::string in_words(const PatchShakedown& p, const ShakedownProperties& properties) {
  const std::string head = fmt::format("yields {}", word_of(p.yielding));
  if (p.yielding == Yielding::never)
    return fmt::format(
        "{}: its tractions could be {:.2f} times as large before it does, first {:.2f} mm below s = "
        "{:.2f} mm (k = {:g} MPa)",
        head, p.first_yield.value, p.first_yield.depth, p.first_yield.s, properties.yield_shear);
  const AtPoint& place = p.yielding == Yielding::for_ever ? p.upper : p.lower;
  const std::string where = place.depth > 0
                                ? fmt::format("{:.2f} mm below s = {:.2f} mm", place.depth, place.s)
                                : fmt::format("at the surface, s = {:.2f} mm", place.s);
  return fmt::format("{} (shakedown factor {:.2f} to {:.2f}), {} (k = {:g} MPa)", head, p.lower.value,
                     p.upper.value, where, properties.yield_shear);
}

std::string fatigue_in_words(const PatchShakedown& p, const ShakedownProperties& properties) {
  if (!properties.fatigue_limit)
    return "compare with the fatigue limit in torsion";
  const std::string limit =
      properties.steel.empty()
          ? fmt::format("the fatigue limit in torsion, {:.0f} MPa", *properties.fatigue_limit)
          : fmt::format(
                "the fatigue limit in torsion of {}, {:.0f} MPa (estimated; it scatters by 10 to 20 %)",
                properties.steel, *properties.fatigue_limit);
  const std::string share = fmt::format("{:.1f} MPa with the surface, {:.0f} % of {}",
                                        p.fatigue_share() * p.fatigue_limit, 100 * p.fatigue_share(), limit);
  return p.damage() > 0 ? fmt::format("{}: a crack after some {:.2g} passages", share, 1 / p.damage())
                        : share;
}

std::span<const ColumnOf<PatchShakedown>> patch_columns() {
  return columns_of_patch<PatchShakedown>();
}

record::Record properties_record(const ShakedownProperties& properties) {
  using record::Number;
  return {
      {"yield_shear", Number{properties.yield_shear, "MPa", "k, the yield stress in shear"}},
      {"residual", record::Text{properties.residual == Residual::all ? "all" : "in-plane",
                                "which residual stresses may build up"}},
      {"dang_van_a", Number{properties.dang_van_a, "1", "weight of the hydrostatic stress after Dang Van"}},
      {"crossland_alpha", Number{properties.crossland(), "1", "the same after Crossland"}},
      {"steel", record::Text{properties.steel}},
      {"initial_stress", record::Text{properties.initial ? properties.initial->name() : "",
                                      "file of the stress that is there before any wheel"}},
      {"fatigue_limit", Number{properties.fatigue_limit.value_or(std::numeric_limits<double>::quiet_NaN()),
                               "MPa", "in torsion; nan: not given"}}};
}

namespace {

record::Record section_record(const PatchShakedown& p, const std::string& words) {
  const std::vector<std::size_t> shape{p.section.s.size(), p.section.depths.size()};
  const auto map = [&](const std::vector<double>& values, const char* unit, const char* meaning) {
    return record::field(values, unit, meaning, shape);
  };
  const auto residual = [&](double halfspace::Stress::*component, const char* meaning) {
    std::vector<double> values;
    for (const halfspace::Stress& t : p.maps.residual)
      values.push_back(t.*component);
    return record::field(std::move(values), "MPa", meaning, shape);
  };
  using halfspace::Stress;
  return {
      {"in_words", record::Text{words}},
      {"s", record::field(p.section.s, "mm", "of the points, arc length along the rail")},
      {"depth", record::field(p.section.depths, "mm", "of the points below the surface")},
      {"first_yield", map(p.maps.first_yield, "1", "load factor up to which the point stays elastic")},
      {"cycle", map(p.maps.cycle, "1", "load factor from which no residual stress keeps the point elastic")},
      {"dang_van", map(p.maps.dang_van, "MPa", "largest shear stress of Dang Van")},
      {"crossland", map(p.maps.crossland, "MPa", "largest stress of Crossland")},
      {"residual_xx", residual(&Stress::xx, "deviator of the residual stress at the lower bound, xx")},
      {"residual_ss", residual(&Stress::ss, "the same, ss")},
      {"residual_nn", residual(&Stress::nn, "the same, nn")},
      {"residual_xs", residual(&Stress::xs, "residual stress at the lower bound, xs")},
      {"residual_xn", residual(&Stress::xn, "the same, xn")},
      {"residual_sn", residual(&Stress::sn, "the same, sn")}};
}

} // namespace

record::Record record_of(const Shakedown& found, const ShakedownProperties& properties) {
  using record::Number;
  record::Record out = properties_record(properties);
  out.add("too_small",
          Number{double(found.too_small), "1", "patches with too few elements to tell", {}, true})
      .add("patches", record::as_rows(record::table_of("patch", patch_columns(), found.patches)));
  if (!found.patches.empty()) {
    const PatchShakedown& worst =
        *std::ranges::min_element(found.patches, {}, [](const PatchShakedown& p) { return p.lower.value; });
    out.add("in_words", record::Text{in_words(worst, properties)})
        .add("first_yield",
             Number{worst.first_yield.value, "1", "load factor up to which nothing yields, worst patch"})
        .add("shakedown",
             Number{worst.lower.value, "1", "load factor up to which it shakes down, worst patch"})
        .add("shakedown_upper",
             Number{worst.upper.value, "1", "load factor from which it does not, worst patch"});
  }
  record::Record sections;
  for (std::size_t k = 0; k < found.patches.size(); ++k)
    sections.add(fmt::format("{}", k + 1),
                 section_record(found.patches[k], in_words(found.patches[k], properties)));
  out.add("sections", std::move(sections));
  return out;
}

} // namespace bem_contact::shakedown
