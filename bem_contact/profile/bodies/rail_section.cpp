#include "bem_contact/profile/bodies/rail_section.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/profile/standard_profiles.hpp"
#include "bem_contact/profile/standards/standard_tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>

namespace bem_contact {

namespace {

const StandardEntry& rail_entry(std::string_view name) {
  const StandardEntry* entry = find_standard(name);
  if (entry == nullptr || entry->kind != ProfileKind::rail)
    throw InputError(fmt::format("Unknown rail '{}'", name), "no table of a standard has it",
                     advice_on_name(name, ProfileKind::rail));
  return *entry;
}

} // namespace

std::vector<SectionPiece> rail_section(std::string_view name) {
  const StandardEntry& entry = rail_entry(name);
  if (entry.part != StandardEntry::Part::section)
    throw InputError(fmt::format("The web and the foot of rail {} are not known", entry.name),
                     "its table has the running surface alone",
                     "Take a rail whose whole section is known, as 60E1.");
  std::vector<SectionPiece> pieces;
  for (const DrawnPiece& piece : drawn_pieces(entry))
    pieces.push_back({pieces.empty() ? piece.from : pieces.back().to, piece.to, piece.radius});
  return pieces;
}

std::vector<SectionPiece> rail_head(std::string_view name) {
  std::vector<SectionPiece> pieces = rail_section(name);
  const auto flank = std::ranges::find(pieces, 0.0, &SectionPiece::radius); // the first line
  pieces.erase(flank + 1, pieces.end());
  return pieces;
}

CurvePiece curve_of(const SectionPiece& piece) {
  return arc_piece(piece.from, piece.to, piece.radius == 0 ? 0 : 1 / piece.radius);
}

} // namespace bem_contact
