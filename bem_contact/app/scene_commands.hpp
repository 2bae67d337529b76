#pragma once

#include "bem_contact/app/command.hpp"

#include <string>
#include <vector>

namespace bem_contact::app {

/// `bem_contact solve SCENE`: one scene with one model.
Command add_solve(CLI::App& program);

/// `bem_contact compare SCENE`: half-space and finite elements at the same vertical force.
Command add_compare(CLI::App& program);

/// `bem_contact check SCENE`: what would be solved.
Command add_check(CLI::App& program);

/// The values of --model: "auto" and the name of each model.
std::vector<std::string> model_choices();

} // namespace bem_contact::app
