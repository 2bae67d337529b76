#pragma once

#include "bem_contact/scene/scene_file.hpp"
#include "bem_contact/sequence/scene_result.hpp"

#include <functional>

namespace bem_contact {

/// The scene with its two bodies lowered as far as they sink under the wheel, and rigid.
///
/// Body i sinks by its share F_i of the vertical force over its stiffness, and its share falls as it sinks.
/// So the unknown is the difference of both depths, q: F_1(q) / k_1 - F_2(q) / k_2 = q has one solution,
/// which lies where one body bears all or between (Alefeld, Potra and Shi 1995). `solve`: of a scene with
/// rigid bodies. Throws what it throws.
SceneFile on_foundations(const SceneFile& scene, const std::function<SceneResult(const SceneFile&)>& solve);

} // namespace bem_contact
