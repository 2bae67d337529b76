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

/// What solver.model_tolerance may be about. `creepages`: those that are found for prescribed shear forces;
/// not that of free rolling, which comes along.
enum class ModelErrorOf { forces, pmax, creepages, friction_power };
template <> struct EnumNames<ModelErrorOf> {
  static constexpr std::array<std::string_view, 4> names{"forces", "pmax", "creepages", "friction_power"};
};

// The values of grid.accuracy_of and solver.model_tolerance_of: names with commas between. Throw InputError
// for an unknown name, with the nearest known one, and for none.
std::vector<AccuracyOf> accuracy_of(const std::string& names);
std::vector<ModelErrorOf> model_tolerance_of(const std::string& names);

} // namespace bem_contact
