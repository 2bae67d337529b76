#pragma once

#include "bem_contact/halfspace/stress.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace bem_contact::shakedown {

/// Stress that is in a body without any wheel: residual stress of its making, or thermal stress. It does not
/// vary along the track. A table over arc length and depth; between its lines it is linear along both, and
/// beyond them it is that of the nearest line.
class InitialStress {
public:
  /// Arc lengths and depths, mm, rising; values [s][depth], MPa. Throws InputError for values that do not
  /// fit.
  InitialStress(std::vector<double> s, std::vector<double> depths, std::vector<halfspace::Stress> values,
                std::string name = {});

  halfspace::Stress at(double s, double depth) const;
  const std::string& name() const { return name_; } ///< of its file; "": none

  bool operator==(const InitialStress&) const = default;

private:
  std::vector<double> s_, depths_;
  std::vector<halfspace::Stress> values_;
  std::string name_;
};

/// Reads a CSV table with the columns depth (mm), perhaps s (arc length, mm), and any of xx, ss, nn, xs, xn,
/// sn (MPa, tension positive, frame of the surface above); the others are 0. With s, each arc length has the
/// same depths. Throws InputError for what is no such table, or has a traction on the surface.
InitialStress read_initial_stress(const std::filesystem::path& file);

} // namespace bem_contact::shakedown
