#pragma once

#include <string>
#include <vector>

#include "bem_contact/uses/table/fmu.hpp"

namespace bem_contact::app {

/// A machine that an FMU has a binary for, and the compiler that makes it here.
struct FmuPlatform {
  std::string compiler;           ///< name of the program
  std::string folder3;            ///< in `binaries`, by FMI 3
  std::string folder2;            ///< by FMI 2; "": it has none for this machine
  std::string ending;             ///< of a shared library
  std::vector<std::string> flags; ///< of the compiler
};

/// This machine, and Windows.
const std::vector<FmuPlatform>& fmu_platforms();

/// Whether its compiler is there.
bool has_compiler(const FmuPlatform& platform);

/// The shared library of the source of an FMU. Throws Error with what the compiler said where it fails.
std::string compiled(const table::Fmu& fmu, const FmuPlatform& platform);

} // namespace bem_contact::app
