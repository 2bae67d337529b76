#pragma once

#include "bem_contact/app/scene_record.hpp"
#include "bem_contact/wheelset/solve_wheelset.hpp"

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>

namespace bem_contact::app {

/// For people: both wheels side by side in the track frame, then what solve prints of each.
std::string to_text(const WheelsetResult& result);

/// "wheelset" (wheelset_quantities()), "right" and "left": each with "track" (wheel_quantities(), track
/// frame) and "result", the object that solve prints of this wheel, in the frame of its side.
nlohmann::json to_json(const WheelsetResult& result);

/// Groups wheelset, right/track and left/track with one dataset for each number; in right and left the whole
/// result of each wheel as comparisons have it, in the frame of its side. Scene and inputs as in result
/// files.
H5Table to_table(const WheelsetResult& result, const GivenScene& given, const std::filesystem::path& output);

} // namespace bem_contact::app
