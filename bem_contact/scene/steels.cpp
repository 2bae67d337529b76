#include "bem_contact/scene/steels.hpp"

#include "bem_contact/base/error.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <vector>

namespace bem_contact {

namespace {

constexpr std::string_view rails = "EN 13674-1:2011, tables of tensile strength and hardness";
constexpr std::string_view wheels = "EN 13262:2004+A2:2011, tables of the rim";
constexpr Steel all_steels[] = {
    {"R200", 200, 680, {}, rails},     {"R220", 220, 770, {}, rails},      {"R260", 260, 880, {}, rails},
    {"R260Mn", 260, 880, {}, rails},   {"R320Cr", 320, 1080, {}, rails},   {"R350HT", 350, 1175, {}, rails},
    {"R350LHT", 350, 1175, {}, rails}, {"R370CrHT", 370, 1280, {}, rails}, {"R400HT", 400, 1280, {}, rails},
    {"ER6", 225, 780, 500, wheels},    {"ER7", 235, 820, 520, wheels},     {"ER8", 245, 860, 540, wheels},
    {"ER9", 255, 900, 580, wheels},
};

} // namespace

std::span<const Steel> steels() {
  return all_steels;
}

const Steel& steel_named(const std::string& name) {
  const auto at = std::ranges::find(all_steels, name, &Steel::name);
  if (at != std::end(all_steels))
    return *at;
  std::vector<std::string> names;
  for (const Steel& steel : all_steels)
    names.emplace_back(steel.name);
  const std::vector<std::string> like = nearest_names(name, names);
  throw InputError(fmt::format("There is no steel '{}'", name),
                   fmt::format("these are known: {}", fmt::join(names, ", ")),
                   like.empty() ? "Name one of them, or give the number itself in MPa."
                                : fmt::format("Did you mean {}?", fmt::join(like, " or ")));
}

} // namespace bem_contact
