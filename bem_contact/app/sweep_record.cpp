#include "bem_contact/app/sweep_record.hpp"

#include "bem_contact/app/report.hpp"
#include "bem_contact/app/result_file.hpp"
#include "bem_contact/contact/history.hpp"
#include "bem_contact/sequence/printed_errors.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <iterator>
#include <limits>
#include <nlohmann/json.hpp>
#include <string_view>
#include <utility>

namespace bem_contact::app {

namespace {

using nlohmann::json;

double second_patch(const SceneResult& r, double PatchSummary::*number) {
  return r.result.patches.size() > 1 ? r.result.patches[1].*number : 0.0;
}

/// Of the second patch; nan where it has no estimate or is not there.
double second_patch_error(const SceneResult& r, double PatchErrors::*error) {
  return r.result.patches.size() > 1 ? errors_of_patch(r.result, 1).*error
                                     : std::numeric_limits<double>::quiet_NaN();
}

constexpr SummaryColumn plain_columns[] = {
    {"Fx", "N", "on the rail", [](const SceneResult& r) { return r.result.Fx; }},
    {"Fy", "N", "on the rail, to the right (left wheel: to the left)",
     [](const SceneResult& r) { return r.result.Fy; }},
    {"Fz", "N", "on the rail, down", [](const SceneResult& r) { return r.result.Fz; }},
    {"Mz", "N mm", "about the vertical axis through the reference point",
     [](const SceneResult& r) { return r.moment; }},
    {"lateral", "mm", "lateral displacement of the wheelset, given or found for load.force_y",
     [](const SceneResult& r) { return r.lateral.value_or(std::numeric_limits<double>::quiet_NaN()); }},
    {"xi", "1", "longitudinal creepage, with what was found for load.force_x",
     [](const SceneResult& r) { return r.xi; }},
    {"free_rolling_xi", "1", "longitudinal creepage at which Fx = 0; nan: not looked for",
     [](const SceneResult& r) {
       return r.free_rolling ? r.free_rolling->xi : std::numeric_limits<double>::quiet_NaN();
     }},
    {"free_rolling_radius", "mm", "rolling radius at which Fx = 0; nan: not looked for",
     [](const SceneResult& r) {
       return r.free_rolling ? r.free_rolling->rolling_radius : std::numeric_limits<double>::quiet_NaN();
     }},
    {"approach", "mm", "along z", [](const SceneResult& r) { return r.result.approach; }},
    {"pmax", "MPa", "largest pressure", [](const SceneResult& r) { return largest_pressure(r.result); }},
    {"area", "mm2", "in contact", [](const SceneResult& r) { return contact_area(r.result); }},
    {"patches", "1", "connected areas of contact",
     [](const SceneResult& r) { return double(r.result.patches.size()); }},
    {"Fn_2", "N", "normal force of the second largest patch",
     [](const SceneResult& r) { return second_patch(r, &PatchSummary::fn); }},
    {"Fn_2_error", "N", "its estimated error; nan: not known",
     [](const SceneResult& r) { return second_patch_error(r, &PatchErrors::fn); }},
    {"contact", "1", "elements in contact",
     [](const SceneResult& r) { return double(count_elements(r.result).contact); }},
    {"adhesion", "1", "elements in adhesion",
     [](const SceneResult& r) { return double(count_elements(r.result).adhesion); }},
    {"slip", "1", "elements in slip",
     [](const SceneResult& r) { return double(count_elements(r.result).slip); }},
    {"mx", "1", "columns of the grid", [](const SceneResult& r) { return double(r.problem.grid.mx); }},
    {"ms", "1", "rows of the grid", [](const SceneResult& r) { return double(r.problem.grid.ms); }},
    {"dx", "mm", "length of an element", [](const SceneResult& r) { return r.problem.grid.dx; }},
    {"ds", "mm", "width of an element", [](const SceneResult& r) { return r.problem.grid.ds; }},
    {"reference_s", "mm", "where the bodies touch first, on the rail's arc length",
     [](const SceneResult& r) { return r.reference.s; }},
    {"reference_delta", "rad", "inclination there", [](const SceneResult& r) { return r.reference.delta; }},
    {"certificate", "1", "its worst violation",
     [](const SceneResult& r) { return r.result.certificate.worst(); }},
    {"discretisation", "1", "estimated discretisation error; nan: not estimated",
     [](const SceneResult& r) {
       const double e = r.result.certificate.discretisation;
       return e < 0 ? std::numeric_limits<double>::quiet_NaN() : e;
     }},
    {"outer_iterations", "1", "between the normal and the tangential problem",
     [](const SceneResult& r) { return double(r.result.outer_iterations); }},
    {"normal_iterations", "1", "changes of the active set",
     [](const SceneResult& r) { return double(r.result.normal_iterations); }},
    {"tangential_iterations", "1", "steps of the tangential solver",
     [](const SceneResult& r) { return double(r.result.tangential_iterations); }},
    {"warnings", "1", "how many there are; the attribute reason says which",
     [](const SceneResult& r) { return double(r.warnings.size()); }},
    {"model", "1", "0 hertz, 1 halfspace, 2 tangent_plane, 3 fem",
     [](const SceneResult& r) { return static_cast<double>(r.model); }},
};

/// The plain columns, those of the numbers that they do not have, and the errors of all.
std::vector<SummaryColumn> all_columns() {
  std::vector<SummaryColumn> all(std::begin(plain_columns), std::end(plain_columns));
  for (const PrintedNumber& number : printed_numbers()) {
    if (std::ranges::none_of(plain_columns,
                             [&](const SummaryColumn& c) { return std::string_view(c.name) == number.name; }))
      all.push_back({number.name, number.unit, number.description, number.value});
    all.push_back({number.error_name, number.unit,
                   "estimated error by the size of the elements; nan: not known", number.error});
  }
  return all;
}

/// CBOR keeps every double to the last bit, not-a-number included.
json table_to_json(const H5Table& table) {
  json datasets = json::object(), attributes = json::object();
  for (const auto& [name, d] : table.datasets)
    datasets[name] = {d.shape, d.values, d.unit, d.description};
  for (const auto& [name, value] : table.attributes)
    std::visit([&, &key = name](const auto& v) { attributes[key] = v; }, value);
  return {std::move(datasets), std::move(attributes)};
}

H5Table table_from_json(const json& j) {
  H5Table table;
  for (const auto& [name, d] : j.at(0).items())
    table.datasets[name] = {d.at(0), d.at(1), d.at(2), d.at(3)};
  for (const auto& [name, value] : j.at(1).items())
    table.attributes[name] =
        value.is_string() ? H5Attribute(value.get<std::string>()) : H5Attribute(value.get<double>());
  return table;
}

} // namespace

std::span<const SummaryColumn> summary_columns() {
  static const std::vector<SummaryColumn> columns = all_columns();
  return columns;
}

CaseRecord record_of(std::size_t index, const SceneResult& result, bool fields) {
  CaseRecord record;
  record.index = index;
  const Certificate& certificate = result.result.certificate;
  const bool all = std::ranges::all_of(result.history, &ContactResult::converged);
  record.status = certificate.holds() && all ? CaseStatus::certified : CaseStatus::not_certified;
  const auto say = [&](const std::string& text) {
    if (!text.empty())
      record.reason += (record.reason.empty() ? "" : "; ") + text;
  };
  if (!certificate.holds())
    say(fmt::format("its worst violation is {:.1e}, {:.0e} is allowed", certificate.worst(),
                    certificate.tolerance));
  else if (!all)
    say("a step before the last is not a solution");
  say(result.result.remark);
  for (const std::string& warning : result.warnings)
    say(warning);
  for (const SummaryColumn& column : summary_columns())
    record.summary.push_back(column.get(result));
  if (fields) {
    record.fields = to_table(result, "");
    record.fields.attributes.erase("scene");
  }
  return record;
}

std::string to_bytes(const CaseRecord& r) {
  const json j = {r.index,   static_cast<int>(r.status), r.reason, r.seconds, r.cpu_seconds,
                  r.summary, table_to_json(r.fields)};
  std::string out;
  json::to_cbor(j, out);
  return out;
}

CaseRecord from_bytes(std::string_view bytes) {
  const json j = json::from_cbor(bytes);
  return {j.at(0),
          static_cast<CaseStatus>(j.at(1).get<int>()),
          j.at(2),
          j.at(3),
          j.at(4),
          j.at(5),
          table_from_json(j.at(6))};
}

} // namespace bem_contact::app
