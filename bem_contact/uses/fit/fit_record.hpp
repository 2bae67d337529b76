#pragma once

#include "bem_contact/record/record.hpp"
#include "bem_contact/uses/fit/fit_curve.hpp"

namespace bem_contact::fit {

/// What a fit says at every door: that of creep curves at the found values with "measured" beside them, and
/// "parameters/KEY", "correlation", "band", "misfit", "not_determined".
record::Record record_of(const CurveFit& fit);

} // namespace bem_contact::fit
