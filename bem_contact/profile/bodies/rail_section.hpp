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
/// the base centre, so that the material lies on the side of e_n. EN 13674-1; names: 60E1, 60E2, 54E1, 46E3.
/// Throws InputError for unknown names.
std::vector<SectionPiece> rail_section(std::string_view name);

/// Says whether web and foot are the standard's to the printed figure (60E1, 60E2). Those of 54E1 and 46E3
/// are REPRESENTATIVE: height, foot width and web thickness of the standard, A, Ix and Iy within 0.1 % of its
/// figures.
bool is_exact_rail_section(std::string_view name);

/// The right half of the head alone: top, gauge corner and flank, down to the under-head fillet. All joints
/// are tangent.
std::vector<SectionPiece> rail_head(std::string_view name);

/// The piece as a curve in the section's frame.
CurvePiece curve_of(const SectionPiece& piece);

} // namespace bem_contact
