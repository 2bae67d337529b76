#pragma once

#include "bem_contact/app/study/study_record.hpp"

#include <filesystem>
#include <functional>
#include <set>
#include <string>
#include <vector>

namespace bem_contact::app {

/// How many draws of the inputs [uncertainty] asks for; 0: none.
int draws_of(const StudyCase& study);

/// Answers each state that is wanted as a study of its own in parts/states/clean and so on. Throws as
/// solve_draws() does.
std::vector<std::vector<PartResult>>
solve_states(const StudyCase& study, const StudyFolder& where, std::set<std::string>& said,
             const std::function<bool(const std::string& state)>& wanted);

/// Answers all states, and gives the headline its numbers in each. Returns warnings: states that have no
/// certified answer.
std::vector<std::string> vary_states(const StudyCase& study, const StudyFolder& where,
                                     std::set<std::string>& said, std::vector<HeadlineNumber>& headline);

/// Draws the inputs of [uncertainty], and answers each draw (from 1) that is wanted as a study of its own in
/// parts/draws/0001 and so on. The draws depend on the seed alone. Throws InputError for parts that the study
/// does not have, and for a load that the scene does not give.
std::vector<std::vector<PartResult>> solve_draws(const StudyCase& study, const StudyFolder& where,
                                                 std::set<std::string>& said,
                                                 const std::function<bool(int draw)>& wanted);

/// Answers all draws, and gives the headline the standard deviation of each number. Returns warnings: draws
/// that have no certified answer. Throws what solve_draws() does.
std::vector<std::string> draw_inputs(const StudyCase& study, const StudyFolder& where,
                                     std::set<std::string>& said, std::vector<HeadlineNumber>& headline);

} // namespace bem_contact::app
