#pragma once

#include "bem_contact/base/material.hpp"

#include <array>
#include <cstddef>
#include <map>
#include <vector>

namespace bem_contact::halfspace {

/// Keeps lines of half-space numbers: a line is the numbers of two rows at all offsets, and depends on
/// material, dx, ds and the distance of the rows alone. So one line serves many strips, bodies and cases.
/// What is kept changes no number. It serves one thread at a time.
class LineStore {
public:
  /// Rows of width `ds` at the distance `s`, mm; elements `dx` long, mm; at least `offsets` offsets. Valid
  /// until the next call.
  struct Line {
    const double* values = nullptr; ///< [i][j][offset], mm/MPa
    std::size_t offsets = 0;
  };
  Line get(const Material& material, double s, double dx, double ds, std::size_t offsets);
  std::size_t size() const { return kept_.size(); } ///< lines that are kept

private:
  std::map<std::array<double, 5>, std::vector<double>> kept_;
};

} // namespace bem_contact::halfspace
