#pragma once

#include "bem_contact/app/output/scene_record.hpp"
#include "bem_contact/influence/h5_table.hpp"
#include "bem_contact/sequence/comparison.hpp"

#include <filesystem>
#include <string>

namespace bem_contact::app {

/// A result file. It says what was asked and with what (add_scene()): enough to repeat it.
/// At the top lie the coordinates of the grid (x[mx], s, y, z, delta [ms], gap [ms][mx]) and both profiles
/// near the contact. A group with the model's name ("fem") holds the element_quantities() [ms][mx], and the
/// groups quantities (one number each), patches [patch] and, where the scene asks for them, history [step],
/// stresses and structure. Every dataset has a unit and a description. Attributes of the model's group tell
/// which solver finished and whether the certificate holds; the text "warnings" has a line for each.
/// `output`: where the table will be written.
H5Table to_table(const SceneResult& result, const GivenScene& given, const std::filesystem::path& output);

/// Coordinates, fields and numbers of one of several results in a file, in `group` (a path with its last
/// slash).
void add_whole_result(H5Table& table, const std::string& group, const SceneResult& result);

/// A case of a sweep, which keeps scene, inputs and quantities of all cases at its top: coordinates, fields,
/// patches.
H5Table to_case_table(const SceneResult& result);

/// A file of a comparison: scene and inputs as above, and groups equal_forces/MODEL and equal_position/MODEL,
/// each with all else. Each result has a grid of its own: at equal forces the wheels stand at different
/// places. Where the comparison has them, the group creep_forces holds xi_from_free_rolling, Fx/MODEL and
/// Fx_error/MODEL, [creepage] each.
H5Table to_table(const Comparison& comparison, const GivenScene& given, const std::filesystem::path& output);

} // namespace bem_contact::app
