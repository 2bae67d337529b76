#include "bem_contact/uses/curves/measured_forces.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/scene/csv_table.hpp"
#include "bem_contact/uses/curves/creep_record.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <optional>

namespace bem_contact {

namespace {

[[noreturn]] void refuse_columns(const std::string& source, const std::vector<std::string>& columns) {
  throw InputError(fmt::format("The table '{}' holds no measured forces", source),
                   fmt::format("its columns are {}", fmt::join(columns, ", ")),
                   "Begin it with a creepage (xi, eta, phi), a force (Fx, Fs, Mz) and, if it is known, "
                   "scatter, as xi,Fx,scatter.");
}

const Measured& force_of(const MeasuredForces& m, std::size_t i) {
  return m.computed[i].forces[static_cast<std::size_t>(m.force)];
}

} // namespace

bool certified(const MeasuredForces& measured) {
  return std::ranges::all_of(measured.computed, &CreepPoint::certified);
}

MeasuredForces measured_forces(const std::string& source, const std::vector<std::string>& columns,
                               const std::vector<std::vector<double>>& rows) {
  const auto which = columns.size() < 2 ? std::nullopt : value_named<CreepKind>(columns[0]);
  const auto force = columns.size() < 2 ? std::nullopt : value_named<CreepForce>(columns[1]);
  const bool scatter = columns.size() == 3 && columns[2] == "scatter";
  if (!which || !force || (columns.size() > 2 && !scatter))
    refuse_columns(source, columns);
  MeasuredForces out{
      .which = *which, .force = *force, .creepage = {}, .measured = {}, .scatter = {}, .source = source};
  for (const std::vector<double>& row : rows) {
    out.creepage.push_back(row[0]);
    out.measured.push_back(row[1]);
    if (scatter)
      out.scatter.push_back(row[2]);
    if (scatter && row[2] < 0)
      throw InputError(fmt::format("The table '{}' has a scatter of {:g} in its row {}", source, row[2],
                                   out.scatter.size()),
                       "a standard deviation is not below 0", "Correct it, or leave out the column scatter.");
  }
  return out;
}

MeasuredForces read_measured_forces(const std::filesystem::path& file) {
  const std::vector<std::string> columns = csv_columns(file);
  return measured_forces(file.string(), columns, read_csv(file, columns));
}

CreepCurves creep_curves_beside(MeasuredForces& measured, const SceneFile& scene,
                                std::vector<CreepRange> ranges, const std::atomic<bool>* stop,
                                const CreepSolver& solve) {
  ranges.push_back({measured.which, measured.creepage});
  CreepCurves out = creep_curves(scene, ranges, stop, solve);
  measured.computed = std::move(out.curves.back().points);
  out.curves.pop_back();
  return out;
}

Differences differences_of(const MeasuredForces& m) {
  std::vector<double> computed;
  for (std::size_t i = 0; i < m.computed.size(); ++i)
    computed.push_back(force_of(m, i).value);
  return {computed, m.measured, m.scatter};
}

record::Record record_of(const MeasuredForces& m) {
  using record::Column;
  const char* unit = m.force == CreepForce::Mz ? "N mm" : "N";
  Column creepage{"creepage", unit_of(m.which), "at which it was measured", m.creepage},
      measured{"measured", unit, "force on the rail", m.measured},
      scatter{"scatter", unit, "standard deviation of what was measured", m.scatter},
      computed{"computed", unit, "force on the rail", {}},
      error{.name = "computed_error",
            .unit = unit,
            .meaning = record::error_meaning,
            .role = record::Role::error,
            .of = "computed"};
  for (std::size_t i = 0; i < m.computed.size(); ++i) {
    computed.values.push_back(force_of(m, i).value);
    error.values.push_back(force_of(m, i).error);
  }
  const Differences differences = differences_of(m);
  const Column difference{"difference", unit, "computed less measured", differences.each};
  record::Table table{"point", {creepage, measured}};
  if (!m.scatter.empty())
    table.columns.push_back(scatter);
  for (const Column& column : {computed, error, difference})
    table.columns.push_back(column);
  record::Record out{{"creepage", record::Text{std::string(name_of(m.which))}},
                     {"force", record::Text{std::string(name_of(m.force))}},
                     {"mean_difference", record::Number{differences.mean, unit, "computed less measured"}},
                     {"largest_difference", record::Number{differences.largest, unit, "of the magnitudes"}},
                     {"certified", certified(m)}};
  if (!m.scatter.empty())
    out.add("within_scatter", record::Number{double(differences.within_scatter),
                                             "1",
                                             "points whose difference is within their scatter",
                                             {},
                                             true});
  return out.add("points", std::move(table));
}

} // namespace bem_contact
