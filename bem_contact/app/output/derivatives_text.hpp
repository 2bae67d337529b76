#pragma once

#include "bem_contact/sequence/scene_result.hpp"

#include <string>

namespace bem_contact::app {

/// A line for each number of the scene: what the totals change by per unit of it, and how far it may go until
/// an element changes its state. "" without derivatives.
std::string derivatives_text(const SceneResult& result);

} // namespace bem_contact::app
