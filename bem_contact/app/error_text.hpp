#pragma once

#include "bem_contact/sequence/scene_result.hpp"

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace bem_contact::app {

/// An error with two digits, "4.2", without an exponent where that is short; "" for one that is zero, because
/// the number is prescribed, and for one that is not known.
std::string two_digits(double error);

/// " +- 4.2", or "" where two_digits() are.
std::string plus_minus(double error);

/// The number of this name (quantities()), as plus_minus() has its error.
std::string plus_minus(const SceneResult& result, const char* name);

/// "pmax 437.0 +- 4.2 MPa, area ..." in one line, with what each stands for.
std::string pressure_text(const SceneResult& result);

/// The line below a patch in the table of patches, of the same columns; "" where nothing is estimated.
std::string patch_errors_text(const SceneResult& result, std::size_t patch);

/// A member "<name>_error" beside each number of `numbers` that has an estimate (quantities()); nan, which
/// JSON writes as null, where it has none.
void add_errors(const SceneResult& result, nlohmann::json& numbers);

} // namespace bem_contact::app
