#include "bem_contact/record/former.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <utility>

namespace bem_contact::record {

namespace {

using Names = std::pair<const char*, const char*>; ///< former, today's

/// Words and fields of a result, and its numbers.
constexpr std::array of_results{Names{"reason", "why_this_model"}, Names{"remark", "solver_note"},
                                Names{"work_rate", "friction_work_density"},
                                Names{"element_power", "friction_work"}, Names{"friction_power", "T_gamma"}};
/// What lies at the top of a file.
constexpr std::array of_files{Names{"equal_forces", "at_equal_forces"},
                              Names{"equal_position", "at_equal_position"},
                              Names{"Fz_N", "Fz"},
                              Names{"bound_N", "bound"},
                              Names{"radius_mm", "radius"},
                              Names{"not_certified", "not_certified_count"},
                              Names{"certified", "certified_count"},
                              Names{"refused", "refused_count"},
                              Names{"died", "died_count"},
                              Names{"missing", "missing_count"}};
constexpr std::array coordinates{
    "x", "s", "y", "z", "delta", "wheel_s", "gap", "rail_profile", "wheel_profile", "frame", "friction"};

template <class Part> const Part* part(const Record& record, std::string_view name) {
  const Content* content = find(record, name);
  return content ? std::get_if<Part>(content) : nullptr;
}

template <std::size_t n> std::string renamed(const std::string& name, const std::array<Names, n>& names) {
  const auto known = std::ranges::find(names, name, &Names::first);
  return known == names.end() ? name : known->second;
}

/// A group with some of its entries under today's names.
template <std::size_t n> Record with_names(const Record& group, const std::array<Names, n>& names) {
  Record out;
  for (const Entry& one : group.entries())
    out.add(renamed(one.name, names), one.content);
  return out;
}

bool is_result(const Record& group) {
  return find(group, "p_n") != nullptr;
}

/// An attribute of a former result that stands in a group, or in another form, today.
bool is_moved(std::string_view name) {
  constexpr std::array moved{"certificate_holds",
                             "certificate_worst",
                             "certificate_tolerance",
                             "normal_solver",
                             "tangential_solver",
                             "quantities",
                             "dx_mm",
                             "ds_mm"};
  return std::ranges::find(moved, name) != moved.end();
}

/// The numbers of a result, with those that were attributes.
Record quantities_of(const Record& group, const Record& around) {
  const Record* numbers = part<Record>(group, "quantities");
  Record out = numbers ? with_names(*numbers, of_results) : Record();
  const auto add = [&](const char* name, const Number* number, const char* unit) {
    if (number && !find(out, name))
      out.add(name, Number{number->value, unit, ""});
  };
  add("certificate", part<Number>(group, "certificate_worst"), "1");
  add("dx", part<Number>(around, "dx_mm"), "mm");
  add("ds", part<Number>(around, "ds_mm"), "mm");
  return out;
}

/// A result as it is today. `around`: where its coordinates are.
Record todays_result(const Record& group, const Record& around) {
  const Number* holds = part<Number>(group, "certificate_holds");
  if (!holds)
    return group;
  Record out{{"certified", holds->value == 1}};
  for (const Entry& one : group.entries())
    if (!is_moved(one.name))
      out.add(renamed(one.name, of_results), one.content);
  if (&group != &around)
    for (const char* name : coordinates)
      if (const Content* content = find(around, name))
        out.add(name, *content);
  out.add("quantities", quantities_of(group, around));
  if (const auto* tolerance = part<Number>(group, "certificate_tolerance"))
    out.add("certificate", Record{{"tolerance", *tolerance}});
  Record solver;
  for (const char* kind : {"normal", "tangential"})
    if (const auto* name = part<Text>(group, std::string(kind) + "_solver"))
      solver.add(kind, *name);
  return out.add("solver", std::move(solver));
}

/// A wheel of a wheelset: its numbers on the track, and its result.
Record todays_wheel(const Record& wheel) {
  Record out, result;
  for (const Entry& one : wheel.entries())
    (one.name == "track" ? out : result).add(one.name, one.content);
  return out.add("result", todays_result(result, result));
}

/// A group of a former file: of results of several models, or one wheel.
Content todays_group(const Entry& one) {
  const auto* group = std::get_if<Record>(&one.content);
  if (!group)
    return one.content;
  if (is_result(*group) && find(*group, "track"))
    return todays_wheel(*group);
  if (is_result(*group))
    return todays_result(*group, *group);
  Record out;
  for (const Entry& inner : group->entries()) {
    const auto* result = std::get_if<Record>(&inner.content);
    out.add(inner.name,
            result && is_result(*result) ? Content(todays_result(*result, *result)) : inner.content);
  }
  return out;
}

/// Digests of curves stood beside the inputs, and names of bodies had those of their wheel in front.
void gather(Record& out, const Record& file) {
  Record geometry;
  for (const char* body : {"rail", "wheel"})
    if (const auto digest = text_at(file, "inputs/" + std::string(body) + ".profile/geometry"))
      geometry.add(body, std::string(*digest));
  if (!geometry.empty() && !find(file, "geometry"))
    out.add("geometry", std::move(geometry));
  for (const std::string side : {"right", "left"}) {
    const auto wheel = text_at(file, side + "_wheel"), rail = text_at(file, side + "_rail");
    if (wheel && rail && !find(file, side))
      out.add(side, Record{{"wheel", Text{std::string(*wheel)}}, {"rail", Text{std::string(*rail)}}});
  }
  Record curves;
  for (const char* creepage : {"xi", "eta", "phi"})
    if (const auto* curve = part<Record>(file, creepage); curve && find(*curve, "creepage"))
      curves.add(creepage, *curve);
  if (!curves.empty())
    out.add("curves", std::move(curves));
}

} // namespace

Record in_todays_layout(Record file) {
  for (const Entry& one : file.entries()) { // the group of a model
    const auto* group = std::get_if<Record>(&one.content);
    if (!group || !is_result(*group) || find(file, "p_n") || find(*group, "x"))
      continue;
    Record out;
    for (const Entry& other : file.entries())
      if (&other != &one && !is_moved(other.name) &&
          std::ranges::find(coordinates, other.name) == coordinates.end())
        out.add(other.name, other.content);
    gather(out, file);
    return out.append(todays_result(*group, file));
  }
  Record out;
  for (const Entry& one : file.entries())
    if (std::holds_alternative<bool>(one.content)) // "certified"; of a former sweep it is a count
      out.add(one.name, one.content);
    else
      out.add(renamed(one.name, of_files), todays_group(one));
  gather(out, file);
  return out;
}

} // namespace bem_contact::record
