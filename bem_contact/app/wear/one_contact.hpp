#pragma once

#include "bem_contact/app/command.hpp"
#include "bem_contact/uses/wear/study.hpp"

#include <string>

namespace bem_contact::app {

/// How `wear` was asked of a scene without a table [sweep].
struct OneContactWear {
  std::string file, model; ///< scene file, and the option --model
  std::string output;      ///< result file (HDF5); "": none
  bool json = false;
  wear::StudyOptions law = {}; ///< of it: law, hardness and speed
};

/// Solves one wheel, or both of a wheelset, and prints what a kilometre, a million axles and a million gross
/// tonnes take off. Throws what the solution and wear_of() throw.
ExitCode wear_of_one_contact(const OneContactWear& asked);

} // namespace bem_contact::app
