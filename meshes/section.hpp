#pragma once

#include "bem_contact/base/conventions.hpp"
#include "bem_contact/profile/bodies/body_file.hpp"
#include "bem_contact/profile/profile_curve.hpp"
#include "meshes/settings.hpp"

#include <functional>
#include <vector>

namespace bem_contact::meshes {

/// Physical groups of the curves, ids as in the .msh; the surface is `body_group`.
enum class Group : int { contact = 1, held = 2, free = 3 };
inline constexpr int body_group = 10;

/// One smooth piece of an outline: `at(t)` for t from `from` to `to`, section frame (y, z), mm.
struct Piece {
  std::function<Point2(double)> at;
  double from = 0;
  double to = 1;
  Group group = Group::free;

  Point2 begin() const { return at(from); }
  Point2 end() const { return at(to); }
};

Piece line(Point2 from, Point2 to, Group group = Group::free);
/// Arc about `centre`; angles in rad, from +y towards +z.
Piece arc(Point2 centre, double radius, double angle_from, double angle_to, Group group = Group::free);
/// Cubic Bezier curve with control points p0 .. p3.
Piece bezier(Point2 p0, Point2 p1, Point2 p2, Point2 p3);
/// The profile between two arc lengths; t is the arc length.
Piece along(const ProfileCurve& curve, double from, double to, Group group = Group::free);

/// A closed outline: each piece begins where the one before it ends, the material on the side of
/// (-dz, dy) of the walking direction (dy, dz): outer loops and holes alike.
using Loop = std::vector<Piece>;

/// A body's cross-section. The first piece of the first loop is the contact strip, walked with rising
/// arc length, so that its parameter is the profile's arc length.
struct Section {
  std::string name;
  std::vector<Loop> loops;
  std::string note = {}; ///< what the user should know of it: where a graft was found
};

/// The section of a body that parse_body_file() accepts, its profile from body_profile. Throws InputError
/// when the strip is not on the profile, or no whole section is known for the profile.
Section make_section(const BodyFile& body);

/// Area enclosed, mm^2, by the trapezoidal rule on `samples` points a piece.
double area(const Section& section, int samples = area_samples);

} // namespace bem_contact::meshes
