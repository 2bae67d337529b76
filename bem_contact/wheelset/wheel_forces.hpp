#pragma once

#include "bem_contact/sequence/scene_result.hpp"

namespace bem_contact {

/// Forces and moments on the rail: N, N mm; components along x, y, z.
struct Wrench {
  Vector3 force{}, moment{};

  Wrench& operator+=(const Wrench& other);
};
/// Sum, about the same point.
Wrench operator+(Wrench a, const Wrench& b);

/// Of a force in the plane across the track, at a point: by its components along x, y, z; `arm` from the
/// point that the moment is about.
Wrench wrench_at(const Vector3& force, const Vector3& arm);

/// What the plane through the middle of the track mirrors: y of vectors changes sign, and x and z of moments.
Wrench mirrored(Wrench w);

/// Sums of all tractions of a result in the track frame of its side (of a left wheel: y to the left), about
/// `centre` (y, z in that frame; x = 0), mm.
Wrench wrench_of(const SceneResult& result, Point2 centre);

} // namespace bem_contact
