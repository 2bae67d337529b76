#pragma once

#include "bem_contact/base/enum_names.hpp"
#include "bem_contact/profile/curve_piece.hpp"
#include "bem_contact/profile/profile_kind.hpp"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace bem_contact {

/// A row of data/standards/profiles.csv.
struct StandardEntry {
  /// What its pieces are: the right half of a rail's whole section or of its head, each from the top centre;
  /// or the whole contact curve as it is walked (profile_curve.hpp).
  enum class Part { section, head, curve };

  std::string name;
  ProfileKind kind = ProfileKind::rail;
  Part part = Part::curve;
  std::string table;                    ///< file of data/standards that has its pieces
  bool usual = false;                   ///< measured profiles are compared with it
  std::string standard;                 ///< and its edition
  std::vector<std::string> other_names; ///< as people say them
  std::string remark;
};

template <> struct EnumNames<StandardEntry::Part> {
  static constexpr std::array<std::string_view, 3> names{"section", "head", "curve"};
};

/// All rows, in their order.
std::span<const StandardEntry> standard_entries();

/// A piece of a profile as a table has it, (y, z) in mm: a line, an arc shorter than half a circle, or the
/// polynomial z(y) = sum of c_k (y - shift)^k.
struct DrawnPiece {
  Point2 from, to;
  double radius = 0; ///< 0: no arc; > 0: convex, < 0: concave
  std::vector<double> polynomial = {};
  double shift = 0; ///< mm
};

/// The pieces of a profile. Throws Error where the table is damaged: a number that is none, an end of an arc
/// off its circle or of a polynomial off it, two pieces that do not meet, or a kink that the table does not
/// list (tolerances: settings.hpp). The message names the row.
std::vector<DrawnPiece> drawn_pieces(const StandardEntry& profile);

/// Does the same with the text of a table and the text of the polynomials.
std::vector<DrawnPiece> pieces_of_table(std::string_view table, std::string_view polynomials,
                                        std::string_view profile);

/// The piece as curves: one, or several short ones of a polynomial.
std::vector<CurvePiece> curves_of(const DrawnPiece& piece);

/// z of a polynomial piece or of a line at y.
double height_at(const DrawnPiece& piece, double y);

} // namespace bem_contact
