#pragma once

#include "bem_contact/sequence/scene_result.hpp"

#include <span>

namespace bem_contact {

/// One number that is printed of a result, with the absolute error that the size of the elements is estimated
/// to cause (Discretisation). Its names are the same in JSON, HDF5, CSV and Python: "pmax" and "pmax_error".
struct PrintedNumber {
  const char *name, *error_name;
  const char *unit, *description;
  double (*value)(const SceneResult&);
  double (*error)(const SceneResult&); ///< in the unit; nan: no number can be given
};

/// Fx, Fy, Fz, Fs, Mz (about the reference point), approach, pmax, area, adhesion_share, xi, eta (found for
/// prescribed forces), friction_power.
std::span<const PrintedNumber> printed_numbers();

/// Fn, Fx, Fs, approach, pmax and area of one patch.
struct PrintedPatchNumber {
  const char *name, *error_name;
  const char* unit;
  double PatchSummary::*value;
  double PatchErrors::*error;
};
std::span<const PrintedPatchNumber> printed_patch_numbers();

/// Of one patch of a result; all nan where there is no estimate.
PatchErrors errors_of_patch(const ContactResult& result, std::size_t patch);

/// Share of the elements in contact that adhere; 0 without contact.
double adhesion_share(const ContactResult& result);

} // namespace bem_contact
