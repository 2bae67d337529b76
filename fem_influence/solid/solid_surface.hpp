#pragma once

#include "bem_contact/profile/profile_curve.hpp"

#include <array>
#include <functional>

namespace bem_contact::fem {

using Vector3 = std::array<double, 3>; ///< (x, y, z) of the track frame

/// A place on the contact surface: arc length s on the profile and x along the body, both mm. On a body of
/// revolution x = R_ref theta.
struct SurfacePoint {
  double s = 0, x = 0;
};

/// A rectangle of the contact surface.
struct SurfacePatch {
  double s_from = 0, s_to = 0, x_from = 0, x_to = 0;
  double area() const { return (s_to - s_from) * (x_to - x_from); } ///< reference area, ds dx
};

/// The contact surface of a body in 3-D: its profile, extruded along x or (reference_radius != 0) turned
/// about the axle, which lies reference_radius above z = 0: (x, y, z) = (r sin theta, y, r cos theta -
/// R_ref).
class ContactSurface {
public:
  ContactSurface(ProfileCurve curve, double reference_radius)
      : curve_(std::move(curve)), radius_(reference_radius) {}

  const ProfileCurve& curve() const { return curve_; }
  double reference_radius() const { return radius_; }
  /// (x or R_ref theta, y, z) of any point of the body, with z in the section through it; and back.
  Vector3 swept_of(const Vector3& point) const;
  Vector3 from_swept(const Vector3& swept) const;
  SurfacePoint nearest(const Vector3& point) const;
  Vector3 position(SurfacePoint place) const;
  /// e_x, e_s, e_n (into the body).
  std::array<Vector3, 3> frame(SurfacePoint place) const;

private:
  ProfileCurve curve_;
  double radius_;
};

/// A quadrature point on a face of the mesh: reference coordinates in the unit square, place on the surface,
/// reference area that it stands for.
struct FacePoint {
  double xi = 0, eta = 0;
  SurfacePoint place;
  double weight = 0;
};

/// Gauss points on what a patch and a face have in common. `corner`: of the face, at (xi, eta) = (0, 0),
/// (1, 0), (0, 1), (1, 1); in between bilinear in (s, x).
void for_each_common_point(const std::array<SurfacePoint, 4>& corner, const SurfacePatch& patch,
                           const std::function<void(const FacePoint&)>& visit);

} // namespace bem_contact::fem
