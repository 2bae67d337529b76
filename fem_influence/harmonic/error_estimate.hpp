#pragma once

#include "bem_contact/influence/influence_function.hpp"

namespace bem_contact::fem {

/// A companion run is coarser in everything: one degree less, one level less at the stations' borders
/// (where there is one), every second logarithmic sample. This is how much larger its error is than that of
/// the run, less 1, so that (companion - run) / error_ratio is the error of the run. Errors of averaged
/// displacements go as (h / (p^2 ds))^2, h the size of the cells at the borders, p their degree, ds the width
/// of a station (THEORY.md 3).
double error_ratio(int degree, int borders);

/// Of the samples of wavenumber_samples() those of the companion: the harmonics, then every second one up to
/// the last.
std::vector<std::size_t> companion_samples(std::size_t count);

/// What the numbers of a grid with dx = shortest_dx are wrong by: largest over stations, components and
/// offsets to 16 mm of |error of A_ij| / max_i |A_ii| at that place, which is the self number at offset 0.
struct ErrorEstimate {
  double mesh = 0;    ///< from the companion on its own samples
  double samples = 0; ///< from leaving out every second sample
  double total = 0;   ///< largest sum of the two; bounds the true error
};

/// Stations whose numbers are looked at: some evenly spread, and ever farther neighbours of three of them.
std::vector<std::size_t> compared_stations(std::size_t count);

/// `companion` has the samples companion_samples() of `function` and its compared_stations() alone. The
/// structural motion is removed where it can be.
ErrorEstimate estimate_error(const InfluenceFunction& function, const InfluenceFunction& companion,
                             double shortest_dx, double ratio, int samples_per_decade);

} // namespace bem_contact::fem
