#pragma once

#include "bem_contact/sequence/plan/contact_case.hpp"
#include "bem_contact/sequence/scene_result.hpp"

namespace bem_contact {

/// Adds the stresses below the surface that the scene asks for to its certified result, of the half-space and
/// of the real bodies. A warning says where the half-space's are an approximation and nothing better is
/// there. Throws InputError for too many points, and for points that an influence file does not reach.
void add_stresses(const ContactCase& asked, SceneResult& out);

} // namespace bem_contact
