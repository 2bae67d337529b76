#pragma once

#include "bem_contact/influence/influence_file.hpp"
#include "bem_contact/influence/influence_numbers.hpp"
#include "bem_contact/scene/contact_setup.hpp"
#include "bem_contact/sequence/numbers/numbers_store.hpp"
#include "bem_contact/sequence/numbers/section_blend.hpp"

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace bem_contact {

/// The influence files of both bodies, where the scene names both.
struct PairFiles {
  std::shared_ptr<InfluenceFile> rail, wheel; ///< shared by the cases of a sequence
  /// Of a rail of sections, instead of `rail`: as Body::sections lists them.
  std::vector<std::shared_ptr<InfluenceFile>> sections = {};

  bool of_rail() const { return rail || !sections.empty(); }
  bool complete() const { return of_rail() && wheel; }
  /// All that there are; one that serves several sections as often.
  std::vector<std::shared_ptr<InfluenceFile>> all() const;
};

/// Opens the influence files that the bodies name and checks their materials, and the profiles of sections.
/// Throws InputError for a file that cannot be used (influence_file.hpp).
PairFiles read_pair_files(const Body& rail, const Body& wheel);

/// Half-space numbers of the pair on the grid of `contact`; on a curved strip those of the strip unrolled
/// (distances along the arc), so that both models share geometry, gap and frames.
InfluenceNumbers halfspace_pair(const ContactSetup& setup, const ContactOnGrid& contact,
                                NumbersParts* known = nullptr);

/// Tangent-plane numbers of the pair (halfspace/tangent_plane.hpp), both surfaces taken where the rows lie.
InfluenceNumbers tangent_plane_pair(const ContactSetup& setup, const ContactOnGrid& contact,
                                    NumbersParts* known = nullptr);

/// Inclination of the rows against the wheel's axle, rad, where fem_pair() adds the wheel's radial
/// displacement: in steady rolling of a wheel on a rail with friction, unless the scene leaves it out. Else
/// empty.
std::vector<double> radial_inclination(const ContactSetup& setup, const std::vector<ContactRow>& rows);

/// The pair's numbers from the influence files at the rows' own stations on either body, with the wheel's
/// radial displacement where radial_inclination() is not empty. Throws InputError
/// where a file is missing or a row lies outside its strip.
InfluenceNumbers fem_pair(const ContactSetup& setup, const PairFiles& files, const ContactOnGrid& contact,
                          NumbersParts* known = nullptr, int threads = 1);

/// Rows on the strip of one influence file.
struct RowsOnStrip {
  std::shared_ptr<InfluenceFile> file;
  int first = 0;            ///< row
  std::vector<double> s;    ///< arc lengths on its strip, mm
  std::string section = {}; ///< which section of a rail it is, in words; "": the body has one profile
};
/// All that the rows need; where a file is not there nothing. Throws OffStripError where a rail of sections
/// has no files (section_blend()).
std::vector<RowsOnStrip> rows_on_files(const ContactSetup& setup, const PairFiles& files,
                                       const RowsOnBodies& rows, double ds);

/// section_blend(), where rows that lie beside a gap between two bodies and off the strip of a file belong to
/// the gap: a body's strip need not go down its side. No such row may bear.
SectionBlend blend_on_strips(const ContactSetup& setup, const PairFiles& files, const RowsOnBodies& rows,
                             double ds);

/// Throws OffStripError unless all strips cover every row of width ds, mm.
void require_strips(const std::vector<RowsOnStrip>& strips, double ds);
/// First and last of `rows` rows that lie on all of the strips; first > last where none does.
std::pair<int, int> covered_rows(const std::vector<RowsOnStrip>& strips, double ds, int rows);

} // namespace bem_contact
