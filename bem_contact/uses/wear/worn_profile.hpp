#pragma once

#include "bem_contact/profile/profile_curve.hpp"
#include "bem_contact/uses/wear/wear_of_result.hpp"

#include <filesystem>
#include <span>
#include <utility>
#include <vector>

namespace bem_contact::wear {

/// What has become of one profile.
struct WornBody {
  std::vector<Point2> points; ///< in walking order; own frame, mm
  std::vector<double> depth;  ///< taken off at each point so far, along the normals, mm
  double area = 0;            ///< gone from the section so far, mm^2: volume by length of the body

  double largest() const; ///< of the depths, mm; 0 without points
};

/// A profile as points in walking order, about profile_spacing apart; its own frame, mm.
std::vector<Point2> points_of(const ProfileCurve& curve);

/// Depths of several contacts on one body, each times its weight, at the points of a profile.
class Depths {
public:
  explicit Depths(std::span<const Point2> points);

  /// Spreads the depth of each row, which is constant over its width, over the points near it by a cubic
  /// B-spline. This is smoothing that keeps the volume exactly, and no point grows. (A smoothing spline
  /// through the worn points would keep it too, but overshoots beside a worn band, and would smooth the
  /// unworn shape at every step.) `smoothing`: waves shorter than this are removed, mm; 0: only those that
  /// the points do not show.
  void add(const DepthOverS& wear, double weight, double smoothing);

  const std::vector<double>& values() const { return depth_; } ///< mm, one a point
  double largest() const;                                      ///< mm
  double area() const;                                         ///< mm^2
  /// How much of the deepest place of the rows smoothing took, over its depth. 0 where nothing wears.
  double smoothed_off() const;

private:
  /// The depths of one contact, times its weight, over rising s.
  struct Contact {
    std::vector<std::pair<double, double>> rows; ///< s and depth, mm
    double at(double s) const;                   ///< linear between rows, 0 beyond them
  };

  std::vector<double> s_, length_, depth_;
  std::vector<Contact> contacts_;
};

/// The points moved along their normals into the body by the depths times a factor near 1, such that the
/// area between the two polygons is the area of the depths: on a curved profile it would else be smaller or
/// larger by depth times curvature / 2.
std::vector<Point2> worn(std::span<const Point2> points, const std::vector<double>& depth, double area);

/// Two columns y z, as scenes read them with profile_z = "down"; whole or not at all.
void write_profile(const std::filesystem::path& file, std::span<const Point2> points);

} // namespace bem_contact::wear
