#pragma once

#include <span>
#include <string>
#include <string_view>

namespace bem_contact {

/// A steel of rails or wheels, and the hardness that its standard asks for at least.
struct Steel {
  std::string_view name;
  double hardness;         ///< Brinell, HBW
  std::string_view source; ///< standard

  /// The pressure under which its surface is indented as a whole, MPa: its hardness (Tabor 1951: the mean
  /// pressure of a Brinell test; kgf/mm^2 there).
  double indentation_pressure() const { return 9.80665 * hardness; }
};

std::span<const Steel> steels();
/// Throws InputError that names the nearest steels.
const Steel& steel_named(const std::string& name);

} // namespace bem_contact
