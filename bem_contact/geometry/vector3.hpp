#pragma once

#include <array>
#include <cmath>

namespace bem_contact {

/// A point or vector of the track frame (x, y, z), mm.
using Vector3 = std::array<double, 3>;

/// Scalar product.
constexpr double dot(const Vector3& a, const Vector3& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
/// Vector product.
constexpr Vector3 cross(const Vector3& a, const Vector3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
/// Length.
inline double norm(const Vector3& a) {
  return std::hypot(a[0], a[1], a[2]);
}
/// The way from one point to another.
constexpr Vector3 between(const Vector3& from, const Vector3& to) {
  return {to[0] - from[0], to[1] - from[1], to[2] - from[2]};
}

} // namespace bem_contact
