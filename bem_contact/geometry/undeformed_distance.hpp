#pragma once

#include "bem_contact/geometry/contact_locus.hpp"
#include "bem_contact/geometry/settings.hpp"
#include "bem_contact/profile/contact_row.hpp"

#include <span>
#include <vector>

namespace bem_contact {

/// Undeformed distance given to an element whose normal misses the other body, mm: far beyond any approach.
inline constexpr double excluded_gap = 100.0;

/// Says where the normal of a row meets the contact locus, that is, the wheel at the x at which it is
/// nearest.
struct RowOnLocus {
  double distance = excluded_gap; ///< along the rail's normal, mm
  double x = 0;                   ///< mm
  double wheel_s = 0;             ///< arc length on the wheel's profile, mm
  double half = 0;                ///< 1/mm: around x, at x', the distance is about distance + half (x' - x)^2
  double rail_lower = 0;          ///< ContactLocus::Point, mm
  double ahead = 0;               ///< ContactLocus::Point, mm
  bool hit() const { return distance < excluded_gap; }
};
/// Rows farther than `farthest` (mm) from the locus miss it.
std::vector<RowOnLocus> rows_on_locus(const ContactLocus& locus, std::span<const ContactRow> rows,
                                      double farthest = farthest_row);

/// Undeformed distance along the rail's normal n from the rail to the exact wheel surface of revolution, mm;
/// field [rows][x]. An element whose normal misses the wheel gets excluded_gap. So does every element of a
/// row that misses the locus or is farther than farthest_row from it (rows_on_locus()). At x the rolled and
/// yawed wheel is cut by the plane x = const, and the normal intersected with that section (no quadratic
/// approximation); on a roller by the half-plane through its axis that holds the element. The relief of a
/// rail of sections is added; where there is no rail the element gets excluded_gap. `on_locus`:
/// rows_on_locus() of the same rows.
std::vector<double> undeformed_distance(const WheelOnRail& pair, std::span<const RowOnLocus> on_locus,
                                        std::span<const ContactRow> rows, std::span<const double> x);

/// Arc length of the point of the wheel's profile whose locus, seen along x, is nearest to each row, mm.
std::vector<double> wheel_stations(const ContactLocus& locus, std::span<const ContactRow> rows);

} // namespace bem_contact
