#pragma once

#include "bem_contact/sequence/scene_result.hpp"

#include <string>

namespace bem_contact::app {

/// An error with two digits, "4.2", without an exponent where that is short; "" for one that is zero, because
/// the number is prescribed, and for one that is not known.
std::string two_digits(double error);

/// " +- 4.2", or "" where two_digits() are.
std::string plus_minus(double error);

/// The number of this name (quantities()), as plus_minus() has its error.
std::string plus_minus(const SceneResult& result, const char* name);

} // namespace bem_contact::app
