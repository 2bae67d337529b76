#pragma once

#include "bem_contact/profile/profile_curve.hpp"

#include <filesystem>
#include <span>
#include <vector>

namespace bem_contact::fem {

/// A circle's arc of less than half of it.
struct Arc {
  Point2 from, to, centre;
  double radius = 0;
};

/// The curved edges of a section's outline, which first-order elements know as chords: those along the
/// profile, and the arcs that mesh_body names in the comments of its meshes (none in other meshes: what lies
/// off the profile stays a polygon there).
class CurvedOutline {
public:
  enum class Edge { straight, profile, arc };

  CurvedOutline(ProfileCurve curve, const std::filesystem::path& mesh);

  const ProfileCurve& curve() const { return curve_; }
  /// What the chord from a to b stands for.
  Edge edge(Point2 a, Point2 b) const;
  /// Mean of points on such an edge, and on it; weights add up to 1. On the profile: mean in arc length. On
  /// an arc: mean in angle and radius, on the arc nearest to the middle of first and last. Else: as they
  /// come.
  Point2 mean(Edge edge, std::span<const Point2> points, std::span<const double> weights) const;

private:
  Point2 mean_on_profile(std::span<const Point2> points, std::span<const double> weights) const;
  Point2 mean_on_arc(std::span<const Point2> points, std::span<const double> weights) const;
  bool along_profile(Point2 a, Point2 b) const;

  ProfileCurve curve_;
  std::vector<Arc> arcs_;
};

} // namespace bem_contact::fem
