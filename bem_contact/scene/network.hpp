#pragma once

#include "bem_contact/scene/scene_file.hpp"

#include <optional>
#include <string>

namespace bem_contact {

/// What the railways of a network have in common: defaults of the keys of [position] with the same names.
struct NetworkTrack {
  double gauge = 0, gauge_height = 0; ///< mm
  double back_to_back = 0;            ///< mm
  /// mm; nothing where no source confirms one: a wheel that is no standard then needs the key.
  std::optional<double> tape_circle = {};
  double rail_inclination = 0; ///< rad
  std::string_view sources;    ///< of all that
};

/// Returns what a network has.
const NetworkTrack& track_of(Network network);

/// Gives [position] the values of track.network where the file gives none. Throws InputError where a wheel
/// needs a tape circle that the network does not have.
void set_network(SceneFile& file, const Schema& schema);

/// Where wheels and rails stand, in one line: "track: UIC, gauge ..., rail inclined by 1:40". "" of a patch.
std::string track_text(const SceneFile& scene);

} // namespace bem_contact
