#pragma once

#include "bem_contact/profile/bodies/body_file.hpp"
#include "bem_contact/profile/bodies/rail_section.hpp"
#include "bem_contact/profile/profile_curve.hpp"

#include <vector>

namespace bem_contact {

/// The outline of a body file of kind "outline", found sound.
struct OwnOutline {
  struct Piece {
    SectionPiece shape;
    PieceGroup group = PieceGroup::free;
  };
  std::vector<Piece> contact; ///< neighbouring pieces of group contact, in walking order
  std::vector<Piece> rest;    ///< the pieces that close the loop behind them
};

/// Throws InputError for fewer than 3 pieces (2 with an arc), pieces without length, arcs too wide for their
/// radius, no or separate contact pieces, contact pieces whose tangents differ at a joint by more than
/// 0.01 rad, nothing held, a loop walked the wrong way, and a body of revolution that reaches its axle.
/// Crossings are found by the mesh, which has them as polygons.
OwnOutline own_outline(const BodyFile::Body& body);

/// The contact pieces as one curve.
ProfileCurve outline_profile(const BodyFile::Body& body);

} // namespace bem_contact
