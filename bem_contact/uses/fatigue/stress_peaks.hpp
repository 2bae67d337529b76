#pragma once

#include "bem_contact/contact/problem.hpp"
#include "bem_contact/contact/result.hpp"
#include "bem_contact/inside/stresses_inside.hpp"

namespace bem_contact::fatigue {

/// The largest stress of one kind below the surface, and where it is.
struct StressPeak {
  double stress = 0; ///< MPa
  double x = 0,
         s = 0;     ///< of the point above it on the surface, mm; x of the grid, s on the rail's arc length
  double depth = 0; ///< below that point along the normal n, mm
};

/// Holds the peaks in the rail (a patch: in the lower body).
struct StressPeaks {
  StressPeak von_mises; ///< equivalent stress of von Mises
  StressPeak tresca;    ///< largest shear stress, half the difference of the outer principal stresses
};

/// Searches the half-space's stresses under the tractions (sequence/stresses.hpp) below the whole contact: on
/// a coarse lattice first, then from the largest value in steps that become smaller. Depths begin at one
/// element's side: nearer to the surface the elements' edges show, and element_index() tells about the
/// surface itself. `poisson`: Poisson's ratio of the rail (a patch: of the lower body). All zero without
/// contact.
StressPeaks stress_peaks(const ContactProblem& problem, const ContactResult& result, double poisson);

/// The largest stresses inside a body, or of the half-space at the same points, of those that are as deep as
/// `depth` (mm) at least.
StressPeaks stress_peaks(const inside::StressesInside& inside, bool of_halfspace, double depth);

} // namespace bem_contact::fatigue
