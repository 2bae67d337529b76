#include "bem_contact/app/sweep/sweep_record.hpp"

#include <nlohmann/json.hpp>
#include <utility>

namespace bem_contact::app {

namespace {

using nlohmann::json;

/// CBOR keeps every double to the last bit, not-a-number included.
json table_to_json(const H5Table& table) {
  json datasets = json::object(), attributes = json::object();
  for (const auto& [name, d] : table.datasets)
    datasets[name] = {d.shape, d.values, d.unit, d.description, d.whole};
  for (const auto& [name, value] : table.attributes)
    std::visit([&, &key = name](const auto& v) { attributes[key] = v; }, value);
  json texts = json::object();
  for (const auto& [name, t] : table.texts)
    texts[name] = {t.text, t.description, t.lines};
  return {std::move(datasets), std::move(attributes), std::move(texts)};
}

H5Table table_from_json(const json& j) {
  H5Table table;
  for (const auto& [name, d] : j.at(0).items())
    table.datasets[name] = {d.at(0), d.at(1), d.at(2), d.at(3), d.at(4)};
  for (const auto& [name, value] : j.at(1).items())
    table.attributes[name] = value.is_string()    ? H5Attribute(value.get<std::string>())
                             : value.is_boolean() ? H5Attribute(value.get<bool>())
                                                  : H5Attribute(value.get<double>());
  for (const auto& [name, t] : j.at(2).items())
    table.texts[name] = {t.at(0), t.at(1), t.at(2)};
  return table;
}

} // namespace

std::string to_bytes(const CaseRecord& r) {
  const json j = {r.index,   static_cast<int>(r.status), r.reason, r.seconds, r.cpu_seconds, r.summary,
                  r.patches, table_to_json(r.fields)};
  std::string out;
  json::to_cbor(j, out);
  return out;
}

CaseRecord from_bytes(std::string_view bytes) {
  const json j = json::from_cbor(bytes);
  return {{j.at(0), static_cast<CaseStatus>(j.at(1).get<int>()), j.at(2), j.at(3), j.at(4), j.at(5), j.at(6)},
          table_from_json(j.at(7))};
}

} // namespace bem_contact::app
