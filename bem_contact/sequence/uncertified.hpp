#pragma once

#include "bem_contact/base/error.hpp"
#include "bem_contact/sequence/scene_result.hpp"

#include <string>

namespace bem_contact {

/// Why a result is not certified(), in words: the worst violation and what the solver says of it, of the
/// first step that is not a solution, because later steps start from it. "" if it is certified.
std::string why_not_certified(const SceneResult& result);

/// Why the pressure of a result does not converge with the size of the elements, in words.
std::string why_not_convergent(const ContactResult& result);

/// Returns the same as an error, for callers that take only certified results.
ConvergenceError uncertified_error(const SceneResult& result);
/// Throws it unless the result is certified(): there is no wear, fatigue or table of what is no solution.
void require_certified(const SceneResult& result);

} // namespace bem_contact
