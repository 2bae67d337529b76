#pragma once

#include "bem_contact/profile/worn/nominal_place.hpp"

#include <optional>

/// The numbers by which workshops and track gangs judge profiles. EN 15313 limits those of wheels. Their
/// definitions: Greenwood Engineering, "Standard calculations of MiniProf" (greenwood.dk,
/// miniprofstandardcalc), wheel wear and rail wear.
namespace bem_contact {

/// Numbers of a wheel's flange, mm. The tread's height counts at the tape circle.
struct FlangeNumbers {
  double Sh = 0; ///< height of the tip above the tread
  double Sd = 0; ///< thickness: from the flange back to the face, 10 mm above the tread
  double qR = 0; ///< across, from that place on the face to the one 2 mm below the tip: its steepness
};

/// None where the curve has no whole flange, or does not reach the tape circle. `tape_circle`: its distance
/// from the flange back, mm. The curve's y = 0 is at the tape circle.
std::optional<FlangeNumbers> flange_numbers(const ProfileCurve& wheel, double tape_circle);

/// Wear of a rail's head, mm: by how much its surface lies inside that of the nominal profile, as that lies
/// on the unworn part and stands upright.
struct HeadWear {
  double W1 = 0; ///< down, on the axis of the nominal profile
  double W2 = 0; ///< across, on the gauge side, head_wear_depth below the top of the nominal profile
  double W3 = 0; ///< at 45 degrees, through the corner of the upright tangent there and the level one on top
};

/// mm. The gauge is measured so far below the top (EN 13848-1).
inline constexpr double head_wear_depth = 14.0;

/// None where the rail does not reach so far down.
std::optional<HeadWear> head_wear(const ProfileCurve& rail, const ProfileCurve& nominal,
                                  const NominalPlace& place);

} // namespace bem_contact
