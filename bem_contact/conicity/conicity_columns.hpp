#pragma once

#include "bem_contact/conicity/wheelset_conicity.hpp"

#include <span>
#include <vector>

namespace bem_contact {

/// The tables of a wheelset's conicity. The program's outputs and Python take names, units and values from
/// here.

/// A column over the lateral displacement.
struct StandColumn {
  const char *name, *unit, *description;
  double (*value)(const WheelsetStand&);

  /// One value a stand.
  std::vector<double> values(const WheelsetConicity& conicity) const;
};
/// All of them, in the order of the outputs.
std::span<const StandColumn> stand_columns();

/// A column over the amplitude.
struct ConicityColumn {
  const char *name, *unit, *description;
  double (*value)(const WheelsetConicity::Value&); ///< nan where there is no motion

  /// One value an amplitude.
  std::vector<double> values(const WheelsetConicity& conicity) const;
};
/// All of them, in the order of the outputs.
std::span<const ConicityColumn> conicity_columns();

} // namespace bem_contact
