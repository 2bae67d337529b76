#pragma once

#include "bem_contact/record/record.hpp"

#include <filesystem>

namespace bem_contact::report {

/// What a page shows of a mesh that mesh_body wrote (gmsh 4.1 as text): "points" [y, z] in mm, "quads" (their
/// four points, from 0) and "edges" by group, as "contact" and "held". Throws InputError for any other file,
/// a 3-D mesh included.
record::Record mesh_data(const std::filesystem::path& file);

} // namespace bem_contact::report
