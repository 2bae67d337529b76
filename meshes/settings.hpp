#pragma once

#include "bem_contact/base/tuned.hpp"

#include <numbers>

/// The tuned numbers of this room (base/tuned.hpp).
namespace bem_contact::meshes {

// Quality of a mesh.

/// 1 (smallest scaled Jacobian). A worse mesh is refused: its elements are nearly folded. Chosen.
BEM_CONTACT_TUNED(double, refused_quality, 0.05);
/// 1 (as above). Below this the program warns. Chosen: good meshes of all shipped bodies are above .3.
BEM_CONTACT_TUNED(double, poor_quality, 0.2);
/// 1. Sweeps that move the vertices inside a mesh. Later ones no longer change the worst quad. Chosen.
BEM_CONTACT_TUNED(int, smoothing_sweeps, 10);
/// 1 (scaled Jacobian). Vertices of quads below it also try places to all sides.
BEM_CONTACT_TUNED(double, mediocre_quality, 0.6);
/// 1 (scaled Jacobian). A vertex moves only where it gains more: rounding.
BEM_CONTACT_TUNED(double, least_gain, 1e-6);
/// mm. How far a vertex of the strip may be off the profile: rounding of an arc length.
BEM_CONTACT_TUNED(double, strip_slack, 1e-9);
/// 1 (share of the area). How far the quads' area may be off that of the outline: rounding.
BEM_CONTACT_TUNED(double, area_slack, 1e-9);

// Outlines and element sizes.

/// rad. An edge of the 2-D mesh on an arc turns by at most so much: 48 edges on a circle.
BEM_CONTACT_TUNED(double, fine_edge_angle, 7.5 * std::numbers::pi / 180);
/// rad. Pieces that meet at a larger angle form a corner, where the mesh needs a vertex. Twice an edge's
/// turn.
BEM_CONTACT_TUNED(double, corner, 15 * std::numbers::pi / 180);
/// 1 (share of a piece's parameter). Tangents at the ends of a piece are taken over this.
BEM_CONTACT_TUNED(double, tangent_step, 1e-5);
/// mm. Distance of the points in which an outline is sampled, far below any element's size.
BEM_CONTACT_TUNED(double, outline_step, 0.1);
BEM_CONTACT_TUNED(int, least_outline_samples, 64);  ///< 1. Of a piece, at least,
BEM_CONTACT_TUNED(int, most_outline_samples, 4000); ///< 1. and at most.
/// mm. Curvature of the outline is the turn over this to both sides: it smooths the noise of measured points.
BEM_CONTACT_TUNED(double, curvature_reach, 0.25);
/// 1. Sizes of the size field are rounded down to powers of this, so that few square roots are needed.
BEM_CONTACT_TUNED(double, level_ratio, 1.05);
/// 1. A place asks for a size only if the field allows more than this many times as much there; otherwise its
/// neighbours have asked already.
BEM_CONTACT_TUNED(double, size_excess, 1.15);
/// mm. Distance of the places where the body's thickness is measured.
BEM_CONTACT_TUNED(double, ray_step, 0.5);
/// 1 (cosine between the sides). Only an opposite side counts as the other side of a thin part: the neighbour
/// at a corner is no reason for small elements.
BEM_CONTACT_TUNED(double, opposite_side, -0.8);
/// 1. Gmsh's element size over ours: two, because each cell is split in four, and .7, measured, because gmsh
/// makes triangles larger than it is asked to.
BEM_CONTACT_TUNED(double, coarse_factor, 2 * 0.7);

/// mm. Points of an outline that are nearer coincide: rounding.
BEM_CONTACT_TUNED(double, coinciding, 1e-9);
/// 1 (sine). A side that is this parallel to a ray is not hit by it.
BEM_CONTACT_TUNED(double, parallel_side, 1e-12);
/// 1. Sizes that differ by less, relatively, are the same level: rounding of a power.
BEM_CONTACT_TUNED(double, same_level, 1e-9);

// Sections.

/// mm. How far the strip of a coarse mesh may reach beyond its profile, and the shortest rest of a profile:
/// rounding.
BEM_CONTACT_TUNED(double, profile_slack, 1e-9);
/// 1 (share of its radius). Hole of a disc, which must be held somewhere. Its effect is removed as structure.
BEM_CONTACT_TUNED(double, hole_of_disc, 0.05);
/// 1 (share of half the foot's width). What is steep and nearer to the middle is web, what is farther the
/// edge of the foot.
BEM_CONTACT_TUNED(double, widest_web, 0.5);
/// 1. Points a piece for the area of a section: to about 1e-7 of it.
BEM_CONTACT_TUNED(int, area_samples, 4000);

// Grafts: a measured profile on the body of a standard. All chosen, on the worn profiles of tests/meshes.

BEM_CONTACT_TUNED(double, largest_joint_distance, 2.0); ///< mm. An end may lie so far off the body.
/// rad. Between the tangents there: a flank that ends beside the under-head fillet.
BEM_CONTACT_TUNED(double, largest_joint_slope, 0.7);
BEM_CONTACT_TUNED(double, shortest_blend, 4.0); ///< mm. A blend replaces at least so much of the outline,
BEM_CONTACT_TUNED(double, blend_ratio, 5.0);    ///< 1. and at least so many times the distance.
BEM_CONTACT_TUNED(double, largest_area_change, 0.3); ///< 1 (share of the section's area).
/// mm. Distance of the points of the outline among which the nearest one is looked for first.
BEM_CONTACT_TUNED(double, joint_step, 0.25);
BEM_CONTACT_TUNED(int, least_joint_samples, 32);  ///< 1. Of a piece, at least,
BEM_CONTACT_TUNED(int, most_joint_samples, 4000); ///< 1. and at most.
/// 1. Times that the bracket around the nearest point is shortened by a third: to the last bit.
BEM_CONTACT_TUNED(int, nearest_place_steps, 100);

// Where a graft lies. All chosen, on the worn profiles of tests/meshes.

/// 1 (share of the profile). Less unworn profile finds no place.
BEM_CONTACT_TUNED(double, least_grafted_share, 0.33);
/// 1. A second place with more than this share of the best one's is as good: then nobody can choose.
BEM_CONTACT_TUNED(double, rival_share, 0.9);
/// 1. How much a unit move of the unworn part is felt at right angles to the surface, squared, at least. On
/// less, an arc or a line, the body slides.
BEM_CONTACT_TUNED(double, least_stiffness, 0.004);
BEM_CONTACT_TUNED(int, graft_samples, 300); ///< 1. Points of the profile.

// Solid meshes. Coarse away from the load, because fem_influence refines where accuracy is wanted.

/// 1. Growth of the layers along x, over their distance from x = 0.
BEM_CONTACT_TUNED(double, layer_growth, 0.6);
/// 1. A last layer of less than this many steps is as long as what is left.
BEM_CONTACT_TUNED(double, last_layer, 1.5);
/// 1. Gradings that are tried for the coarse section, the coarsest first.
inline constexpr double coarse_gradings[] = {0.8, 0.65, 0.5};
/// 1 (smallest scaled Jacobian). A coarse section this good ends the attempts.
BEM_CONTACT_TUNED(double, good_quality, 0.3);
/// rad. Of one layer of a wheel at most, which is a straight hexahedron.
BEM_CONTACT_TUNED(double, widest_sector, 20 * std::numbers::pi / 180);

// Progress.

/// s. How often a mesh that takes longer says that it is still made. Chosen: a usual mesh takes one to five.
BEM_CONTACT_TUNED(double, sign_of_life, 10.0);

// Files.

/// 1 (share of the chord's square). An edge of the outline that bulges by less is straight.
BEM_CONTACT_TUNED(double, straight_edge, 1e-7);

} // namespace bem_contact::meshes
