#pragma once

#include "bem_contact/halfspace/stress.hpp"
#include "bem_contact/profile/bodies/body_file.hpp"
#include "bem_contact/profile/profile_curve.hpp"

#include <cstddef>
#include <filesystem>
#include <functional>
#include <span>
#include <vector>

/// Stresses inside a body under given tractions, by one solution for each wavenumber.
namespace bem_contact::fem {

/// An elliptical contact that slips along x: pressure p0 sqrt(1 - x^2/a^2 - (s - s0)^2/b^2) and friction
/// times it along x, on the body's surface, in its own frame.
struct EllipticalLoad {
  double s = 0;        ///< arc length of the middle, mm
  double a = 1, b = 1; ///< semi-axes along x and s, mm
  double pressure = 1; ///< p0, MPa
  double friction = 0; ///< p_x over p_n
};

/// A point below the load with its stresses, MPa, tension positive, in the frame (x, s, n) of the nearest
/// point of the surface. One of each place along x.
struct StressesAtPoint {
  double s = 0, depth = 0;             ///< of the nearest point of the surface, and the distance, mm
  std::vector<halfspace::Stress> body; ///< of the body
  std::vector<halfspace::Stress> flat; ///< of a half-space under the same tractions, unrolled along s
};

struct StressesInside {
  std::vector<double> x; ///< places along x (of a wheel: along the surface at the load), mm
  std::vector<StressesAtPoint> points;
  std::size_t unknowns = 0, wavenumbers = 0;
};

/// At quadrature points of the cells below the load: between s0 - b and s0 + b, from 0.15 to 2.5 of the
/// smaller semi-axis deep. Tractions are constant on each station; cells are those of the body file's mesh,
/// without levels at borders of stations. Throws InputError where the load leaves the strip, or for a mesh
/// that does not fit.
StressesInside stresses_inside(const BodyFile& body, const ProfileCurve& curve,
                               const std::filesystem::path& mesh, const EllipticalLoad& load,
                               const std::function<void(std::size_t, std::size_t)>& progress);

} // namespace bem_contact::fem
