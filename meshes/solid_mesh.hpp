#pragma once

#include "meshes/quad_mesh.hpp"

#include <array>
#include <string>
#include <vector>

namespace bem_contact::meshes {

/// Physical surface, beside those of Group, of the planes the body is mirrored at; the volume is
/// `body_group`.
inline constexpr int symmetry_group = 4;

/// A point of the 3-D body in the track frame: x along, y to the right, z down, mm.
struct Point3 {
  double x = 0, y = 0, z = 0;
};

/// A face of the surface and its physical group.
struct SurfaceFace {
  std::array<int, 4> vertices{};
  int group = 0;
};

/// Half of a body (x >= 0) in first-order hexahedra: the section's quadrilaterals, swept.
struct SolidMesh {
  std::string name;        ///< of the body
  std::string body_digest; ///< mesh_digest() of the body file
  QuadMesh section;
  std::vector<double> layers; ///< where the sections lie: x, or R_ref theta, ascending from 0, mm
  std::vector<Point3> points; ///< section by section
  std::vector<std::array<int, 8>> hexahedra;
  std::vector<SurfaceFace> faces; ///< the whole surface
};

/// The 3-D body, for loads on the strip near x = 0: a prism extruded from x = 0 to harmonic.half_period, a
/// body of revolution swept round its axle from theta = 0 to pi; both ends are mirror planes, so that the
/// body is the one that the Fourier series of the harmonic method describes. On the strip, edges are as many
/// whole stations long (a power of two of them) as solid.size allows: halving them again and again ends at
/// the stations' borders, as halving the first layer does at dx / 2. To that end the group `contact` may
/// reach a few stations beyond the strip. Away from the strip and along x elements grow by mesh.grading.
/// Throws InputError as mesh_section does.
SolidMesh mesh_solid(const BodyFile& body);

} // namespace bem_contact::meshes
