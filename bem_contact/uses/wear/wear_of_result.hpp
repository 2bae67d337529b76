#pragma once

#include "bem_contact/uses/wear/law.hpp"

#include <vector>

namespace bem_contact {
struct SceneResult;
}

namespace bem_contact::wear {

/// Depth along the profile of one body, along its normal.
struct DepthOverS {
  std::vector<double> s;     ///< arc length of the middle of each row on this body, mm
  std::vector<double> depth; ///< mm
  double width = 0;          ///< of every row, mm: the same material leaves both bodies

  /// Area of the section that is gone, sum of depth times width, mm^2.
  double area() const;
};

/// Where the rows of a contact lie on a rail of sections: at the middle of their pressure, by row.
struct RowsOnSections {
  std::vector<double> u; ///< place along the track, mm
  std::vector<int> body; ///< which of the bodies, from 0
  std::vector<double> t; ///< on that body's surface (SectionedSurface), mm
};

/// What one contact wears away. Fields are [ms][mx] on the grid of the result.
struct Wear {
  std::vector<double> rate; ///< depth per mm of rolled distance, mm/mm; field
  std::vector<double>
      sliding_distance;           ///< of a point of the surface on its way through the element, mm; field
  DepthOverS rail;                ///< by one passage of this wheel
  DepthOverS wheel;               ///< by one revolution; empty where the result does not know its stations
  RowsOnSections on_sections;     ///< of a rail of sections: where its rows lie; else empty
  double volume_per_distance = 0; ///< off each body, by rolled distance, mm^3/mm
  std::vector<double> sliding_over_s; ///< sliding distance of each row in one passage, mm
};

/// Wear of a steady rolling contact. A point of the rail passes through a row of elements once in a passage,
/// a point of the wheel once in a revolution: both lose the sum of rate dx over their row. Throws InputError
/// for a law that validate() refuses, and for a result that does not roll steadily, or has no friction;
/// ConvergenceError for one that is not certified().
Wear wear_of(const SceneResult& result, const Law& law);

} // namespace bem_contact::wear
