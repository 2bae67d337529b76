#pragma once

#include "bem_contact/curves/creep_curves.hpp"
#include "bem_contact/influence/h5_table.hpp"

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace bem_contact::app {

/// Tables for people: slopes at zero beside Kalker's, sensitivities, and each curve.
std::string to_text(const CreepCurves& curves);

/// "slopes", "kalker" and "sensitivities" are matrices [Fx, Fs, Mz][xi, eta, phi]; "curves" has arrays for
/// each creepage that was varied. N, mm; errors that are not known are null.
nlohmann::json to_json(const CreepCurves& curves);

/// All curves below each other: which, creepage, forces, their errors, adhesion, certified.
std::string to_csv(const CreepCurves& curves);

/// Groups "xi", "eta", "phi" for the curves; the matrices at the top. Errors that are not known are nan.
/// Without the record of the scene (add_scene()).
H5Table to_table(const CreepCurves& curves);

} // namespace bem_contact::app
