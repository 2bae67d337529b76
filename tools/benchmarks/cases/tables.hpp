#pragma once

#include "bem_contact/scene/sweep_file.hpp"

namespace cases {

// What bench_cases prints. Seconds are CPU seconds of one thread, contact search included. Errors are those
// against references() by the cases `by`.

/// What each means of a sequence saves: a row without each.
void ablation(const bem_contact::SweepFile& sweep, const bem_contact::SweepFile& by);

/// A CSV line a case and accuracy, 10 to 0.5 %; for half-space numbers also 0.2 and 0.1 %, for which the
/// references have elements an eighth as large and of many cases every fourth is solved.
void accuracy(const bem_contact::SweepFile& sweep, const bem_contact::SweepFile& by);

/// The same lines at 2 %, with the error against `by` on the same elements: what the influence files are off
/// by.
void files(const bem_contact::SweepFile& sweep, const bem_contact::SweepFile& by);

/// What contact in two areas costs beside each area alone.
void areas(const bem_contact::SweepFile& sweep);

/// A CSV line for each printed number of each case and of its patches: value, stated error (nan: none), and
/// the value on elements a quarter as long and as wide; for totals whether the grid is one row or column, and
/// the parts of the stated error (ErrorParts). The line "stated" or "unconverged" of each case has whether an
/// error is stated, and the true relative error of pmax.
void estimates(const bem_contact::SweepFile& sweep);

} // namespace cases
