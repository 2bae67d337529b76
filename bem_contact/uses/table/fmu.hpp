#pragma once

#include "bem_contact/uses/table/contact_table.hpp"

#include <string>
#include <vector>

namespace bem_contact::table {

/// The Functional Mock-up Interface (FMI, https://fmi-standard.org), by which programs exchange models.
enum class FmiVersion { v2, v3 };

/// What an FMU is made of.
struct Fmu {
  std::string model;       ///< a name of C: of its library, its source and as programs show it
  std::string description; ///< modelDescription.xml
  std::string build;       ///< buildDescription.xml of the source, for FMI 3; "" for FMI 2
  std::string source;      ///< C99 without any library but C's own, for both versions
};

struct FmuOptions {
  std::string model;                ///< a name of C
  std::vector<std::string> columns; ///< outputs; empty: all columns of the table
  FmiVersion version = FmiVersion::v3;
  bool si = false; ///< inputs and outputs in m, N, rad, Pa and s, not in the units of the table
};

/// A table as an element for vehicle programs: its axes are inputs, its columns are outputs. It has no
/// states, and it gives directional derivatives. Outside the axes it discards the call and gives no number.
/// Throws InputError for a name that C has not, and for a table that cannot be packed (packed_table.hpp).
Fmu fmu_of(const ContactTable& table, const FmuOptions& options);

} // namespace bem_contact::table
