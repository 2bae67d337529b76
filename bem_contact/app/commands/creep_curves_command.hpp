#pragma once

#include "bem_contact/app/command.hpp"
#include "bem_contact/uses/curves/creep_curves.hpp"
#include "bem_contact/uses/curves/measured_forces.hpp"

#include <string>

namespace bem_contact::app {

/// `bem_contact creep-curves SCENE`.
Command add_creep_curves(CLI::App& program);

/// "FROM:TO:COUNT", equal steps, or "auto": chosen. Throws InputError for any other text.
CreepRange creep_range(CreepKind kind, const std::string& text);

/// Measured forces beside computed ones, a line a point. `file`: that they were read from.
std::string measured_text(const MeasuredForces& measured);

} // namespace bem_contact::app
