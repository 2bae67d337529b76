#pragma once

#include <array>
#include <cmath>
#include <numbers>

/// What is positive, said once for the whole project.
///
/// Units: mm, N, MPa, rad, s. Creepages are per unit of rolled distance, spin creepage is 1/mm.
///
/// Track frame (x, y, z): x the rolling direction, y to the right, z down; right-handed.
///
/// Contact frame (x, s, n) at a point of the rail's surface: the track frame turned about x by the
/// inclination delta,
///     e_s = (cos delta, sin delta),  e_n = (-sin delta, cos delta)   in (y, z),
/// so that s runs along the rail's profile and n points INTO the rail. On the top of the rail delta = 0 and
/// (x, s, n) = (x, y, z); at the gauge corner of a right-hand rail delta < 0.
///
/// Traction p: exerted by the wheel on the rail's surface, in the contact frame, MPa. p_n >= 0 is pressure.
/// Displacement difference u = u_wheel - u_rail. Its influence numbers A are positive definite with u = -A p.
/// Undeformed distance h along n (h > 0 apart), approach q > 0 moves the wheel towards the rail along z:
///     e = h - q cos(delta) - u_n = h - q cos(delta) + (A p)_n >= 0.
/// Rigid slip w: velocity of the wheel's surface over the rail's, over the rolling speed:
///     w_x = xi - phi s,  w_s = eta + phi x    on a plane (xi, eta, phi: creepage as Kalker defines it).
/// Slip S over one rolling step (rolled distance dx), mm. In steady rolling S = w dx - dx du/dx, because the
/// particle that is now at x was at x + dx one step ago (Kalker 1990, eq. 1.65 ff.; contact/slip_step.hpp
/// says how du/dx is taken). Results give S / dx, the slip per unit of rolled distance.
/// Friction drags the rail along with the wheel: p_t = +mu p_n S / |S|. Hence for small creepage
///     Fx = c^2 G C11 xi, Fy = c^2 G (C22 eta + c C23 phi), Mz = c^3 G (-C23 eta + c C33 phi):
/// the forces on the rail, opposite to Kalker's forces on the wheel.
/// Forces on the rail, dS the element's area, in the track frame (a patch given directly: in the frame of its
/// rows, profile/contact_row.hpp):
///     Fx = sum p_x dS, Fy = sum (p_s cos delta - p_n sin delta) dS,
///     Fz = sum (p_n cos delta + p_s sin delta) dS.
///
/// A body's own frame (x, s, n) has n INTO that body and is right-handed. For the rail it is the contact
/// frame. The wheel's is the contact frame turned by pi about x: (x, -s, -n).
namespace bem_contact {

/// Components of the contact frame, in the order of every array that has them.
enum Component : int { component_x = 0, component_s = 1, component_n = 2 };

/// Parity in x of an influence number A_ij(x): +1 even, -1 odd (odd when exactly one of i, j is
/// longitudinal).
constexpr int parity(int i, int j) {
  return (i == component_x) != (j == component_x) ? -1 : 1;
}

/// A point or vector of a cross-section (y, z), mm.
struct Point2 {
  double y = 0; ///< mm, to the right
  double z = 0; ///< mm, down

  bool operator==(const Point2&) const = default;
};

/// Sum.
constexpr Point2 operator+(Point2 a, Point2 b) {
  return {a.y + b.y, a.z + b.z};
}
/// Difference.
constexpr Point2 operator-(Point2 a, Point2 b) {
  return {a.y - b.y, a.z - b.z};
}
/// Multiple.
constexpr Point2 operator*(double c, Point2 a) {
  return {c * a.y, c * a.z};
}
/// Scalar product.
constexpr double dot(Point2 a, Point2 b) {
  return a.y * b.y + a.z * b.z;
}
/// The third component of a x b: above 0 where b is turned from a towards +z.
constexpr double cross(Point2 a, Point2 b) {
  return a.y * b.z - a.z * b.y;
}
/// Length.
inline double norm(Point2 a) {
  return std::hypot(a.y, a.z);
}

/// An angle in degrees, of rad.
constexpr double degrees(double angle) {
  return angle * 180 / std::numbers::pi;
}
/// Angle from a to b, rad, in (-pi, pi]: above 0 where b is turned from a towards +z.
inline double angle_from_to(Point2 a, Point2 b) {
  return std::atan2(cross(a, b), dot(a, b));
}
/// Turns points about the origin by one angle, rad, from +y towards +z.
class Turn {
public:
  /// Takes sine and cosine once.
  explicit Turn(double angle) : cosine_(std::cos(angle)), sine_(std::sin(angle)) {}
  /// The turned point.
  Point2 operator()(Point2 a) const { return {cosine_ * a.y - sine_ * a.z, sine_ * a.y + cosine_ * a.z}; }

private:
  double cosine_, sine_;
};
/// One point turned so.
inline Point2 turned(Point2 a, double angle) {
  return Turn(angle)(a);
}

/// Tangent e_s for the inclination delta.
inline Point2 tangent_of(double delta) {
  return {std::cos(delta), std::sin(delta)};
}
/// Normal e_n, into the body, for the inclination delta.
inline Point2 normal_of(double delta) {
  return {-std::sin(delta), std::cos(delta)};
}

} // namespace bem_contact

// The order of displacements and turns, said once. A wheelset: displaced along y, rolled about the forward
// axis through its centre (right side down), yawed about the vertical through its centre (front to the
// right). A wheel of a flexible wheelset is moved from where the rigid wheelset has it, before that yaw:
// displaced along y and z, rolled about the forward axis through its own centre (that of its tape circle),
// yawed about the vertical through that centre. So its displacements, and their rates, are along the yawed
// wheelset's axes. Curves: all is relative to the track at the wheelset, whose x is the tangent of its centre
// line there.
