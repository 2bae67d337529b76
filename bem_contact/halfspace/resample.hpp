#pragma once

#include "bem_contact/halfspace/line_store.hpp"
#include "bem_contact/influence/expand.hpp"

#include <span>

namespace bem_contact::halfspace {

/// The stations that rows at these arc lengths, mm, are interpolated from: all that resample() needs of a
/// function. Of rows beyond the strip, those at its end.
StationRange stations_under(const InfluenceStrip& strip, std::span<const double> row_s);

/// Influence numbers at rows that need not be the file's stations: row I lies at arc length row_s[I] of the
/// body and is `ds` wide, mm.
///
/// The file's numbers are peaked at small distances, and interpolating them would be wrong. Their difference
/// to half-space numbers at the same arc-length distances is smooth. So that difference is interpolated
/// (cubic in s_I and s_J), and the half-space numbers of the rows are added back. The result is exact if the
/// rows are stations, and symmetric as Maxwell and Betti demand always. On a wheel the radius is that of the
/// contact.
///
/// `function` has the stations_under() the rows at least. row_s must be monotone: it descends on a wheel,
/// whose rows run against its s. The stations used are those that the rows need; first_station and stations
/// of the options are not read. `known`: half-space numbers of earlier calls; null: none. Throws InputError
/// where a row leaves the strip by more than 1 % of its width.
InfluenceNumbers resample(const InfluenceFunction& function, const ExpandOptions& options,
                          std::span<const double> row_s, double ds, LineStore* known = nullptr);

/// Hands the same to `take` row by row (expand_lines()), without a table of them.
void resample_lines(const InfluenceFunction& function, const ExpandOptions& options,
                    std::span<const double> row_s, double ds, const TakeLines& take,
                    LineStore* known = nullptr);

} // namespace bem_contact::halfspace
