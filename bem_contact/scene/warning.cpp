#include "bem_contact/scene/warning.hpp"

#include "bem_contact/base/error.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace bem_contact {

Warnings::Warnings(std::initializer_list<Warning> all) {
  for (const Warning& one : all)
    add(one);
}

void Warnings::add(Warning one) {
  const auto behind = std::ranges::upper_bound(all_, one.kind, {}, &Warning::kind);
  all_.insert(behind, std::move(one));
}

void Warnings::add(const Warnings& others) {
  for (const Warning& one : others)
    if (std::ranges::find(all_, one) == all_.end())
      add(one);
}

std::vector<std::string> Warnings::texts() const {
  std::vector<std::string> out;
  for (const Warning& one : all_)
    out.push_back(one.text);
  return out;
}

std::vector<std::string> Warnings::kinds() const {
  std::vector<std::string> out;
  for (const Warning& one : all_)
    out.emplace_back(name_of(one.kind));
  return out;
}

Warnings once_each(const std::vector<PlacedWarning>& warnings) {
  struct Group {
    Warning first;
    std::vector<std::string> places, others; ///< of this text; of other figures
  };
  std::vector<Group> groups;
  for (const PlacedWarning& one : warnings) {
    const std::string& place = one.place;
    const Warning& warning = one.warning;
    const auto known = std::ranges::find_if(
        groups, [&](const Group& group) { return group.first.differs_in_figures(warning); });
    if (known == groups.end())
      groups.push_back({warning, {place}, {}});
    else
      (known->first.text == warning.text ? known->places : known->others).push_back(place);
  }
  Warnings out;
  for (Group& g : groups) {
    std::string text = fmt::format("{}: {}", fmt::join(g.places, ", "), g.first.text);
    if (!g.others.empty())
      text += fmt::format(" [{} more with other figures: {}]", g.others.size(), fmt::join(g.others, ", "));
    out.add(g.first.kind, std::move(text), std::move(g.first.about));
  }
  return out;
}

void refuse_warnings(const Warnings& warnings) {
  if (!warnings.empty())
    throw InputError(fmt::format("{}", fmt::join(warnings.texts(), "; ")),
                     "warnings are taken as errors here",
                     "Mend what they say, or do not ask for strictness.");
}

} // namespace bem_contact
