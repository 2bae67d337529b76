#pragma once

#include "bem_contact/scene/scene_file.hpp"

#include <optional>
#include <span>
#include <string_view>

namespace bem_contact {

/// What lies between the surfaces in one state of them, as somebody measured it. Empty: the source does not
/// say.
struct SurfaceState {
  std::string_view name;
  double compliance;                                           ///< of the layer under shear, mm^3/N; 0: none
  std::optional<double> yield_shear, hardening;                ///< MPa, MPa/mm
  std::optional<double> friction, falling, half_slip_velocity; ///< 1, 1, mm/s
  std::string_view source, range;                              ///< who, and for what it holds
};

std::span<const SurfaceState> surface_states();
/// Null where no state has this name.
const SurfaceState* find_state(std::string_view name);

/// Gives a scene with layer.state what this state says, but for what its own keys say. `schema`: as read.
/// Friction that falls needs motion.speed. Throws InputError for a name that is none.
void apply_state(SceneFile& scene, const Schema& schema);

} // namespace bem_contact
