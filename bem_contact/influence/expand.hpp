#pragma once

#include "bem_contact/influence/influence_function.hpp"
#include "bem_contact/influence/influence_numbers.hpp"

#include <functional>

namespace bem_contact {

class SeriesStore;

struct ExpandOptions {
  double dx = 0;   ///< element length along x, mm; 0: plane strain (k = 0 alone, offsets must be 1)
  int offsets = 1; ///< offsets 0 .. offsets-1
  StructuralCompliance structural = StructuralCompliance::removed;
  double contact_radius = 0; ///< revolution only: x = contact_radius * theta; 0: the reference radius
  int first_station = 0, stations = -1; ///< a run of stations; -1: all from first_station on
  SeriesStore* series = nullptr;        ///< points of earlier calls; null: none are kept
  int threads = 1;                      ///< share the rows of a kernel, with the same numbers to the last bit
};

/// Takes the numbers of one row. Several threads may call it at once, each for another row.
using TakeLines = std::function<void(NumberLines&)>;

/// Influence numbers on the file's own stations: the Fourier series over the half period
/// (series_weights.hpp), Maxwell-Betti exact. On a body of revolution the unit traction is 1 MPa per area of
/// the contact radius. Throws InputError where dx is too short for the largest wavenumber (k_max dx/2 < 5),
/// the patch is longer than the half period, or the stations asked for are not there.
/// A table serves its own element length and whole multiples of it, as exact sums, `included` alone, and
/// no plane strain; all else throws InputError.
InfluenceNumbers expand(const InfluenceFunction& function, const ExpandOptions& options);
/// Hands the same to `take` row by row, in any order, without a table of them. Of a table file it hands over
/// the numbers of the rows J <= I.
void expand_lines(const InfluenceFunction& function, const ExpandOptions& options, const TakeLines& take);

} // namespace bem_contact
