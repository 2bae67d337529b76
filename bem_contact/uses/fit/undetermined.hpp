#pragma once

#include "bem_contact/uses/fit/fit_curve.hpp"

namespace bem_contact::fit {

/// What the points do not say, in sentences: of keys that nothing depends on, that ended at a bound or may be
/// almost anything, of pairs that move forces alike, and of the slope where nothing slips.
std::vector<std::string> undetermined(const CurveFit& fit);

} // namespace bem_contact::fit
