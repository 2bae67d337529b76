#pragma once

#include "bem_contact/geometry/undeformed_distance.hpp"

#include <vector>

namespace bem_contact {

/// A narrow slice of the rail's head, and the wheel along its normal: h(x') = gap + half (x' - x)^2.
struct RailSlice {
  double s = 0;      ///< arc length on the rail, mm
  double delta = 0;  ///< rad, track frame
  double cosine = 1; ///< of delta
  double gap = 0;    ///< least undeformed distance along x, mm; excluded_gap: 3 mm or more
  double x = 0;      ///< where it is, mm
  double half = 0;   ///< half the curvature along x, > 0, 1/mm
  Point2 position;   ///< on the rail, mm, track frame (WheelOnRail)
  /// Where the wheel comes nearest to it, how much lower than a straight rail an uneven one is, mm.
  double rail_lower = 0;
  double ahead = 0; ///< by how much unevenness moves that place along x, mm

  /// How deep the bodies overlap where they approach by q (along z), mm; < 0: not at all.
  double depth(double q) const { return q * cosine - gap; }
};

/// A row of a rail of sections that meets the locus as a prism, with the relief: the least distance along x,
/// where that is, and half the curvature there. It misses where there is no rail.
RowOnLocus with_relief(const WheelOnRail& pair, const ContactRow& row, const RowOnLocus& prism);

/// The whole head in equally wide slices.
std::vector<RailSlice> slice_rail(const WheelOnRail& pair, const ContactLocus& locus);

} // namespace bem_contact
