#pragma once

#include "bem_contact/uses/shakedown/shakedown_of_result.hpp"

#include <filesystem>
#include <span>
#include <vector>

namespace bem_contact::shakedown {

/// Results that one call should get at most: each takes some 10 MB while the body is solved for.
inline constexpr int most_cases_in_body = 100;

/// shakedown_of() each result, with the stresses inside the real rail or wheel of a body file
/// (inside/stresses_in_body.hpp): the body's matrices are factorized once for all of them. Or of an influence
/// file that has stresses: no other program is needed then, and `threads` work side by side. Throws
/// InputError where a program is missing or refuses the body, and what shakedown_of() throws.
std::vector<Shakedown> shakedown_in_body(std::span<const SceneResult> results,
                                         const std::filesystem::path& body,
                                         const ShakedownProperties& properties = {}, int threads = 1);

} // namespace bem_contact::shakedown
