#pragma once

#include "bem_contact/profile/bodies/rail_section.hpp"

#include <boost/math/quadrature/gauss.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace bem_contact {

/// Of a section symmetric about z, from its right half.
struct SectionProperties {
  double area = 0;     ///< mm^2
  double centroid = 0; ///< height of the centroid above the lowest point of the outline, mm
  double Ix = 0;       ///< second moment about the horizontal axis through the centroid, mm^4
  double Iy = 0;       ///< second moment about the vertical axis of symmetry, mm^4
};

inline SectionProperties section_properties(const std::vector<SectionPiece>& right_half) {
  // Green's theorem along the outline: integral of f dA = integral of F dz with F = integral of f dy. The
  // part of the boundary on the axis y = 0 adds nothing.
  constexpr int parts = 16;
  double area = 0, first = 0, second_z = 0, second_y = 0, lowest = 0;
  for (const SectionPiece& piece : right_half) {
    const CurvePiece curve = curve_of(piece);
    const auto integral = [&](auto&& f) {
      double sum = 0;
      for (int part = 0; part < parts; ++part)
        sum += boost::math::quadrature::gauss<double, 5>::integrate(
            [&](double along) {
              const PiecePoint p = point_on(curve, along);
              return f(p.position.y, p.position.z) * std::sin(p.delta);
            },
            curve.length * part / parts, curve.length * (part + 1) / parts);
      return sum;
    };
    area += integral([](double y, double) { return y; });
    first += integral([](double y, double z) { return y * z; });
    second_z += integral([](double y, double z) { return y * z * z; });
    second_y += integral([](double y, double) { return y * y * y / 3; });
    lowest = std::max(lowest, piece.to.z);
  }
  const double z_mean = first / area;
  return {2 * area, lowest - z_mean, 2 * (second_z - area * z_mean * z_mean), 2 * second_y};
}

} // namespace bem_contact
