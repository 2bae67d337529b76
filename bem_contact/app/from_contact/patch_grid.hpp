#pragma once

#include "bem_contact/contact_input/blocks.hpp"

#include <cstddef>

namespace bem_contact::app::from_contact {

/// The elements of a patch, and where CONTACT's coordinates lie on them. The scene's x and s count from the
/// middle of the grid, along the rolling direction; CONTACT's from an origin anywhere, and with CHI = 180
/// degrees against it.
struct PatchGrid {
  std::size_t mx = 0, ms = 0;
  double dx = 0, ds = 0; ///< mm
  double x = 0, y = 0;   ///< the middle of the grid in CONTACT's coordinates, mm
  bool turned = false;   ///< rolling against CONTACT's x: both axes are turned by 180 degrees

  double sign() const { return turned ? -1 : 1; }
  std::size_t elements() const { return mx * ms; }
  /// Place of an element of the scene in CONTACT's coordinates, mm.
  double contact_x(std::size_t i) const {
    return x + sign() * (static_cast<double>(i) - 0.5 * (static_cast<double>(mx) - 1)) * dx;
  }
  double contact_y(std::size_t j) const {
    return y + sign() * (static_cast<double>(j) - 0.5 * (static_cast<double>(ms) - 1)) * ds;
  }
  /// Number of CONTACT's element, row by row in rising y, at the place of the scene's (i, j).
  std::size_t contact_element(std::size_t i, std::size_t j) const {
    return turned ? (ms - 1 - j) * mx + (mx - 1 - i) : j * mx + i;
  }
};

/// The grid of IPOTCN 1 to 4.
PatchGrid grid_by_places(const contact_input::Block& potential);

/// The ellipse of IPOTCN -1 to -3: curvatures of the undeformed distance, 1/mm, and the grid around it.
struct HertzianGrid {
  PatchGrid grid;
  double curvature_x = 0, curvature_s = 0;
};

/// `modulus`: of the pair, MPa; `by_force`: `load` is a force (N), else an approach (mm). Throws InputError
/// where there is no such ellipse.
HertzianGrid grid_by_ellipse(const contact_input::Block& potential, double modulus, bool by_force,
                             double load);

} // namespace bem_contact::app::from_contact
