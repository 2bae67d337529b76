#pragma once

#include "bem_contact/fatigue/fatigue_of_result.hpp"

#include <span>

namespace bem_contact::fatigue {

/// A number of each patch. The program's CSV and Python take names, units and values from here.
struct PatchColumn {
  const char *name, *unit;
  double (*value)(const PatchFatigue&);
};
/// All of them, in the order of the outputs.
std::span<const PatchColumn> patch_columns();

} // namespace bem_contact::fatigue
