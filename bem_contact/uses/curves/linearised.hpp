#pragma once

#include "bem_contact/scene/scene_file.hpp"
#include "bem_contact/sequence/numbers/sequence_files.hpp"
#include "bem_contact/uses/curves/creep_state.hpp"

#include <optional>

namespace bem_contact {

/// Derivatives of the forces at a solution, from the linear system of its tangential problem with the
/// pressure held (contact/shear_sensitivity.hpp): no further solution is needed. Where the pressure moves
/// with the shear tractions, as between unlike materials or on inclined surfaces, differences of solutions
/// have this part too. `scene` is that of the result, with creepages as numbers; `steps`: of its creepages,
/// over which the change of the rigid slip is taken. Nothing for Hertz's model, and where structures move the
/// bodies.
std::optional<CreepMatrix> linearised_sensitivities(const SceneFile& scene, const SceneResult& result,
                                                    const Creepages& steps, SequenceFiles& files);

} // namespace bem_contact
