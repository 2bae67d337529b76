#include "bem_contact/app/sweep/sweep_record.hpp"

#include "bem_contact/app/output/result_file.hpp"
#include "bem_contact/contact/history.hpp"
#include "bem_contact/sequence/quantities.hpp"
#include "bem_contact/sequence/uncertified.hpp"
#include "bem_contact/uses/wheelset/quantities.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <string_view>
#include <utility>

namespace bem_contact::app {

namespace {

using nlohmann::json;

constexpr const char* model_column = "model";
constexpr const char* of_model = "0 hertz, 1 halfspace, 2 tangent_plane, 3 fem; CSV: its name";

/// Of a table of sequence/quantities.hpp.
template <class Table> std::vector<Column> columns_of(const Table& table) {
  std::vector<Column> all;
  with_errors(table, [&](const std::string& name, const QuantityUnit& unit, auto, const char* description) {
    all.push_back({name, unit.text(), description});
  });
  return all;
}

std::vector<Column> columns_of_cases() {
  std::vector<Column> all = columns_of(quantities());
  all.push_back({model_column, "1", of_model});
  return all;
}

std::vector<Column> columns_of_wheelsets() {
  std::vector<Column> all;
  for (const WheelsetQuantity& q : wheelset_quantities())
    all.push_back({q.name, q.unit, q.description});
  for (const WheelSide side : both_sides) {
    const auto add = [&](const char* name, const char* unit, const char* description) {
      all.push_back({fmt::format("{}_{}", name_of(side), name), unit,
                     fmt::format("{} wheel: {}", name_of(side), description)});
    };
    for (const WheelQuantity& q : wheel_quantities())
      add(q.name, q.unit, q.description);
    add(model_column, "1", of_model);
  }
  all.push_back({"warning_count", "1", "warnings of both wheels"});
  return all;
}

/// In the order of the columns.
std::vector<double> summary_of(const WheelsetResult& result) {
  std::vector<double> values;
  for (const WheelsetQuantity& q : wheelset_quantities())
    values.push_back(q.value(result));
  for (const WheelSide side : both_sides) {
    for (const WheelQuantity& q : wheel_quantities())
      values.push_back(q.value(result.state, side));
    values.push_back(static_cast<double>(result.state.solved(side).model));
  }
  values.push_back(static_cast<double>(result.warnings.size()));
  return values;
}

/// Adds to the reason of a case.
void say(CaseRecord& record, const std::string& text) {
  if (!text.empty())
    record.reason += (record.reason.empty() ? "" : "; ") + text;
}

/// CBOR keeps every double to the last bit, not-a-number included.
json table_to_json(const H5Table& table) {
  json datasets = json::object(), attributes = json::object();
  for (const auto& [name, d] : table.datasets)
    datasets[name] = {d.shape, d.values, d.unit, d.description};
  for (const auto& [name, value] : table.attributes)
    std::visit([&, &key = name](const auto& v) { attributes[key] = v; }, value);
  json texts = json::object();
  for (const auto& [name, t] : table.texts)
    texts[name] = {t.text, t.description};
  return {std::move(datasets), std::move(attributes), std::move(texts)};
}

H5Table table_from_json(const json& j) {
  H5Table table;
  for (const auto& [name, d] : j.at(0).items())
    table.datasets[name] = {d.at(0), d.at(1), d.at(2), d.at(3)};
  for (const auto& [name, value] : j.at(1).items())
    table.attributes[name] =
        value.is_string() ? H5Attribute(value.get<std::string>()) : H5Attribute(value.get<double>());
  for (const auto& [name, t] : j.at(2).items())
    table.texts[name] = {t.at(0), t.at(1)};
  return table;
}

} // namespace

const SweepColumns& contact_columns() {
  static const SweepColumns columns{columns_of_cases(), columns_of(patch_quantities())};
  return columns;
}

const SweepColumns& wheelset_columns() {
  static const SweepColumns columns{columns_of_wheelsets(), {}};
  return columns;
}

bool is_model(const Column& column) {
  return column.name.ends_with(model_column);
}

CaseRecord case_record(std::size_t index, const SceneResult& result, bool fields) {
  CaseRecord record;
  record.index = index;
  const bool all = certified(result);
  record.status = all ? CaseStatus::certified : CaseStatus::not_certified;
  say(record, all ? result.result.remark : why_uncertified(result));
  for (const std::string& warning : result.warnings)
    say(record, warning);
  record.summary = values_of(quantities(), result);
  record.summary.push_back(static_cast<double>(result.model));
  for (std::size_t i = 0; i < result.result.patches.size(); ++i)
    record.patches.push_back(values_of(patch_quantities(), result, i));
  if (fields)
    record.fields = to_case_table(result);
  return record;
}

CaseRecord case_record(std::size_t index, const WheelsetResult& result, bool fields) {
  CaseRecord record;
  record.index = index;
  record.status = result.state.certified() ? CaseStatus::certified : CaseStatus::not_certified;
  record.summary = summary_of(result);
  for (const WheelSide side : both_sides) {
    const SceneResult& wheel = result.state.solved(side);
    const std::string name(name_of(side));
    if (!certified(wheel))
      say(record, fmt::format("{} wheel: {}", name, why_uncertified(wheel)));
    if (fields)
      add_group(record.fields, name + "/", to_case_table(wheel));
  }
  for (const std::string& warning : result.warnings)
    say(record, warning);
  return record;
}

std::string to_bytes(const CaseRecord& r) {
  const json j = {r.index,   static_cast<int>(r.status), r.reason, r.seconds, r.cpu_seconds, r.summary,
                  r.patches, table_to_json(r.fields)};
  std::string out;
  json::to_cbor(j, out);
  return out;
}

CaseRecord from_bytes(std::string_view bytes) {
  const json j = json::from_cbor(bytes);
  return {j.at(0), static_cast<CaseStatus>(j.at(1).get<int>()),
          j.at(2), j.at(3),
          j.at(4), j.at(5),
          j.at(6), table_from_json(j.at(7))};
}

} // namespace bem_contact::app
