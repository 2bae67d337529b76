#pragma once

#include "bem_contact/base/tuned.hpp"

#include <cstddef>
#include <numbers>

/// Tuned numbers of profile/measured. For the words see base/tuned.hpp.
namespace bem_contact {

// Repair of measured points.

/// 1. A walk that travels this many times its width along y goes over the same ground twice. Below 2, because
/// overlapping scans rarely cover all of each other; a profile with under-head stays below 1.5.
BEM_CONTACT_TUNED(double, doubled_walk, 1.9);

// Noise of measured points, and smoothing.

/// mm. Half the height of a wave of the shortest length kept that smoothing still takes for noise. Higher
/// ones are jumps of the curvature. Measured with tools/benchmarks/profile_noise: 8 um leaves noise beside
/// the jumps of S1002, 16 um rounds them.
BEM_CONTACT_TUNED(double, highest_wave, 0.0145);
/// 1. Weights of the repeated least squares settle to this: it moves no point by a nanometre.
BEM_CONTACT_TUNED(double, smoothing_precision, 1e-4);
/// Repetitions. Far more than profiles need.
BEM_CONTACT_TUNED(int, most_smoothing_rounds, 200);

} // namespace bem_contact
