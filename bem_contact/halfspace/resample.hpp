#pragma once

#include "bem_contact/influence/expand.hpp"

#include <span>

namespace bem_contact::halfspace {

/// Numbers at rows that need not be the file's stations: row I lies at arc length row_s[I] of the body and
/// is `ds` wide. The difference between the stations' numbers and the half-space numbers at the same
/// arc-length distances is smooth; it is interpolated (cubic in s_I and s_J) and the half-space numbers of
/// the wanted rows are added back. Exact where row_s are stations and ds is the station width; Maxwell-Betti
/// exact always. On a wheel the near field is that of the contact radius.
/// row_s must be monotone (ascending or descending: a wheel's rows run against its s). The stations used are
/// those that row_s needs: first_station and stations of the options are not read.
/// Throws InputError where a row leaves the strip by more than 1 % of its width.
InfluenceNumbers resample(const InfluenceFunction& function, const ExpandOptions& options,
                          std::span<const double> row_s, double ds);

/// The pair's numbers in the contact frame: A = A_rail + T A_wheel T, T = diag(1, -1, -1) turning the
/// wheel's own frame into the contact frame. Rows of `upper` are already in the order of the contact's rows.
InfluenceNumbers combine(const InfluenceNumbers& lower, const InfluenceNumbers& upper);

} // namespace bem_contact::halfspace
