#pragma once

#include "bem_contact/profile/profile_findings.hpp"
#include "bem_contact/record/record.hpp"

namespace bem_contact {

/// What a profile file says (`bem_contact profile`, Python's profile()): its curve at steps of at most `step`
/// mm, noise, outliers, the standard that it is like, and the numbers of EN 15313.
record::Record record_of(const MeasuredProfile& profile, const ProfileFindings& findings, ProfileKind kind,
                         double step);

} // namespace bem_contact
