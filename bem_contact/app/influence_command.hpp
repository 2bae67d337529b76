#pragma once

#include <string>
#include <vector>

namespace bem_contact::app {

/// What `bem_contact influence expand` was asked for; see influence_help().
struct ExpandRequest {
  std::vector<std::string> files; ///< one body, or rail and wheel
  double dx = 0, ds = 0;          ///< mm
  int mx = 0, my = 0;             ///< offsets along x, rows
  bool has_centre = false, has_wheel_centre = false;
  double centre = 0, wheel_centre = 0; ///< arc length of the middle of the rows on each body, mm
  std::string structural = "removed";  ///< removed | included
  std::string format;                  ///< hdf5 | csv | contact; empty: by the ending of `output`
  std::string matrices = "each";       ///< each | one (contact alone)
  std::string output;
};

/// Writes the numbers; returns a line for people. Throws InputError for all that does not fit.
std::string expand_command(const ExpandRequest& request);

/// The tutorial below `bem_contact influence --help`.
std::string influence_help();

} // namespace bem_contact::app
