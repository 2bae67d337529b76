#pragma once

#include "bem_contact/app/study/study_parts.hpp"

#include <set>
#include <string>

namespace bem_contact::app {

/// The scene of a wheelset without [sweep].
inline constexpr const char* unswept = "unswept.toml";

/// Runs one part of a study, or takes what is there and still true. `said`: messages that have been shown.
PartResult run_part(const Part& part, const StudyCase& study, const StudyFolder& where,
                    std::set<std::string>& said);

/// Removes what an earlier study has left of it.
void remove_part(const Part& part, const StudyCase& study, const StudyFolder& where);

} // namespace bem_contact::app
