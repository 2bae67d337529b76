#pragma once

#include "bem_contact/scene/sweep_file.hpp"

namespace cases {

// What bench_cases prints. Seconds are CPU seconds of one thread, contact search included. Errors are those
// against references() by the cases `by`.

/// What each means of a sequence saves: a row without each.
void ablation(const bem_contact::SweepFile& sweep, const bem_contact::SweepFile& by);

/// A CSV line a case and accuracy, 10 to .5 %; for half-space numbers also .2 and .1 %, for which the
/// references have elements an eighth as large and of many cases every fourth is solved.
void accuracy(const bem_contact::SweepFile& sweep, const bem_contact::SweepFile& by);

/// What contact in two areas costs beside each area alone.
void areas(const bem_contact::SweepFile& sweep);

} // namespace cases
