#pragma once

#include "bem_contact/profile/standards/standard_tables.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace bem_contact {

/// A wheel of EN 13715: its flange and the slope at its outer end.
struct En13715Wheel {
  double height = 28;      ///< of the flange, mm: 28 .. 32
  double thickness = 32.5; ///< of the flange, mm: 28.5 .. 32.5
  double slope = 6.7;      ///< of the outer end, %: 6.7 (as the standard rounds 1:15) .. 15

  bool operator==(const En13715Wheel&) const = default;
};

/// What stands behind the name of the tread, as "h28 e30.5 6.7%" in any order, with spaces, hyphens,
/// underscores or slashes between; what is left out is usual. None if it is something else.
std::optional<En13715Wheel> parse_en13715_wheel(std::string_view words);

/// "h28 e30.5 6.7%"
std::string words_of(const En13715Wheel& wheel);

/// The pieces of that wheel, from those of the usual one (data/standards/EN13715.csv). A thinner flange
/// stands farther back: what lies before it moves with it, and a straight line joins the tread at the tape
/// circle. A higher flange has a larger radius on its face, 20 + 0.75 (h - 28) mm. Throws InputError outside
/// the ranges.
std::vector<DrawnPiece> en13715_wheel(const std::vector<DrawnPiece>& usual, const En13715Wheel& wheel);

} // namespace bem_contact
