#pragma once

#include "meshes/section.hpp"

#include <span>
#include <vector>

namespace bem_contact::meshes {

/// Where a standard body lies in the frame of a measured profile: turned by `angle` (rad, from +y towards
/// +z), then its origin moved to `at`, mm.
struct GraftPlace {
  Point2 at;
  double angle = 0;
  double share = 0; ///< of the profile that lies on the body there, see below
};

/// A straight bit of an outline.
struct Chord {
  Point2 from, along; ///< unit vector
  double length = 0;
};

/// The loop as chords about `step` long, mm.
std::vector<Chord> chords(const Loop& loop, double step);

struct ProfileSample {
  Point2 position, tangent;
};

/// `count` points equally far apart along the profile.
std::vector<ProfileSample> samples_of(const ProfileCurve& curve, int count);

/// Moves `place` to where the samples lie best on the outline: least squares by Gauss-Newton, with Tukey's
/// weights, so that what is farther off than `width`, mm, counts for nothing. False if it runs away.
bool refine(GraftPlace& place, std::span<const ProfileSample> samples, std::span<const Chord> outline,
            double width, int steps);

/// Refines a place that is nearly right: first by all that may be unworn, then by what lies as near as most
/// of that does, because wear begins slowly. Sets its share. False if it runs away.
bool settle(GraftPlace& place, std::span<const ProfileSample> samples, std::span<const Chord> outline);

/// How the unworn part holds the body: the least eigenvalue of its mean stiffness; 0 if nothing is unworn.
double stiffness_at(const GraftPlace& place, std::span<const ProfileSample> samples,
                    std::span<const Chord> outline);

} // namespace bem_contact::meshes
