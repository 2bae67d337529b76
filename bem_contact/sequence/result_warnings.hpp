#pragma once

#include "bem_contact/sequence/plan/contact_case.hpp"
#include "bem_contact/sequence/scene_result.hpp"

#include <string>

namespace bem_contact {

/// What a person should know before using a result that was solved, in sentences: "<what> (<figure, unit>)
/// <what to do>". Pressure beyond the strength of steel, large creepages, contact beyond the rail's head,
/// elements that are too large, fields that do not converge.
Warnings result_warnings(const ContactCase& asked, const SceneResult& result);

/// Adds a warning if no model that can be taken is good enough (SceneResult::model_enough).
void warn_of_model(SceneResult& out);

/// Copies from another solution of the same question why its model was taken and whether it is good enough.
void take_choice(const ModelChoice& chosen, SceneResult& out);

/// Adds a warning if the estimated error of a solution is above the grid.accuracy asked for. `why`: the
/// reason why the accuracy was not reached.
void warn_of_accuracy(const SceneFile::Grid& asked, const std::string& why, SceneResult& out);

/// Adds warnings if Fy hardly depends on the lateral displacement, so that load.force_y hardly determines it.
/// `at_start`: Fy at position.lateral, N, if it is known.
void warn_of_lateral(const SceneFile& asked, std::optional<double> at_start, SceneResult& out);

} // namespace bem_contact
