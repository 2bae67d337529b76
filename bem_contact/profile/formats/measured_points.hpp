#pragma once

#include "bem_contact/base/conventions.hpp"

#include <vector>

namespace bem_contact {

/// The points of a profile file on their way into the frame of ProfileCurve, in the order of the file.
struct MeasuredPoints {
  std::vector<Point2> points; ///< mm; in the unit of the file until it is known
  double y_sign = 1;          ///< -1 where y points against that of the file
  bool axes_stated = false;   ///< the format says where y and z point: the shape does not decide
};

} // namespace bem_contact
