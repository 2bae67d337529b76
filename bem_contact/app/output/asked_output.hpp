#pragma once

#include "bem_contact/sequence/stresses.hpp"
#include "bem_contact/sequence/structural_result.hpp"

#include <optional>
#include <string>

/// The parts of a result that only some scenes ask for. A text is empty where there is none.
namespace bem_contact::app {

/// One line: the point where the largest shear stress is largest.
std::string stresses_text(const std::optional<StressesBelow>& stresses);

/// One line for each body and one about the search.
std::string structure_text(const std::optional<StructuralResult>& structure);

} // namespace bem_contact::app
