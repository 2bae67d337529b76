#pragma once

#include "bem_contact/uses/shakedown/shakedown_of_result.hpp"

#include <filesystem>
#include <functional>
#include <span>
#include <vector>

namespace bem_contact::shakedown {

/// Results that one call should get at most: each takes some 10 MB while the body is solved for.
inline constexpr int most_cases_in_body = 100;

/// Takes the number of a result, and the stresses inside a body under its tractions.
using UseOfStresses = std::function<void(std::size_t, const inside::StressesInside&)>;

/// The stresses of each result inside the real rail or wheel of a body file (inside/stresses_in_body.hpp):
/// the body's matrices are factorized once for all of them. Or of an influence file that has stresses: no
/// other program is needed then, and `threads` work side by side, which may use them at the same time. Throws
/// InputError where a program is missing or refuses the body.
void for_each_in_body(std::span<const SceneResult> results, const std::filesystem::path& body, int threads,
                      const UseOfStresses& use);

/// shakedown_of() the stresses of each result in this body. Throws what shakedown_of() throws, too.
std::vector<Shakedown> shakedown_in_body(std::span<const SceneResult> results,
                                         const std::filesystem::path& body,
                                         const ShakedownProperties& properties = {}, int threads = 1);

} // namespace bem_contact::shakedown
