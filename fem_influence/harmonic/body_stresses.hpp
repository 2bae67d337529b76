#pragma once

#include "bem_contact/inside/loaded_inside.hpp"
#include "bem_contact/profile/bodies/body_file.hpp"
#include "bem_contact/profile/profile_curve.hpp"

#include <cstddef>
#include <filesystem>
#include <functional>
#include <span>

/// Stresses inside a body under given tractions, by one solution for each wavenumber (THEORY.md, section 10).
namespace bem_contact::fem {

/// An elliptical contact that slips along x: pressure p0 sqrt(1 - x^2/a^2 - (s - s0)^2/b^2) and friction
/// times it along x, on the body's surface, in its own frame.
struct EllipticalLoad {
  double s = 0;        ///< arc length of the middle, mm
  double a = 1, b = 1; ///< semi-axes along x and s, mm
  double pressure = 1; ///< p0, MPa
  double friction = 0; ///< p_x over p_n
};
/// It on elements of a grid: the mean over each.
inside::SurfaceTractions tractions_of(const EllipticalLoad& load, double poisson);

/// Says how far a run is: (done, all) solutions.
using StressProgress = std::function<void(std::size_t, std::size_t)>;

/// Adds the body's stresses to those of the half-space under the same tractions, with their positions and
/// errors. Only what both differ by is solved for: it is smooth, so near the surface, where elements of the
/// mesh and of the tractions show, it follows from some depths, and the tractions of the surface are kept.
/// The error of each point is the difference to a solution with one degree less, and what the way to the
/// surface may be off. Matrices are factorized once for all loads; a load takes some 10 MB meanwhile. Throws
/// InputError where tractions leave the strip, or for a mesh that does not fit.
void add_body_stresses(std::span<inside::LoadedInside> loads, const BodyFile& body, const ProfileCurve& curve,
                       const std::filesystem::path& mesh, const StressProgress& progress);

} // namespace bem_contact::fem
