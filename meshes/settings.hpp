#pragma once

#include "bem_contact/base/tuned.hpp"

#include <numbers>

/// The tuned numbers of this room (base/tuned.hpp).
namespace bem_contact::meshes {

// Quality of a mesh.

/// 1 (as above). Below this the program warns. Chosen: good meshes of all shipped bodies are above 0.3.
BEM_CONTACT_TUNED(double, poor_quality, 0.2);

// Outlines and element sizes.

/// rad. An edge of the 2-D mesh on an arc turns by at most so much: 48 edges on a circle.
BEM_CONTACT_TUNED(double, fine_edge_angle, 7.5 * std::numbers::pi / 180);
/// rad. Pieces that meet at a larger angle form a corner, where the mesh needs a vertex. Twice an edge's
/// turn.
BEM_CONTACT_TUNED(double, corner, 15 * std::numbers::pi / 180);
/// 1 (share of a piece's parameter). Tangents at the ends of a piece are taken over this.
BEM_CONTACT_TUNED(double, tangent_step, 1e-5);
/// 1. A place asks for a size only if the field allows more than this many times as much there; otherwise its
/// neighbours have asked already.
BEM_CONTACT_TUNED(double, size_excess, 1.15);

/// mm. Points of an outline that are nearer coincide: rounding.
BEM_CONTACT_TUNED(double, coinciding, 1e-9);

// Sections.

/// mm. How far the strip of a coarse mesh may reach beyond its profile, and the shortest rest of a profile:
/// rounding.
BEM_CONTACT_TUNED(double, profile_slack, 1e-9);
/// 1. Points a piece for the area of a section: to about 1e-7 of it.
BEM_CONTACT_TUNED(int, area_samples, 4000);

// Solid meshes. Coarse away from the load, because fem_influence refines where accuracy is wanted.

/// 1. Gradings that are tried for the coarse section, the coarsest first.
inline constexpr double coarse_gradings[] = {0.8, 0.65, 0.5};

} // namespace bem_contact::meshes
