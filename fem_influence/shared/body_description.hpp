#pragma once

#include "bem_contact/influence/influence_function.hpp"
#include "bem_contact/profile/bodies/body_file.hpp"
#include "bem_contact/profile/profile_curve.hpp"

#include <filesystem>
#include <vector>

/// What both methods take from a body file.
namespace bem_contact::fem {

/// The stations of the strip, ascending in s. Throws InputError where the strip leaves the curve.
std::vector<Station> make_stations(const BodyFile::Strip& strip, const ProfileCurve& curve);

/// What an influence function says of the body: names, material, invariance, stations. It has no numbers yet,
/// and the caller says how the body is held and by which method the numbers are made. Throws as
/// make_stations() does.
InfluenceFunction describe(const BodyFile& body, const ProfileCurve& curve);

/// A mesh of mesh_body says at its end which body file it was made from; other meshes say nothing. Throws
/// InputError if it was made from another one, if a byte of it was changed since, and for one of mesh_body
/// that was cut off: the edges that it lists before this end would be straight.
void require_mesh_of(const BodyFile& body, const ProfileCurve& curve, const std::filesystem::path& mesh);

} // namespace bem_contact::fem
