#pragma once

#include "bem_contact/influence/h5_table.hpp"
#include "bem_contact/sequence/stresses.hpp"
#include "bem_contact/sequence/structural_result.hpp"

#include <nlohmann/json_fwd.hpp>

#include <optional>
#include <string>

/// The parts of a result that only some scenes ask for. JSON is null and text is empty where there is none.
namespace bem_contact::app {

/// Lists run over x, s and depth, depth fastest.
nlohmann::json stresses_json(const std::optional<StressesBelow>& stresses);
/// One line: the point where the largest shear stress is largest.
std::string stresses_text(const std::optional<StressesBelow>& stresses);
/// Datasets x, s, depths, von_mises, largest_shear, stress under `group`.
void add_stresses(H5Table& table, const std::string& group, const StressesBelow& stresses);

/// How the bodies' structures give way.
nlohmann::json structure_json(const std::optional<StructuralResult>& structure);
/// One line for each body and one about the search.
std::string structure_text(const std::optional<StructuralResult>& structure);
/// Under `group`, for rail and wheel: before, after, force, motion, compliance and stiffness.
void add_structure(H5Table& table, const std::string& group, const StructuralResult& structure);

} // namespace bem_contact::app
