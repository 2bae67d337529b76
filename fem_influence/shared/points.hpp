#pragma once

#include "bem_contact/base/conventions.hpp"

#include <deal.II/base/point.h>

#include <array>

namespace bem_contact::fem {

/// deal.II's points as the project's, and back, mm. Those of a section are (y, z).
inline Point2 plain(const dealii::Point<2>& p) {
  return {p[0], p[1]};
}
inline std::array<double, 3> plain(const dealii::Point<3>& p) {
  return {p[0], p[1], p[2]};
}
inline dealii::Point<3> point(const std::array<double, 3>& p) {
  return {p[0], p[1], p[2]};
}

} // namespace bem_contact::fem
