#pragma once

#include <limits>

namespace bem_contact {

/// Stands for an error that is not known.
inline constexpr double unknown_error = std::numeric_limits<double>::quiet_NaN();

/// A number and the error that is stated for it, in the same unit. It reads as the number. The error is
/// absolute; 0: the number is prescribed. nan: no error can be told.
struct Measured {
  double value = 0;
  double error = unknown_error;

  constexpr operator double() const { return value; }
};

/// How fmt writes it, from its version 10 on: as the number.
constexpr double format_as(const Measured& number) {
  return number.value;
}

} // namespace bem_contact
