#pragma once

#include "bem_contact/app/command.hpp"

#include <optional>
#include <string>
#include <vector>

namespace bem_contact::app {

/// What `bem_contact influence expand` was asked for.
struct ExpandRequest {
  std::vector<std::string> files; ///< one body, or rail and wheel
  double dx = 0, ds = 0;          ///< mm
  int mx = 0, my = 0;             ///< offsets along x, rows
  /// Arc length of the middle of the rows on each body, mm; empty: the middle of its strip.
  std::optional<double> centre, wheel_centre;
  std::string structural = "removed"; ///< removed | included
  std::string format;                 ///< hdf5 | csv | contact; empty: by the ending of `output`
  std::string matrices = "each";      ///< each | one (contact alone)
  std::string output;
};

/// Writes the numbers; returns a line for people. Throws InputError for all that does not fit.
std::string expand_command(const ExpandRequest& request);

/// `bem_contact influence expand FILE ...`.
Command add_influence(CLI::App& program);

} // namespace bem_contact::app
