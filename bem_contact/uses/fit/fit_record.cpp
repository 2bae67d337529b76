#include "bem_contact/uses/fit/fit_record.hpp"

#include "bem_contact/sequence/result_record.hpp"
#include "bem_contact/uses/curves/creep_record.hpp"

#include <fmt/format.h>

namespace bem_contact::fit {

namespace {

using record::Column;
using record::Number;
using record::Record;

constexpr const char* bound_names[] = {"", "lower", "upper"};

Record record_of(const FittedKey& k) {
  const std::string unit = k.unit.empty() ? "1" : k.unit;
  return {
      {"value", Number{k.value, unit, "found"}},
      {"low", Number{k.low, unit, "lower end of the interval of 95 %; nan: no point depends on it"}},
      {"high", Number{k.high, unit, "upper end of it"}},
      {"standard_error", Number{k.standard_error, unit, "of what was found, by the scatter of the points"}},
      {"start", Number{k.start, unit, "first guess"}},
      {"determined", k.determined},
      {"at_bound", record::Text{bound_names[static_cast<std::size_t>(k.bound)]}}};
}

const char* unit_of(const MeasuredForces& m) {
  return m.force == CreepForce::Mz ? "N mm" : "N";
}

record::Table band_table(const CurveFit& fit) {
  const MeasuredForces& first = fit.measured.forces.front();
  const char* unit = unit_of(first);
  Column creepage{"creepage", bem_contact::unit_of(first.which), "of the curve", {}},
      low{"low", unit, "95 % of what the points allow lies above", {}},
      high{"high", unit, "95 % of what the points allow lies below", {}};
  for (std::size_t i = 0; i < fit.band.size(); ++i) {
    creepage.values.push_back(fit.curves->curves[0].points[i].creepage);
    low.values.push_back(fit.band[i].first);
    high.values.push_back(fit.band[i].second);
  }
  return {"point", {creepage, low, high}};
}

/// "measured", "measured_2" ...
std::string numbered(const char* name, std::size_t index) {
  return index == 0 ? name : fmt::format("{}_{}", name, index + 1);
}

Number misfit(const Differences& differences, const char* unit) {
  return {differences.root_mean_square, unit, "root of the mean square of computed less measured"};
}

/// Each table of measured forces and pressures with what is computed there.
void add_measurements(const Measurements& all, Record& out) {
  for (std::size_t k = 0; k < all.forces.size(); ++k)
    out.add(numbered("measured", k),
            bem_contact::record_of(all.forces[k])
                .add("misfit", misfit(differences_of(all.forces[k]), unit_of(all.forces[k]))));
  for (std::size_t k = 0; k < all.pressures.size(); ++k) {
    const MeasuredPressures& m = all.pressures[k];
    const Differences differences(m.computed, m.measured, m.scatter);
    out.add(numbered("pressures", k), record_of(m).add("misfit", misfit(differences, "MPa")));
  }
}

/// What there is without creep curves.
void add_solution(const SceneResult& solution, Record& out) {
  out.add("model", record::Text{std::string(name_of(solution.choice.model))});
  out.add("Fz", Number{solution.result.totals.Fz, "N", "on the rail, down"});
  out.append(record_of(solution.warnings));
}

} // namespace

Record record_of(const CurveFit& fit) {
  Record parameters;
  record::Texts names{{}, "keys that were fitted, in the order of `correlation`"};
  for (const FittedKey& key : fit.keys) {
    parameters.add(key.key, record_of(key));
    names.lines.push_back(key.key);
  }
  Record out{{"parameters", std::move(parameters)},
             {"parameter_names", std::move(names)},
             {"correlation", record::field(fit.correlation, "1", "[key][key] of what was found",
                                           {fit.keys.size(), fit.keys.size()})},
             {"tried", Number{double(fit.tried), "1", "sets of values that were solved", {}, true}},
             {"converged", fit.converged},
             {"not_determined", record::Texts{fit.undetermined, "what the points do not say"}},
             {"certified", certified(fit)}};
  add_measurements(fit.measured, out);
  if (!fit.curves) {
    add_solution(fit.solution, out);
    return out;
  }
  const MeasuredForces& first = fit.measured.forces.front();
  out.add("misfit", misfit(differences_of(first), unit_of(first)));
  out.add("band", band_table(fit));
  const Record curves = bem_contact::record_of(*fit.curves);
  for (const record::Entry& entry : curves.entries())
    if (entry.name != "certified") // of the curves alone
      out.add(entry.name, entry.content);
  return out;
}

} // namespace bem_contact::fit
