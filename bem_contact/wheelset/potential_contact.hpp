#pragma once

#include "bem_contact/wheelset/undeformed_distance.hpp"

#include <span>
#include <vector>

namespace bem_contact {

/// A Hertz-like estimate of where and how far the bodies touch. Semi-Hertzian method of Kik and Piotrowski
/// (1996): the contact is where they would overlap at 0.55 of the approach.
struct ContactEstimate {
  struct Slice {
    double s = 0;     ///< arc length on the rail, mm
    double delta = 0; ///< rad, track frame
    double gap = 0;   ///< least undeformed distance along x, mm
    double x = 0;     ///< where it is, mm
    double half = 0;  ///< h(x') = gap + half (x' - x)^2, 1/mm
  };
  std::vector<Slice> slices; ///< the whole head, equally spaced
  double approach = 0;       ///< mm
  double force = 0;          ///< vertical, N
  double turn = 0;           ///< turn of the normal within the largest area of contact, rad
};

/// For a vertical force (N) or, with `approach_given`, for an approach (mm).
ContactEstimate estimate_contact(const WheelOnRail& pair, const ContactLocus& locus, const Material& rail,
                                 const Material& wheel, double force, double approach, bool approach_given);

/// Which rows and columns are solved for. Row I has its centre at origin + (first + I) ds on the rail's arc
/// length; columns lie symmetric about x_centre.
struct GridPlan {
  double origin = 0; ///< mm
  int first = 0, rows = 0, columns = 0;
  double dx = 0, ds = 0; ///< mm
  double x_centre = 0;   ///< a whole multiple of dx, mm

  double x0() const { return x_centre - 0.5 * (columns - 1) * dx; } ///< of the first column

  double s(int row) const { return origin + (first + row) * ds; }
  double s_from() const { return s(0) - 0.5 * ds; }
  double s_to() const { return s(rows - 1) + 0.5 * ds; }
};

/// Of the estimated approach: the potential contact when nothing is known of the contact. The estimate's own
/// needs 0.55.
inline constexpr double widest_share = 0.9;

/// How large the estimate says that the contact is, mm, mm^2. In s the sum over all areas.
struct ContactExtent {
  double along_x = 0, along_s = 0, area = 0;
};
ContactExtent contact_extent(const ContactEstimate& estimate);

/// Covers every element whose undeformed distance is under `share` of the estimated approach, or the rows
/// s_from .. s_to and the numbers mx, ms that the scene asks for. `origin`: rows are centred at origin +
/// whole multiples of ds (a station of the rail's influence file).
GridPlan plan_grid(const ContactEstimate& estimate, const SceneFile::Grid& grid, double origin,
                   double share = widest_share);

/// The rail's rows of a plan, in the track frame.
std::vector<ContactRow> rail_rows(const WheelOnRail& pair, const GridPlan& plan);

} // namespace bem_contact
