#pragma once

#include <optional>

namespace bem_contact {

/// exp(-v)
double exponential_fall(double v);

/// Coulomb's coefficient falls with the slip velocity w: mu(w) = mu(0) [ratio + (1 - ratio) fall(w / scale)].
/// theory/contact.md, section 4.
struct FallingFriction {
  double ratio = 1; ///< mu at high slip velocity over mu(0), in (0, 1]; 1: it does not fall
  double scale = 1; ///< slip velocity, mm/s; by an exponential the difference falls over it to 1/e
  double (*fall)(double) = exponential_fall; ///< from 1 at 0 down towards 0

  double factor(double slip_velocity) const; ///< mu(w) / mu(0); mm/s
};

/// mu(w) = mu_kin + mu_1 2^(-w / half), half in mm/s; mu(0) = mu_kin + mu_1.
FallingFriction exponential_friction(double mu_kin, double mu_1, double half);

/// mu(w) = mu_0 [(1 - a) exp(-b w) + a], b in s/m (Polach 2005); mu(0) = mu_0.
FallingFriction polach_friction(double a, double b);

/// Coulomb's coefficient falls with the temperature of the surfaces: linear between two temperatures,
/// constant below and above.
struct HotFriction {
  double ratio = 1;        ///< mu from `to` on over mu up to `from`, in (0, 1]
  double from = 0, to = 1; ///< degrees C

  double factor(double temperature) const; ///< degrees C
};

/// One of the two bodies as a conductor of heat. Defaults: rail steel.
struct ThermalBody {
  double conductivity = 50;   ///< W/(m K)
  double heat_capacity = 450; ///< J/(kg K)
  double density = 7850;      ///< kg/m^3
  double temperature = 0;     ///< before the contact, degrees C

  bool operator==(const ThermalBody&) const = default;
  double effusivity() const; ///< sqrt(lambda rho c), MPa mm/s sqrt(s) / K / mm
};

/// How friction heats the surfaces.
struct Heating {
  ThermalBody rail, wheel;
  /// Share of the frictional heat that flows into the rail; the surfaces may then differ in temperature.
  /// Empty: heat flows so that the surfaces have one temperature where they touch.
  std::optional<double> rail_share;
  std::optional<HotFriction> friction; ///< empty: friction does not depend on it
};

} // namespace bem_contact
