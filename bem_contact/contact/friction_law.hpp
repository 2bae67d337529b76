#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

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

/// Friction follows a slip velocity that changes over a distance of slip, which asperities need to form anew.
struct FrictionMemory {
  double distance = 0;       ///< of slip over which a difference falls to 1/e, mm
  double least_velocity = 1; ///< mm/s; what hardly slips forgets as fast as at this slip velocity

  double rate(double slip_velocity) const {
    return std::max(slip_velocity, least_velocity) / distance;
  } ///< 1/s
};

/// Coulomb's coefficient falls with the temperature of the surfaces: linear between two temperatures,
/// constant below and above.
struct HotFriction {
  double ratio = 1;        ///< mu from `to` on over mu up to `from`, in (0, 1]
  double from = 0, to = 1; ///< degrees C

  double factor(double temperature) const; ///< degrees C
};

/// A layer between the surfaces yields: it bears a shear traction of tau(w) = shear + hardening w at the
/// most, where w is its plastic slip so far (plastic_slip.hpp). theory/contact.md, section 6.
struct YieldLimit {
  double shear = 0;     ///< tau_0, above 0, MPa; the largest where it depends on temperature
  double hardening = 0; ///< MPa/mm; below 0 the layer softens, until it bears nothing
  /// tau_0 (MPa) over the mean temperature of both surfaces (degrees C, rising): linear in between, constant
  /// below and above; empty: `shear` at every temperature.
  std::vector<double> temperatures = {}, shears = {};

  double at(double temperature) const; ///< tau_0, MPa; degrees C
  bool softens_by_heat() const;        ///< it has several values
  double least() const;                ///< tau_0 of the hottest layer, MPa
  bool operator==(const YieldLimit&) const = default;
};

/// "yields at 200 MPa, and hardens by 435 MPa/mm", "yields at 200 MPa (20 degrees C) to 60 MPa (400)".
std::string yield_text(const YieldLimit& limit);

/// How one element of such a layer answers to a step. Friction and yield are one law of p_t and slip S, and
/// p_t = min(bound, reach) along p_t + r S, with reach = |p_t + r S| and any r > 0 (MPa/mm).
struct LayerAnswer {
  double bound = 0;    ///< on |p_t|, of friction and layer, MPa
  double plastic = 0;  ///< plastic slip after the step, mm
  bool yields = false; ///< the layer sets the bound, and slip is plastic slip
  double rise = 0;     ///< d bound / d reach
  double kept = 1;     ///< d tau / d tau(before): of what the layer bears after the step, by that before it
};

/// What an element is, whatever it bears.
struct LayerElement {
  double before = 0;    ///< plastic slip that it has unless it slips in this step, mm
  double friction = 0;  ///< mu p_n, MPa
  double stiffness = 1; ///< r, MPa/mm; above -hardening / weight
  double weight = 1;    ///< the plastic slip of a step is `weight` times what `plastic` is above `before`
};
LayerAnswer answer(const YieldLimit& limit, const LayerElement& element, double reach);

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
