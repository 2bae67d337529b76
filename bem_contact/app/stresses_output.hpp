#pragma once

#include "bem_contact/influence/h5_table.hpp"
#include "bem_contact/sequence/stresses.hpp"

#include <nlohmann/json_fwd.hpp>

#include <optional>
#include <string>

namespace bem_contact::app {

/// null where they were not asked for. Lists run over x, s and depth, depth fastest.
nlohmann::json stresses_json(const std::optional<StressesBelow>& stresses);

/// One line: the point where the largest shear stress is largest. Empty where there is none.
std::string stresses_text(const std::optional<StressesBelow>& stresses);

/// Datasets x, s, depths, von_mises, largest_shear, stress under `group`.
void add_stresses(H5Table& table, const std::string& group, const StressesBelow& stresses);

} // namespace bem_contact::app
