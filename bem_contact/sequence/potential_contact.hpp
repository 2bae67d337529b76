#pragma once

#include "bem_contact/base/material.hpp"
#include "bem_contact/geometry/rail_rows.hpp"
#include "bem_contact/geometry/rail_slices.hpp"
#include "bem_contact/geometry/undeformed_distance.hpp"
#include "bem_contact/scene/scene_file.hpp"

#include <algorithm>
#include <span>
#include <vector>

namespace bem_contact {

/// A Hertz-like estimate of where and how far the bodies touch. Semi-Hertzian method of Kik and Piotrowski
/// (1996): the contact is where they would overlap at 0.55 of the approach.
///
/// Its centre is that of an elastic foundation (Winkler) under the same load: unlike the point of first touch
/// it moves continuously when a second area takes over the load, and so does all that refers to it.
struct ContactEstimate {
  std::vector<RailSlice> slices; ///< the whole head
  std::vector<double> lift;      ///< of each: vertical force of pressure and shear over that of the pressure
  double approach = 0;       ///< mm
  double force = 0;          ///< vertical, N
  double reach = 0.9;        ///< of the approach: where h is below, the bodies may touch (the estimate's own
                             ///< contact needs 0.55)
  double turn = 0;           ///< turn of the normal within the largest area of contact, rad
  bool touching = false;     ///< else there is no centre
  double s = 0, x = 0;       ///< the centre: arc length on the rail and along x, mm
  double rolling_radius = 0; ///< V / omega at which the mean of w_x under the foundation's pressure is 0, mm
};

/// For a vertical force (N) or, with `approach_given`, for an approach (mm).
ContactEstimate estimate_contact(const WheelOnRail& pair, const ContactLocus& locus, const Material& rail,
                                 const Material& wheel, double force, double approach, bool approach_given);

/// The estimate again, where shear bears its part of the vertical force (`lift` of the slices): on a flange
/// the pressure may be many times what it is without friction. The centre stays. `most`: of the approach.
void estimate_with_shear(ContactEstimate& estimate, const Material& rail, const Material& wheel, double force,
                         double most);

/// One area where the undeformed distance is below what the approach asks for.
struct PotentialArea {
  double s_from = 0, s_to = 0, x_from = 0, x_to = 0; ///< mm
};
/// All of them, h < q cos(delta), along s.
std::vector<PotentialArea> potential_areas(const ContactEstimate& estimate, double q);
/// Those within reach of the estimate's own approach.
std::vector<PotentialArea> potential_areas(const ContactEstimate& estimate);

/// Which rows and columns are solved for. Row I has its centre at origin + (first + I) ds on the rail's arc
/// length; columns lie symmetric about x_centre.
struct GridPlan {
  double origin = 0; ///< mm
  int first = 0, rows = 0, columns = 0;
  double dx = 0, ds = 0; ///< mm
  double x_centre = 0;   ///< a whole multiple of dx, mm

  double x0() const { return x_centre - 0.5 * (columns - 1) * dx; } ///< of the first column

  double s(int row) const { return origin + (first + row) * ds; }
  std::vector<double> rows_s() const {
    std::vector<double> all(rows);
    for (int i = 0; i < rows; ++i)
      all[i] = s(i);
    return all;
  }
  double s_from() const { return s(0) - 0.5 * ds; }
  double s_to() const { return s(rows - 1) + 0.5 * ds; }
};

/// How large the estimate says that the contact is, mm, mm^2. In s the sum over all areas.
struct ContactExtent {
  double along_x = 0, along_s = 0, area = 0;
};
ContactExtent contact_extent(const ContactEstimate& estimate);

/// Covers all areas where h < 0.9 of the estimated approach times cos(delta), with the rows between them:
/// what they do to each other is in the one problem. Or the rows s_from .. s_to and the numbers mx, ms that
/// the scene asks for. `origin`: rows are centred at origin + whole multiples of ds (a station of the rail's
/// influence file).
GridPlan plan_grid(const ContactEstimate& estimate, const SceneFile::Grid& grid, double origin);

/// Widens a plan so that it covers an area.
void cover(GridPlan& plan, const PotentialArea& area);

} // namespace bem_contact
