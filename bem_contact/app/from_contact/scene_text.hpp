#pragma once

#include "bem_contact/app/from_contact/contact_cases.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace bem_contact::app::from_contact {

/// The case as a scene file in `folder`. `stem`: how the names of its tables begin; `input`: what it was made
/// from.
std::string scene_of_case(const ContactCase& one, const std::filesystem::path& input,
                          const std::filesystem::path& folder, const std::string& stem);

/// All tables beside the scene: those of the case, and motion.step_table where it has several steps.
std::vector<SceneTableFile> tables_of_case(const ContactCase& one);

/// Name of the file of a table: "cases_001_step_table.csv".
std::string name_of_table(const std::string& stem, const SceneTableFile& table);

} // namespace bem_contact::app::from_contact
