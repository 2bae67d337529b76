#pragma once

#include "bem_contact/sequence/comparison.hpp"

#include <string>

namespace bem_contact::app {

/// A comparison for people, results at equal forces first.
std::string to_text(const Comparison& comparison);

} // namespace bem_contact::app
