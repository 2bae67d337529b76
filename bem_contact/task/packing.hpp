#pragma once

#include "bem_contact/uses/conicity/conicity_map.hpp"
#include "bem_contact/uses/curves/creep_curves.hpp"
#include "bem_contact/uses/sweep/sweep_rows.hpp"
#include "bem_contact/uses/table/scene_table.hpp"
#include "bem_contact/uses/wear/study.hpp"

#include <nlohmann/json.hpp>

/// What tasks are asked and answer, as bytes: structs whose members are listed here once, in the binary form
/// of JSON (CBOR, RFC 8949), which keeps every bit of a number.
namespace nlohmann {

template <class T> struct adl_serializer<std::optional<T>> {
  static void to_json(json& to, const std::optional<T>& from) { to = from ? json(*from) : json(); }
  static void from_json(const json& from, std::optional<T>& to) {
    to = from.is_null() ? std::nullopt : std::optional<T>(from.get<T>());
  }
};

template <> struct adl_serializer<bem_contact::SceneText> {
  static void to_json(json& to, const bem_contact::SceneText& from) {
    to = json::array({from.toml, from.source, from.folder.string()});
  }
  static bem_contact::SceneText from_json(const json& from) {
    return {from.at(0).get<std::string>(), from.at(1).get<std::string>(), from.at(2).get<std::string>()};
  }
  static void from_json(const json& from, bem_contact::SceneText& to) { to = from_json(from); }
};

template <> struct adl_serializer<bem_contact::SchemaValue> {
  static void to_json(json& to, const bem_contact::SchemaValue& from) {
    std::visit([&](const auto& value) { to = value; }, from);
  }
  static void from_json(const json& from, bem_contact::SchemaValue& to) {
    if (from.is_boolean())
      to = from.get<bool>();
    else if (from.is_number_float())
      to = from.get<double>();
    else if (from.is_number())
      to = from.get<std::int64_t>();
    else if (from.is_string())
      to = from.get<std::string>();
    else
      to = from.get<std::vector<double>>();
  }
};

} // namespace nlohmann

namespace bem_contact {

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Point2, y, z)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Measured, value, error)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(SceneChange, key, value)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(CaseRange, first, last)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(HeldContact, model, dx, ds, lateral, layer_compliance, offset)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(CreepPoint, creepage, forces, coarse, adhesion_share, certified)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(SweepNumbers, cases, patch_case, patch_rank, patches)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(SweepRows, cases, status, reasons, numbers)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(ProfileScatter, noise, draws, seed)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(ConicityMapRange, wheels, rails, gauges, amplitude, rolls, scatter)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(ConicityMap::Entry, wheel, rail, gauge, tan_gamma, wavelength, rail_travel,
                                   wheel_travel, play, rated_amplitude, nonlinearity, mean, spread,
                                   nonlinearity_spread, draws)

namespace table {
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(PointValues, values, element_errors)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(CreepScale, log10_a_over_b, c11, c22, poisson)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(SceneTable::KeyAxis, key, points)
} // namespace table

namespace wear {
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(DepthOverS, s, depth, width)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(RowsOnSections, u, body, t)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(CaseWear, rail, wheel, on_sections)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(WornBody, points, depth, area)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(WornSection, at, body, kink, features, worn)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(WornPair, rail, wheel, revolutions, smoothing, smoothed_off, sections)
} // namespace wear

namespace task {

template <class Value> std::string pack(const Value& value) {
  std::string out;
  nlohmann::json::to_cbor(nlohmann::json(value), out);
  return out;
}
template <class Value> Value unpack(const std::string& bytes) {
  return nlohmann::json::from_cbor(bytes).get<Value>();
}

/// A function of two values as one of bytes.
template <auto function> struct Packed;
template <class Common, class Portion, class Answer,
          Answer (*function)(const Common&, const Portion&, const std::atomic<bool>*)>
struct Packed<function> {
  static std::string run(const std::string& common, const std::string& portion,
                         const std::atomic<bool>* stop) {
    return pack(function(unpack<Common>(common), unpack<Portion>(portion), stop));
  }
};

} // namespace task

} // namespace bem_contact
