#pragma once

#include "bem_contact/profile/curve_piece.hpp"

#include <string_view>
#include <vector>

namespace bem_contact {

/// A line or circular arc of a section's outline, (y, z) in mm: y to the right, z down, z = 0 on the top.
struct SectionPiece {
  Point2 from, to;
  double radius = 0; ///< 0: a line; > 0: convex, < 0: concave (the arc is shorter than half a circle)
};

/// The right half (y >= 0) of a rail's whole outline, walked from the top centre over head, web and foot to
/// the base centre, so that the material lies on the side of e_n. Throws InputError for unknown names, and
/// for rails whose head alone is known.
std::vector<SectionPiece> rail_section(std::string_view name);

/// Its first pieces, which wheels can touch: top, gauge corner and flank, down to the under-head fillet. All
/// joints are tangent.
std::vector<SectionPiece> rail_head(std::string_view name);

/// The piece as a curve in the section's frame.
CurvePiece curve_of(const SectionPiece& piece);

} // namespace bem_contact
