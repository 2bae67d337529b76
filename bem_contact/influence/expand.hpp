#pragma once

#include "bem_contact/influence/influence_function.hpp"
#include "bem_contact/influence/influence_numbers.hpp"

namespace bem_contact {

struct ExpandOptions {
  double dx = 0;       ///< element length along x, mm; 0: plane strain (k = 0 alone, offsets must be 1)
  int offsets = 1;     ///< offsets 0 .. offsets-1
  StructuralCompliance structural = StructuralCompliance::removed;
  double contact_radius = 0; ///< revolution only: x = contact_radius * theta; 0: the reference radius
  int first_station = 0, stations = -1; ///< a run of stations; -1: all from first_station on
};

/// Influence numbers on the file's own stations. Fourier series over the half period, kernel interpolated
/// in log k (6-point Lagrange on k g(k)), tail ~ 1/k; factor sin(ka)/(ka) twice: load and average.
/// Throws InputError where dx is too short for the largest wavenumber (k_max dx/2 < 5).
InfluenceNumbers expand(const InfluenceFunction& function, const ExpandOptions& options);

} // namespace bem_contact
