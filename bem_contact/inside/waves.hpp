#pragma once

#include "bem_contact/inside/surface_tractions.hpp"

#include <array>
#include <cstddef>
#include <vector>

/// Tractions and stresses as sums of waves along x.
namespace bem_contact::inside {

struct Wavenumber {
  double k = 0, weight = 0; ///< 1/mm each
};

/// The series f(x) = 1/(2L) F(0) + 1/L sum F(n pi/L) cos(n pi x/L) with L = half_period, mm: its lowest terms
/// as they are, and the others as an integral up to `last`, 1/mm. `reach`: of |x| and of the tractions, mm.
std::vector<Wavenumber> waves_of_series(double half_period, double last, double reach);

/// The radius of a body of revolution where its profile is at z, over that where it is at 0; 1 of a body that
/// is endless along x (`reference_radius` 0).
inline double relative_radius(double reference_radius, double z) {
  return reference_radius == 0 ? 1 : (reference_radius + z) / reference_radius;
}

/// How far tractions reach along x from x = 0, mm.
double reach_of(const SurfaceTractions& tractions);

/// Integrals over x of a row's tractions times cos kx and sin kx; [component], MPa mm.
struct WaveOfRow {
  std::array<double, 3> cosine{}, sine{};

  WaveOfRow(const SurfaceTractions& tractions, std::size_t row, double k);

  /// Amplitudes of two loads that vary as cos(kx) along s and n and as sin(kx) along x. The second lies a
  /// quarter of a wave behind: it has sin kx = cos (kx - pi/2) along s and n, cos kx = -sin (kx - pi/2) along
  /// x.
  std::array<double, 2> amplitudes(std::size_t component) const {
    return component == component_x ? std::array{sine[component], -cosine[component]}
                                    : std::array{cosine[component], sine[component]};
  }
};

/// As stresses vary along x in one of the two loads: xx, ss, nn and sn as `even`, xs and xn as `odd`.
struct WaveAt {
  double even = 0, odd = 0;

  WaveAt(double phase, bool second);
};

} // namespace bem_contact::inside
