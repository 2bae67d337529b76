#pragma once

#include "bem_contact/base/conventions.hpp"

#include <array>
#include <span>

namespace bem_contact {

/// One smooth piece of a profile curve: a circular arc (a line is an arc of curvature 0), or a parametric
/// polynomial (y(t), z(t)), 0 <= t <= t_end, with dy^2 + dz^2 > 0. Lengths are measured from its start.
struct CurvePiece {
  enum class Kind : unsigned char { arc, polynomial };
  static constexpr int max_degree = 8;

  Kind kind = Kind::arc;
  double s0 = 0;        ///< arc length of its start on the whole curve, mm
  double length = 0;    ///< mm
  Point2 start;         ///< mm; for a polynomial (y[0], z[0])
  double delta0 = 0;    ///< inclination at its start, rad
  double curvature = 0; ///< of an arc: d(delta)/ds, 1/mm
  double t_end = 0;
  int degree = 0;
  std::array<double, max_degree + 1> y{}, z{}; ///< coefficients of t^0, t^1, ...
  Point2 middle; ///< its middle, for the bound |p - piece| >= |p - middle| - length/2
};

/// Straight from `from` to `to`.
CurvePiece line_piece(Point2 from, Point2 to);
/// The arc shorter than half a circle between two points; `curvature` is +1/R (convex: delta grows) or -1/R.
CurvePiece arc_piece(Point2 from, Point2 to, double curvature);
/// The arc that leaves `from` at inclination `delta`.
CurvePiece arc_piece(Point2 from, double delta, double curvature, double length);
/// Coefficients of t^0, t^1, ... up to degree 8.
CurvePiece polynomial_piece(std::span<const double> y, std::span<const double> z, double t_end);

struct PiecePoint {
  Point2 position;
  double delta = 0;
  double curvature = 0;
};

/// Returns the point at the length `along` from the start of the piece (clamped to it).
PiecePoint point_on(const CurvePiece& piece, double along);

/// The length along the piece of its point nearest to `p`.
double nearest_on(const CurvePiece& piece, Point2 p);

} // namespace bem_contact
