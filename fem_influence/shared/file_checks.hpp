#pragma once

#include "bem_contact/profile/body_file.hpp"
#include "bem_contact/profile/profile_curve.hpp"

#include <filesystem>

namespace bem_contact::fem {

/// A mesh of mesh_body says at its end which body file it was made from; other meshes say nothing. Throws
/// InputError if it was made from another one.
void require_mesh_of(const BodyFile& body, const ProfileCurve& curve, const std::filesystem::path& mesh);

} // namespace bem_contact::fem
