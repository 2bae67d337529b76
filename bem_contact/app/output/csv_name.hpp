#pragma once

#include <string>
#include <string_view>

namespace bem_contact::app {

/// The head of a column: "Mz_Nmm" of the name "Mz" and the unit "N mm", without a unit the name alone.
inline std::string csv_name(std::string_view name, std::string_view unit) {
  std::string out(name);
  if (unit == "1")
    return out;
  out += '_';
  for (const char c : unit)
    if (c != ' ' && c != '^')
      out += c;
  return out;
}

} // namespace bem_contact::app
