#pragma once

#include "bem_contact/base/stopwatch.hpp"
#include "bem_contact/sequence/pair_numbers.hpp"
#include "bem_contact/sequence/scene_aids.hpp"
#include "bem_contact/sequence/wheel_rail_scene.hpp"

#include <optional>

namespace bem_contact {

/// A scene made ready: a contact that can be rebuilt on a larger grid (wheel_rail) or not (patch). Between
/// the parts of solve_scene() only.
struct Stage {
  const SceneFile* scene = nullptr;
  PairFiles files;
  std::optional<WheelRailScene> wheel_rail;
  PreparedContact contact;
  PhaseSeconds seconds;
  bool needs_strips = false; ///< every row must lie on the strips of the influence files
  SceneAids aids;
  bool grown = false; ///< the contact did not fit on the grid planned

  ReferencePoint reference() const {
    if (wheel_rail)
      return wheel_rail->reference;
    return {};
  }
};

/// `needs_strips`: throws InputError where rows that the contact needs leave the strips of the influence
/// files.
Stage prepare_stage(const SceneFile& scene, bool needs_strips, const SceneAids& aids = {});

/// How the one problem is loaded, for the other.
void take_load(ContactProblem& problem, const ContactProblem& from);

} // namespace bem_contact
