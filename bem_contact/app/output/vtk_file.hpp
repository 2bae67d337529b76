#pragma once

#include "bem_contact/sequence/scene_result.hpp"

#include <filesystem>

namespace bem_contact::app {

/// How such a file begins.
inline constexpr const char* surface_begin = "<?xml version=\"1.0\"?>\n<!-- bem_contact, model ";

/// Writes the rail's surface in space with pressure, traction (vector), state, slip and undeformed distance
/// on its elements: a VTK XML StructuredGrid in ASCII, which ParaView opens. The frame is the project's: z is
/// down, so turn the view by 180 degrees about x. Throws what write_whole() does (base/output_file.hpp).
void write_vts(const std::filesystem::path& file, const SceneResult& result);

} // namespace bem_contact::app
