#pragma once

#include "meshes/outline.hpp"

#include <string>

namespace bem_contact::meshes {

/// Throws InputError when edges of the outline cross or touch each other, or a hole is not within the body.
void refuse_crossings(const Outline& outline, const std::string& name);

} // namespace bem_contact::meshes
