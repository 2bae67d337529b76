#include "bem_contact/profile/standards/standard_tables.hpp"

#include "bem_contact/base/conventions.hpp"
#include "bem_contact/base/error.hpp"
#include "bem_contact/base/number_text.hpp"
#include "bem_contact/profile/settings.hpp"
#include "bem_contact/profile/standards/standard_files.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <numbers>
#include <optional>

namespace bem_contact {

namespace {

using Fields = std::vector<std::string_view>;

Fields split(std::string_view text, char at) {
  Fields fields;
  while (true) {
    const auto end = text.find(at);
    fields.push_back(text.substr(0, end));
    if (end == std::string_view::npos)
      return fields;
    text.remove_prefix(end + 1);
  }
}

[[noreturn]] void refuse_row(std::string_view profile, std::size_t row, const std::string& why) {
  throw Error(fmt::format("The table of the standard profile {} is damaged", profile),
              fmt::format("its row {} {}", row, why), "Correct data/standards and build again.");
}

/// One row of a table of pieces, as it stands there.
struct PieceRow {
  DrawnPiece piece;
  std::optional<Point2> centre;
  double kink = 0; ///< where it begins, rad
};

/// The rows of one profile alone are read: a program that starts needs two of fifty.
class TableReader {
public:
  TableReader(std::string_view table, std::string_view polynomials, std::string_view profile)
      : table_(table), polynomials_(polynomials), profile_(profile) {}

  std::vector<PieceRow> rows() {
    std::vector<PieceRow> out;
    for (const std::string_view line : split(table_, '\n')) {
      if (!line.starts_with(profile_) || !line.substr(profile_.size()).starts_with(','))
        continue;
      ++row_;
      out.push_back(row_of(split(line, ',')));
    }
    return out;
  }

private:
  PieceRow row_of(const Fields& fields) const {
    constexpr std::size_t columns = 10; // profile,piece,y0,z0,y1,z1,radius,centre_y,centre_z,kink
    if (fields.size() != columns)
      refuse_row(profile_, row_, fmt::format("has {} columns, not {}", fields.size(), columns));
    PieceRow out;
    out.piece.from = {number(fields[2]), number(fields[3])};
    out.piece.to = {number(fields[4]), number(fields[5])};
    if (fields[1] == "arc") {
      out.piece.radius = number(fields[6]);
      out.centre = Point2{number(fields[7]), number(fields[8])};
    } else if (fields[1] != "line") {
      out.piece.polynomial = polynomial(fields[1]);
    }
    if (!fields[9].empty())
      out.kink = number(fields[9]) * std::numbers::pi / 180;
    return out;
  }

  double number(std::string_view text) const {
    const std::optional<double> value = number_of_text(text);
    if (!value)
      refuse_row(profile_, row_, fmt::format("has '{}' where a number belongs", text));
    return *value;
  }

  std::vector<double> polynomial(std::string_view name) const {
    std::vector<double> coefficients;
    for (const std::string_view line : split(polynomials_, '\n'))
      if (const Fields fields = split(line, ','); fields.size() == 3 && fields[0] == name)
        coefficients.push_back(number(fields[2]));
    if (coefficients.empty() || coefficients.size() > CurvePiece::max_degree + 1)
      refuse_row(profile_, row_,
                 fmt::format("is neither line nor arc, and '{}' is no polynomial of degree 0 to {}", name,
                             CurvePiece::max_degree));
    return coefficients;
  }

