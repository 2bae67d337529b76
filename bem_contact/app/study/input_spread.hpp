#pragma once

#include "bem_contact/app/study/study_record.hpp"

#include <set>
#include <string>
#include <vector>

namespace bem_contact::app {

/// Draws the inputs of [uncertainty], answers each draw as a study of its own in parts/draws/0001 and so on,
/// and gives the headline the standard deviation of each number. The draws depend on the seed alone. Returns
/// warnings: draws that have no certified answer. Throws InputError for parts that the study does not have,
/// and for a load that the scene does not give.
std::vector<std::string> draw_inputs(const StudyCase& study, const StudyFolder& where,
                                     std::set<std::string>& said, std::vector<HeadlineNumber>& headline);

} // namespace bem_contact::app
