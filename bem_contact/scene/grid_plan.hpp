#pragma once

#include "bem_contact/contact/problem.hpp"
#include "bem_contact/geometry/rail_rows.hpp"

#include <vector>

namespace bem_contact {

/// Which elements are solved for. Row I has its middle at origin + (first + I) ds on the rail's arc length;
/// columns lie symmetric about x_centre. A patch has one plan (PatchGeometry::plan).
struct GridPlan {
  double origin = 0; ///< mm
  int first = 0, rows = 0, columns = 0;
  double dx = 0, ds = 0;                 ///< mm
  double x_centre = 0;                   ///< wheel on rail: whole multiples of dx from the deepest point, mm
  bool grown = false;                    ///< larger than planned at first, because the contact did not fit
  bool cropped = false;                  ///< smaller, because a former solution says where the contact lies
  std::vector<TangentPlane> planes = {}; ///< in which the rows lie (grid.planar); empty: they follow the rail

  double x0() const { return x_centre - 0.5 * (columns - 1) * dx; } ///< of the first column
  ContactGrid grid() const { return {columns, rows, dx, ds, x0()}; }

  double s(int row) const { return origin + (first + row) * ds; }
  double s_from() const { return s(0) - 0.5 * ds; }
  double s_to() const { return s(rows - 1) + 0.5 * ds; }
  std::vector<double> rows_s() const { ///< middles of the rows, mm
    std::vector<double> all(rows);
    for (int i = 0; i < rows; ++i)
      all[i] = s(i);
    return all;
  }
};

} // namespace bem_contact
