#pragma once

#include "bem_contact/base/conventions.hpp"
#include "bem_contact/profile/curve_piece.hpp"
#include "bem_contact/profile/settings.hpp"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace bem_contact {

/// A point of a profile curve. `delta` is continuous along the curve (unwrapped).
struct CurvePoint {
  double s = 0;         ///< arc length, mm
  Point2 position;      ///< (y, z), mm, in the profile's own frame
  double delta = 0;     ///< inclination of the tangent, rad
  double curvature = 0; ///< d(delta)/ds, 1/mm; positive where the body is convex (1/R on a disc)
};

/// A profile as one arc-length curve in the section's own frame (y, z): y to the right (field side of a
/// right-hand rail or wheel), z down.
///
/// It is walked so that the material lies on the side of e_n = (-sin delta, cos delta):
/// a rail from the gauge side (-y) to the field side (+y), delta = 0 on the top;
/// a wheel from the field side (+y) to the flange back (-y), delta near pi on the tread.
/// s = 0 is at y = 0 (rail top centre, wheel tape circle) where the curve passes y = 0, else at its start.
class ProfileCurve {
public:
  /// A curve of pieces in walking order. Each piece is translated to the end of the one before it, so that
  /// the curve is continuous in position while tangent and curvature stay what the pieces say.
  static ProfileCurve from_pieces(std::string name, std::vector<CurvePiece> pieces);

  /// A curve through points: an interpolating cubic spline (spline.hpp). A corner stays where the chords turn
  /// by more than `corner_turn` (rad) and by more than twice as much as at both neighbours, so that a
  /// coarsely sampled arc gets no corners. Points are in the walking order given above. Throws InputError for
  /// fewer than 3 points, NaN, or doubled points.
  static ProfileCurve through_points(std::string name, std::span<const Point2> points,
                                     double corner_turn = corner_angle);
  /// Does the same with corners at the points of these indices, in rising order, and nowhere else.
  static ProfileCurve through_points(std::string name, std::span<const Point2> points,
                                     std::span<const std::size_t> corners);

  const std::string& name() const { return name_; }
  double s_begin() const { return s_begin_; }
  double s_end() const { return s_end_; }

  /// Arc lengths where pieces begin, and s_end(): tangent and curvature may jump there, and nowhere else.
  std::vector<double> joints() const;

  /// Position, tangent and curvature at arc length s; at a joint those of the piece that begins. Throws
  /// InputError when s is off the curve by more than 1e-9 mm.
  CurvePoint at(double s) const;

  /// The point of the curve nearest to `p` (global search, then Newton to 1e-12 mm).
  CurvePoint nearest(Point2 p) const;

  /// 64-bit digest of the geometry (positions to 1e-6 mm at 256 equal steps); tells one profile from another.
  std::uint64_t digest() const;

private:
  ProfileCurve() = default;
  const CurvePiece& piece_at(double s) const;

  std::string name_;
  double s_begin_ = 0, s_end_ = 0;
  std::vector<CurvePiece> pieces_; ///< in walking order, at least one
};

/// Points from end to end at equal steps of arc length, at most `step` mm long.
std::vector<CurvePoint> points_along(const ProfileCurve& curve, double step);

} // namespace bem_contact
