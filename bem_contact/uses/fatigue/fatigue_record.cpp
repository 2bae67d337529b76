#include "bem_contact/sequence/load_collective.hpp"
#include "bem_contact/uses/fatigue/fatigue_of_result.hpp"

#include <array>
#include <vector>

namespace bem_contact::fatigue {

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
     {"p0_over_k_limit", "1",
      "shakedown limit below the surface with this mu used, of a long contact, or in the body that is given",
      [](const P& p) { return p.limit_below; }},
     {"T_gamma", "N", "dissipated by friction by rolled distance", [](const P& p) { return p.t_gamma; }},
     {"damage", "1", "of one passage", [](const P& p) { return p.damage; }}}};

template <class P>
constexpr std::array<ColumnOf<P>, 2> columns_in_body{
    {{"shakedown", "1", "load factor up to which it shakes down in the body; nan: too few elements",
      [](const P& p) { return p.shakedown; }, Missing::possible},
     {"shakedown_upper", "1", "load factor from which it does not",
      [](const P& p) { return p.shakedown_upper; }, Missing::possible}}};

} // namespace

std::span<const ColumnOf<PatchFatigue>> patch_columns(bool in_body) {
  static const std::vector<ColumnOf<PatchFatigue>> of_body = [] {
    std::vector<ColumnOf<PatchFatigue>> all(columns_of<PatchFatigue>.begin(), columns_of<PatchFatigue>.end());
    all.insert(all.end(), columns_in_body<PatchFatigue>.begin(), columns_in_body<PatchFatigue>.end());
    return all;
  }();
  return in_body ? std::span<const ColumnOf<PatchFatigue>>(of_body) : columns_of<PatchFatigue>;
}

namespace {

using CollectiveColumns = std::vector<ColumnOf<CollectivePatch>>;

CollectiveColumns columns_of_collective(bool in_body) {
  using P = CollectivePatch;
  CollectiveColumns all = columns_of_case<P>();
  all.insert(all.end(), columns_of<P>.begin(), columns_of<P>.end());
  all.insert(all.end(),
             {{"von_mises", "MPa", "largest below the surface of the case",
               [](const P& p) { return p.peaks.von_mises.stress; }},
              {"von_mises_depth", "mm", "where that is", [](const P& p) { return p.peaks.von_mises.depth; }},
              {"tresca", "MPa", "largest shear stress below the surface of the case",
               [](const P& p) { return p.peaks.tresca.stress; }},
              {"tresca_depth", "mm", "where that is", [](const P& p) { return p.peaks.tresca.depth; }}});
  if (!in_body)
    return all;
  all.insert(all.end(), columns_in_body<P>.begin(), columns_in_body<P>.end());
  all.insert(all.end(), {{"halfspace_von_mises", "MPa", "largest of a half-space at the same points",
                          [](const P& p) { return p.halfspace_peaks.von_mises.stress; }},
                         {"halfspace_tresca", "MPa", "the same, shear stress",
                          [](const P& p) { return p.halfspace_peaks.tresca.stress; }}});
  return all;
}

/// What the least shakedown factor is, in a body.
void add_worst(record::Record& out, const std::optional<shakedown::PatchShakedown>& worst,
               const FatigueProperties& properties) {
  if (properties.body.empty())
    return;
  out.add("body", properties.body.filename().string());
  if (worst)
    out.add("in_words", in_words(*worst, {.yield_shear = properties.yield_shear}));
}

} // namespace

std::span<const ColumnOf<CollectivePatch>> collective_columns(bool in_body) {
  static const CollectiveColumns plain = columns_of_collective(false), of_body = columns_of_collective(true);
  return in_body ? of_body : plain;
}

record::Record record_of(const Fatigue& f, const ContactGrid& grid, const FatigueProperties& properties) {
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
                     {"patches", record::as_rows(record::table_of(
                                     "patch", patch_columns(!properties.body.empty()), f.patches))}};
  if (f.peaks)
    out.add("von_mises", peak(f.peaks->von_mises, "largest below the surface"))
        .add("tresca", peak(f.peaks->tresca, "largest shear stress below the surface"));
  if (f.halfspace_peaks)
    out.add("halfspace_von_mises", peak(f.halfspace_peaks->von_mises, "of a half-space at the same points"))
        .add("halfspace_tresca", peak(f.halfspace_peaks->tresca, "the same, shear stress"));
  add_worst(out, f.worst, properties);
  return out;
}

record::Record record_of(const CollectiveFatigue& f, const FatigueProperties& properties) {
  using record::Number;
  record::Record out{
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
      {"patches", record::as_rows(record::table_of(
                      "patch of a case", collective_columns(!properties.body.empty()), f.patches))}};
  add_worst(out, f.worst, properties);
  return out;
}

} // namespace bem_contact::fatigue
