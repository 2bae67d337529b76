#pragma once

#include "bem_contact/influence/h5_table.hpp"
#include "bem_contact/sequence/structural_result.hpp"

#include <nlohmann/json_fwd.hpp>

#include <optional>
#include <string>

namespace bem_contact::app {

/// null where no body's structure gives way.
nlohmann::json structure_json(const std::optional<StructuralResult>& structure);

/// One line for each body and one about the search. Empty where there is none.
std::string structure_text(const std::optional<StructuralResult>& structure);

/// Under `group`, for rail and wheel: before, after, force, motion, compliance and stiffness.
void add_structure(H5Table& table, const std::string& group, const StructuralResult& structure);

} // namespace bem_contact::app
