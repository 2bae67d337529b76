#pragma once

#include "bem_contact/base/enum_names.hpp"

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace bem_contact {

/// What grid.accuracy may be about. `forces`: forces, moment and approach (Discretisation::worst()).
enum class AccuracyOf { forces, pmax, area, adhesion, approach, creepages, friction_power };
template <> struct EnumNames<AccuracyOf> {
  static constexpr std::array<std::string_view, 7> names{"forces",   "pmax",      "area",          "adhesion",
                                                         "approach", "creepages", "friction_power"};
};

/// The value of grid.accuracy_of, names with commas between. Throws InputError for an unknown name and for
/// none.
std::vector<AccuracyOf> accuracy_of(const std::string& names);

} // namespace bem_contact
