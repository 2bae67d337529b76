#pragma once

#include "bem_contact/record/record.hpp"

namespace bem_contact::record {

/// The record of a result file in today's layout, whichever version wrote it, so that no reader behind here
/// knows another one. Before 0.2 fields and words of a result lay in a group named as its model
/// (halfspace/p_n, halfspace/reason), its coordinates beside that group, and numbers were attributes
/// (certificate_holds, dx_mm). Some groups and numbers had other names (equal_forces/fem, right/p_n, Fz_N).
Record in_todays_layout(Record file);

} // namespace bem_contact::record