  std::string_view table_, polynomials_, profile_;
  std::size_t row_ = 0;
};

void require_ends_on_it(std::string_view profile, std::size_t row, const PieceRow& given) {
  const auto& [from, to, radius, polynomial, shift] = given.piece;
  for (const Point2 end : {from, to}) {
    double off = 0;
    if (given.centre)
      off = std::abs(norm(end - *given.centre) - std::abs(radius));
    else if (!polynomial.empty())
      off = std::abs(height_at(given.piece, end.y) - end.z);
    if (!(off <= joint_tolerance))
      refuse_row(profile, row, fmt::format("ends at ({}, {}), {:.2g} mm off its curve", end.y, end.z, off));
  }
  if (!(norm(to - from) > joint_tolerance) || norm(to - from) > 2 * std::abs(radius) + (radius == 0) * 1e9)
    refuse_row(profile, row, "has no length, or is longer than its circle is wide");
}

PiecePoint end_of(const CurvePiece& curve) {
  return point_on(curve, curve.length);
}

void require_joint(std::string_view profile, std::size_t row, const DrawnPiece& before,
                   const PieceRow& given) {
  if (const double gap = norm(given.piece.from - before.to); !(gap <= joint_tolerance))
    refuse_row(profile, row, fmt::format("begins {:.2g} mm from the end of the piece before", gap));
  const double turn = std::remainder(
      curves_of(given.piece).front().delta0 - end_of(curves_of(before).back()).delta, 2 * std::numbers::pi);
  if (!(std::abs(turn - given.kink) <= kink_tolerance))
    refuse_row(profile, row,
               fmt::format("begins with a kink of {:.3f} degrees, and the table lists one of {:.3f}",
                           degrees(turn), degrees(given.kink)));
}

} // namespace

std::span<const StandardEntry> standard_entries() {
  static const std::vector<StandardEntry> all = [] {
    std::vector<StandardEntry> out;
    for (const std::string_view line : split(standard_file("profiles.csv"), '\n')) {
      const Fields f = split(line, ',');
      if (line.starts_with('#') || f.size() != 8 || f[0] == "name")
        continue;
      using Part = StandardEntry::Part;
      StandardEntry& entry = out.emplace_back();
      entry.name = f[0];
      entry.kind = f[1] == "wheel" ? ProfileKind::wheel : ProfileKind::rail;
      entry.part = f[2] == "section" ? Part::section : f[2] == "head" ? Part::head : Part::curve;
      entry.table = f[3];
      entry.usual = f[4] == "yes";
      entry.standard = f[5];
      if (!f[6].empty())
        for (const std::string_view other : split(f[6], ';'))
          entry.other_names.emplace_back(other);
      entry.remark = f[7];
    }
    return out;
  }();
  return all;
}

std::vector<DrawnPiece> pieces_of_table(std::string_view table, std::string_view polynomials,
                                        std::string_view profile) {
  const std::vector<PieceRow> rows = TableReader(table, polynomials, profile).rows();
  if (rows.empty())
    refuse_row(profile, 1, "is missing");
  std::vector<DrawnPiece> pieces;
  for (const PieceRow& row : rows) {
    require_ends_on_it(profile, pieces.size() + 1, row);
    if (!pieces.empty())
      require_joint(profile, pieces.size() + 1, pieces.back(), row);
    pieces.push_back(row.piece);
  }
  return pieces;
}

std::vector<DrawnPiece> drawn_pieces(const StandardEntry& profile) {
  return pieces_of_table(standard_file(profile.table), standard_file("polynomials.csv"), profile.name);
}

double height_at(const DrawnPiece& piece, double y) {
  if (piece.polynomial.empty()) {
    const Point2 along = piece.to - piece.from;
    return piece.from.z + along.z * (y - piece.from.y) / along.y;
  }
  long double z = 0;
  for (std::size_t k = piece.polynomial.size(); k-- > 0;)
    z = z * (y - piece.shift) + piece.polynomial[k];
  return static_cast<double>(z);
}

std::vector<CurvePiece> curves_of(const DrawnPiece& piece) {
  if (piece.polynomial.empty())
    return {arc_piece(piece.from, piece.to, piece.radius == 0 ? 0 : 1 / piece.radius)};
  // Pieces of at most polynomial_piece_length, each about its own start: (y, z) = (y0 +- t, z(y0 +- t)).
  const double width = piece.to.y - piece.from.y, sign = width > 0 ? 1 : -1;
  const int count = static_cast<int>(std::ceil(std::abs(width) / polynomial_piece_length));
  std::vector<CurvePiece> pieces;
  for (int i = 0; i < count; ++i) {
    const double y0 = piece.from.y + width * i / count, y1 = piece.from.y + width * (i + 1) / count;
    std::array<long double, CurvePiece::max_degree + 1> c{};
    std::copy(piece.polynomial.begin(), piece.polynomial.end(), c.begin());
    // Taylor shift to y0 by repeated synthetic division; in long double, zone C of S1002 cancels four digits.
    for (std::size_t k = 0; k < c.size(); ++k)
      for (std::size_t j = c.size() - 1; j-- > k;)
        c[j] += c[j + 1] * static_cast<long double>(y0 - piece.shift);
    std::array<double, c.size()> z{};
    for (std::size_t k = 0; k < c.size(); ++k)
      z[k] = static_cast<double>(k % 2 == 0 ? c[k] : sign * c[k]);
    pieces.push_back(polynomial_piece(std::array<double, 2>{y0, sign}, z, std::abs(y1 - y0)));
  }
  return pieces;
}

} // namespace bem_contact
