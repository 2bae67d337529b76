#pragma once

#include "bem_contact/base/conventions.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace bem_contact {

/// A smoothed profile, and what smoothing took away.
struct SmoothedProfile {
  std::vector<Point2> points;
  std::vector<std::size_t> kinks; ///< indices of points at which the tangent jumps: they stay where they are
  double largest = 0;             ///< largest distance by which a point moved, mm
  double rms = 0;                 ///< root of the mean square of these distances, mm
};

/// Smoothing spline of degree five in discrete form (Whittaker 1923; Eilers 2003) that lets the curvature
/// jump: of the curve c(t), t the length along the chords, it finds the points that minimise
///
///     integral |c - measured|^2 dt + (wavelength / 2 pi)^6 integral H(|c'''|) dt
///
/// H is Huber's function (1964): H(b) = b^2 up to the bound B = (2 pi / wavelength)^3 times 12 um, and
/// 2 B b - B^2 above. A wave of length L and of less than 12 um height above its mean keeps the share
/// 1 / (1 + (wavelength / L)^6) of its height, independent of the spacing of the points: 50 % at
/// L = wavelength, 98.5 % at twice that, 1.5 % at half. Parabolas pass unchanged, also at the ends, which are
/// free; a circle of radius R shrinks by (wavelength / 2 pi R)^6. Where the profile bends more abruptly than
/// such a wave, as where two arcs of a rail meet, the curvature may jump: a square would spread the jump over
/// a wavelength, which takes 4 % of the area of a conformal contact.
///
/// The profile is cut at its kinks: points where tangents fitted on either side, over a quarter of the
/// wavelength, differ by more than 0.2 rad. Each part is smoothed alone and ends in the kink. Points nearer
/// to each other than a fiftieth of the wavelength become their mean first. Points are in walking order.
SmoothedProfile smoothed(std::span<const Point2> points, double wavelength);

} // namespace bem_contact
