#pragma once

#include "bem_contact/base/error.hpp"

#include <cmath>
#include <initializer_list>
#include <string>
#include <utility>

namespace bem_contact::reference {

/// Throws InputError unless all values are finite and above 0.
inline void require_positive(std::initializer_list<std::pair<const char*, double>> values) {
  for (const auto& [name, value] : values)
    if (!(std::isfinite(value) && value > 0))
      throw InputError(std::string("A closed form cannot be evaluated: the ") + name + " is " +
                           std::to_string(value),
                       "it has to be a number above 0", "Give a positive value.");
}

} // namespace bem_contact::reference
