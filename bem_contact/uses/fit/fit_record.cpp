#include "bem_contact/uses/fit/fit_record.hpp"

#include "bem_contact/uses/curves/creep_record.hpp"

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

record::Table band_table(const CurveFit& fit) {
  const char* unit = fit.measured.force == CreepForce::Mz ? "N mm" : "N";
  Column creepage{"creepage", unit_of(fit.measured.which), "of the curve", {}},
      low{"low", unit, "95 % of what the points allow lies above", {}},
      high{"high", unit, "95 % of what the points allow lies below", {}};
  for (std::size_t i = 0; i < fit.band.size(); ++i) {
    creepage.values.push_back(fit.curves.curves[0].points[i].creepage);
    low.values.push_back(fit.band[i].first);
    high.values.push_back(fit.band[i].second);
  }
  return {"point", {creepage, low, high}};
}

} // namespace

Record record_of(const CurveFit& fit) {
  Record parameters;
  record::Texts names{{}, "keys that were fitted, in the order of `correlation`"};
  for (const FittedKey& key : fit.keys) {
    parameters.add(key.key, record_of(key));
    names.lines.push_back(key.key);
  }
  const char* unit = fit.measured.force == CreepForce::Mz ? "N mm" : "N";
  Record out{{"parameters", std::move(parameters)},
             {"parameter_names", std::move(names)},
             {"correlation", record::field(fit.correlation, "1", "[key][key] of what was found",
                                           {fit.keys.size(), fit.keys.size()})},
             {"misfit", Number{fit.misfit, unit, "root of the mean square of computed less measured"}},
             {"tried", Number{double(fit.tried), "1", "sets of values that were solved", {}, true}},
             {"converged", fit.converged},
             {"not_determined", record::Texts{fit.undetermined, "what the points do not say"}},
             {"band", band_table(fit)},
             {"measured", bem_contact::record_of(fit.measured)},
             {"certified", certified(fit)}};
  const Record curves = bem_contact::record_of(fit.curves);
  for (const record::Entry& entry : curves.entries())
    if (entry.name != "certified") // of the curves alone
      out.add(entry.name, entry.content);
  return out;
}

} // namespace bem_contact::fit
