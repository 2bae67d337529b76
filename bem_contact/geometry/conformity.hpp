#pragma once

#include "bem_contact/geometry/contact_search.hpp"

#include <optional>
#include <string_view>

namespace bem_contact {

/// How closely a wheel fits its rail: classes of Magel and Kalousek (Wear 253 (2002) 308) by the largest
/// distance of the surfaces between the touching point and the gauge point.
enum class Fit { closely_conformal, conformal, not_conformal };
std::string_view words_of(Fit fit); ///< "closely conformal"

/// The fit of wheel and rail beside the place where they touch first, as rigid bodies without yaw. All
/// distances are along the rail's normal, in the plane of the profiles.
struct Conformity {
  double lateral = 0;                ///< position.lateral of the wheelset, mm
  double rail_s = 0, wheel_s = 0;    ///< where they touch, arc length on either profile, mm
  double delta = 0;                  ///< inclination of the rail there, rad
  double end_s = 0;                  ///< the gauge point, or 20 mm of arc length from the touching point, mm
  double largest = 0, largest_s = 0; ///< distance between these two, and where on the rail, mm
  double width = 0;                  ///< arc length around the touching point with less than 0.1 mm, mm
  double turn = 0;                   ///< of the rail's normal over that width, rad
  /// Mean radii over that width, mm; > 0 convex, < 0 concave, infinite: straight.
  double rail_radius = 0, wheel_radius = 0;

  Fit fit() const;
  /// The rail's radius over the wheel's: 1 where a concave wheel fits exactly, 0 for a straight wheel, < 0
  /// for a convex one.
  double ratio() const { return -rail_radius / wheel_radius; }
};

/// Of a wheel that is lowered until it touches at `touch`, without yaw. `gauge_height`: of the gauge point
/// below the top of the rail, mm.
Conformity conformity(const WheelOnRail& pair, const TouchPoint& touch, double gauge_height);

/// The same where the wheelset of `position` stands, without its yaw. Throws what lower_to_touch() throws.
Conformity conformity_at(const WheelsetPosition& position, const TabulatedProfile& rail,
                         const TabulatedProfile& wheel);

/// The same where the flange root comes to the gauge corner: at the smallest displacement beyond which the
/// touching point is inclined by more than half the largest inclination of the wheel's flange. The wheel
/// still touches on the tread side there. Nothing where no displacement does that.
std::optional<Conformity> conformity_at_flange(const WheelsetPosition& position, const TabulatedProfile& rail,
                                               const TabulatedProfile& wheel);

} // namespace bem_contact
