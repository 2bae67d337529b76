#pragma once

#include "bem_contact/influence/influence_function.hpp"
#include "bem_contact/scene/patch_scene.hpp"
#include "bem_contact/scene/scene_file.hpp"

#include <memory>

namespace bem_contact {

/// The influence files of both bodies, where the scene names both.
struct PairFiles {
  std::shared_ptr<const InfluenceFunction> rail, wheel; ///< shared by the cases of a sequence

  bool complete() const { return rail && wheel; }
};

/// Reads the influence files that the scene names and checks their materials.
/// Throws InputError for a file that cannot be used (influence_file.hpp).
PairFiles read_pair_files(const SceneFile& scene);

/// Half-space numbers of the pair on the grid of `contact`; on a curved strip those of the strip unrolled
/// (distances along the arc), so that both models share geometry, gap and frames.
InfluenceNumbers halfspace_pair(const SceneFile& scene, const PreparedContact& contact);

/// Tangent-plane numbers of the pair (halfspace/tangent_plane.hpp), both surfaces taken where the rows lie.
InfluenceNumbers tangent_plane_pair(const SceneFile& scene, const PreparedContact& contact);

/// The pair's numbers from the influence files at the rows' own stations on either body.
/// Throws InputError where a file is missing or a row lies outside its strip.
InfluenceNumbers fem_pair(const SceneFile& scene, const PairFiles& files, const PreparedContact& contact);

/// Throws InputError unless the strip of either file covers every row.
void require_strips(const PairFiles& files, const PreparedContact& contact);
/// First and last row that lie on both strips; first > last where none does.
std::pair<int, int> covered_rows(const PairFiles& files, const PreparedContact& contact);

} // namespace bem_contact
