#pragma once

#include "bem_contact/sequence/comparison.hpp"

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace bem_contact::app {

/// {"models": [...], "reference": name, "at_equal_forces": set, "creep_forces": [...], "at_equal_position":
/// set}. A set has a result (to_json() of report.hpp) for each model, and "difference": for each model but
/// the reference, what the reference is beyond it. pmax, area and approach are relative to the model's own
/// value, forces and moments to what is never near zero (Fx: sum mu p_n dS; Fy and Fz: their resultant; Mz:
/// sum mu p_n dS times the root of area / pi). What has its unit in its name (lateral_mm) or none
/// (xi_free_rolling, adhesion) is the plain difference. null: a set that the scene does not have, or a
/// difference that says nothing.
nlohmann::json to_json(const Comparison& comparison);

/// The same for people, results at equal forces first.
std::string to_text(const Comparison& comparison);

} // namespace bem_contact::app
