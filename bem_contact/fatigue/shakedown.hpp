#pragma once

/// What rolling contact fatigue reads off a contact.
namespace bem_contact::fatigue {

/// Where a contact lies in the shakedown diagram (Johnson 1985, section 9.2).
struct ShakedownPoint {
  double load = 0;     ///< p0 / k, the largest pressure over the yield stress in shear
  double traction = 0; ///< mu used: the resultant of shear over the normal force
};

/// FI_surf = mu used - k / p0 (Ekberg, Kabo and Andersson, Fatigue Fract. Eng. Mater. Struct. 25 (2002) 899):
/// above 0 the surface flows cycle after cycle, and fatigues. Throws InputError unless p0/k >
/// 0.
double surface_index(const ShakedownPoint& point);

/// An elliptical contact after Hertz, its load and shear.
struct HertzPatch {
  double a = 0, b = 0;     ///< semi-axes, mm
  double normal_force = 0; ///< N
  double shear_force = 0;  ///< resultant, N
};

/// The point of a Hertz contact, p0 = 3 Fz / (2 pi a b): its index is mu used - 2 pi a b k / (3 Fz). Throws
/// InputError for what is not positive (shear may be 0).
ShakedownPoint shakedown_point(const HertzPatch& patch, double yield_shear);

/// FI of an element that bears no pressure. The map of Ekberg et al. is not read below it.
inline constexpr double least_element_index = -0.5;

/// FI of one element, from its own tractions: (|p_t| - k) / p_n, or least_element_index if that is more.
/// p_n > 0, MPa.
double element_index(double shear_traction, double pressure, double yield_shear);

/// Throws InputError unless the yield stress in shear is positive.
void require_yield_shear(double yield_shear);

} // namespace bem_contact::fatigue
