#pragma once

#include <numbers>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace bem_contact {

/// A steel of rails or wheels, and what its standard asks for at least. The numbers are as others quote them:
/// compare them with the standard before a decision rests on them.
struct Steel {
  std::string_view name;
  double hardness = 0;              ///< Brinell, HBW
  double tensile_strength = 0;      ///< R_m, MPa
  std::optional<double> yield = {}; ///< R_eH, MPa; the standard of rails has none
  std::string_view source = {};     ///< standard

  /// The pressure under which its surface is indented as a whole, MPa: its hardness (Tabor 1951: the mean
  /// pressure of a Brinell test; kgf/mm^2 there).
  double indentation_pressure() const { return 9.80665 * hardness; }
  /// k = R_eH / sqrt(3), MPa.
  std::optional<double> yield_shear() const {
    return yield ? std::optional(*yield / std::numbers::sqrt3) : std::nullopt;
  }
};

std::span<const Steel> steels();
/// Throws InputError that names the nearest steels.
const Steel& steel_named(const std::string& name);

} // namespace bem_contact
