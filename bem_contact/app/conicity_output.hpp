#pragma once

#include "bem_contact/conicity/wheelset_conicity.hpp"
#include "bem_contact/influence/h5_table.hpp"

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace bem_contact::app {

/// Tables for people: the contact at whole millimetres of displacement, and the conicity by amplitude.
std::string to_text(const WheelsetConicity& conicity, const WheelsetOnTrack& wheelset);

/// "function": arrays over the lateral displacement; "conicity": arrays over the amplitude, null where there
/// is no motion. mm and rad.
nlohmann::json to_json(const WheelsetConicity& conicity, const WheelsetOnTrack& wheelset);

/// One line for each lateral displacement.
std::string to_csv(const WheelsetConicity& conicity);

/// The groups "function" and "conicity" with the same names as in JSON; nan where there is no motion. Without
/// the record of the scene (add_scene()).
H5Table to_table(const WheelsetConicity& conicity, const WheelsetOnTrack& wheelset);

} // namespace bem_contact::app
