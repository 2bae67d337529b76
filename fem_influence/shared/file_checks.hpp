#pragma once

#include "bem_contact/profile/body_file.hpp"
#include "bem_contact/profile/profile_curve.hpp"

#include <filesystem>

namespace bem_contact::fem {

/// Throws InputError where an output cannot be written: before the hours, not after.
void require_writable(const std::filesystem::path& output);
/// Meshes of mesh_body say at their end which body file they were made from (others say nothing): throws
/// InputError where it is another one.
void require_mesh_of(const BodyFile& body, const ProfileCurve& curve, const std::filesystem::path& mesh);

} // namespace bem_contact::fem
