#pragma once

#include "bem_contact/geometry/placement.hpp"
#include "bem_contact/profile/contact_row.hpp"

#include <span>
#include <vector>

namespace bem_contact {

/// Where approach, creepages and moments refer to: a point of the rail, or the middle of a patch's grid.
struct ReferencePoint {
  Point2 position;  ///< on the rail, mm, track frame (a patch: its own frame, profile/contact_row.hpp)
  double s = 0;     ///< arc length on the rail, mm
  double delta = 0; ///< rad
  double x = 0;     ///< mm
  double ahead = 0; ///< by how much unevenness moves it along x, mm
};

/// Creepages at the reference point, and the wheelset's own velocities, from which rigid_slip() finds the
/// rest. For a shift, xi and eta are displacements in mm and phi is an angle in rad.
struct Creepage {
  double xi = 0, eta = 0;    ///< longitudinal, lateral (along the rail's tangent there)
  double phi = 0;            ///< about the rail's normal there, 1/mm
  double rolling_radius = 0; ///< |V / omega| at xi = 0, mm; 0: the wheel's at the reference point
  double slip_x = 0;  ///< of a rolling wheel: added to w_x of all elements, as solve() finds it for force_x
  Vector3 velocity{}; ///< of the wheelset's centre besides V, over V, track frame
  double roll = 0, yaw = 0; ///< rates over V: about the wheelset's forward axis and the vertical, rad/mm
  double roller_speed =
      0; ///< of a roller, over V, rad/mm; 0: its surface moves with V at the reference point
  /// Of a wheel in a flexible wheelset, over V, besides what the wheelset does: velocity of its centre
  /// forwards, to the right and down along the wheelset's axes; and rates about its own forward axis, its
  /// axle (positive as it rolls forwards) and the vertical, rad/mm.
  Vector3 wheel_velocity{}, wheel_rates{};
};

/// Rigid slip w of elements: velocity of the wheel's surface over the rail's, over the rolling speed V, in
/// the local frames (x, s) of the rows; fields [rows][x]. Of a shift: its displacement, mm.
struct RigidSlip {
  std::vector<double> x, s; ///< along x and s, [rows][x]
};

/// Returns the rigid slip of a rolling wheel. It moves along x with V and turns about its axle a
/// (WheelFrame::axle, which points to the right) with omega = -V / R_roll, R_roll = rolling_radius / (1 -
/// xi). With C any point of the axle, a point X of the wheel's surface moves over the rail with the velocity
///   v/V = e_x - a x (X - C) / R_roll,
/// plus velocity + (roll e_forward + yaw e_z) x (X - centre of the wheelset), plus eta along the rail's
/// tangent and phi about the rail's normal at the reference point, and slip_x. What moves along the normal is
/// left to the approach. On a rail at inclination delta that is, to first order and with yaw psi, w_x = 1 -
/// r/R_roll, w_s = -psi cos(delta) + sin(delta) x/R_roll: a yawed wheel slides to the left, the geometric
/// spin is sin(delta)/R, negative at the gauge corner of a right-hand rail, and differs from row to row.
///
/// On a roller nothing moves forwards. The roller's surface moves back with its own speed in place of e_x,
/// and all is over the mean V' of both surface speeds at the reference point (mean_surface_speed()). There
/// w_x is the difference of these speeds over V', plus xi as on a track; to first order in creepage a large
/// roller is a track. `rows`, `x`: middles of the elements, mm.
///
/// On a rail of sections all of this is seen in its frame, over the speed V / cos(pitch) along its surface;
/// the wheel's centre moves along the surface where it touches.
///
/// On uneven bodies the wheel's centre rises and falls as it rolls: by as much as the wheel's turning moves
/// the reference point along the rail's normal more than it would the place where a round wheel is nearest.
RigidSlip rigid_slip(const WheelOnRail& pair, const ReferencePoint& reference, const Creepage& creepage,
                     std::span<const ContactRow> rows, std::span<const double> x);

/// Which angular speed of the wheel belongs to which creepage xi. On a track the wheel rolls with the radius
/// V / omega = radius / (1 - xi). On a roller w_x at the reference point is the difference of both surfaces'
/// speeds over their mean, which the wheel's own speed changes.
struct RollingSpeed {
  double radius = 0;            ///< V / omega at xi = 0, mm
  double wheel = 1, roller = 1; ///< speeds of the surfaces at the reference point at xi = 0, over V
  bool on_roller = false;       ///< creepage counts from the mean speed of both surfaces

  double radius_at(double xi) const; ///< V / omega with this creepage, mm
  double xi_at(double radius) const; ///< the creepage with which it is that
};
/// Gives the speed of a wheel on a rail or roller, at the reference point, with this creepage.
RollingSpeed rolling_speed(const WheelOnRail& pair, const ReferencePoint& reference,
                           const Creepage& creepage);

/// The mean of the speeds of both surfaces at the reference point, over V; on a track that along the rail's
/// surface, 1 where it is level.
double mean_surface_speed(const WheelOnRail& pair, const ReferencePoint& reference, const Creepage& creepage);

/// How far a point of the wheel lies from its axle across the rolling direction, mm: a wheel that rolls with
/// this radius does not slide along x there. On a rail of sections, which is longer than the track, it is
/// less by as much. `x`, `point`: in the track frame, mm.
double radius_at(const WheelOnRail& pair, double x, Point2 point);
/// The same with the frame of the pair, where it is known.
double radius_at(const WheelOnRail& pair, const WheelFrame& frame, double x, Point2 point);
/// The same of a point in space, on no roller.
double radius_at(const WheelFrame& frame, const Vector3& point);

/// Returns the rigid shift of a wheel that does not roll, mm: w_x = xi - phi s, w_s = (eta + phi x) cos(delta
/// - delta of the reference point), xi, eta in mm and phi in rad, s along the tangent there, s and x from
/// there.
RigidSlip rigid_shift(const ReferencePoint& reference, const Creepage& creepage,
                      std::span<const ContactRow> rows, std::span<const double> x);

/// Returns the rigid slip on a plane, where the contact lies at (x_of_contact, s = 0): w_x = xi - phi s, w_s
/// = eta + phi (x - x_of_contact).
RigidSlip planar_slip(const Creepage& creepage, std::span<const ContactRow> rows, std::span<const double> x,
                      double x_of_contact = 0);

} // namespace bem_contact
