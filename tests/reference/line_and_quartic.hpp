#pragma once

/// More contacts without friction in closed form, beside bem_contact/reference/hertz.hpp. All functions throw
/// InputError for arguments that are not finite or not positive.
namespace bem_contact::reference {

/// Two cylinders, plane strain (Johnson 1985, eqs 4.43 to 4.45). Force per length, N/mm.
struct HertzLine {
  double force = 0, half_width = 0, max_pressure = 0;
};
/// `radius`: relative radius, 1/R = 1/R1 + 1/R2 (a hole counts negative).
HertzLine hertz_line_by_force(double radius, double modulus, double force);
HertzLine hertz_line_by_half_width(double radius, double modulus, double half_width);

/// Undeformed distance A r^4 (Steuermann 1939; Johnson 1985, section 5.3): approach = 8/3 A a^4,
/// F = 64/15 E* A a^5.
struct QuarticContact {
  double force = 0, approach = 0, radius = 0;
};
QuarticContact steuermann_by_radius(double coefficient, double modulus, double radius);
QuarticContact steuermann_by_force(double coefficient, double modulus, double force);

} // namespace bem_contact::reference
