#pragma once

#include "bem_contact/influence/influence_file.hpp"
#include "bem_contact/influence/influence_numbers.hpp"
#include "bem_contact/scene/contact_setup.hpp"
#include "bem_contact/sequence/numbers/numbers_store.hpp"

#include <memory>
#include <utility>
#include <vector>

namespace bem_contact {

/// The influence files of both bodies, where the scene names both.
struct PairFiles {
  std::shared_ptr<InfluenceFile> rail, wheel; ///< shared by the cases of a sequence

  bool complete() const { return rail && wheel; }
};

/// Opens the influence files that the bodies name and checks their materials.
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

/// Throws InputError unless the strip of either file covers every row of width ds at these stations, mm.
void require_strips(const PairFiles& files, double ds, const std::vector<double>& rail_s,
                    const std::vector<double>& wheel_s);
/// First and last row that lie on both strips; first > last where none does.
std::pair<int, int> covered_rows(const PairFiles& files, double ds, const std::vector<double>& rail_s,
                                 const std::vector<double>& wheel_s);

} // namespace bem_contact
