#pragma once

#include <vector>

namespace bem_contact::fatigue {

/// Damage by fatigue of one passage over T-gamma, N: straight lines between nodes (Burstow, AEA Technology
/// AEATR-ES-2003-832 (2003), the whole life rail model). A crack begins where the damage of all passages
/// sums up to 1. Below the first node there is none. The defaults are public values for rails of grade 220:
/// nothing below 20 N, most at 65 N, none at 175 N. Other steels need other nodes.
struct DamageFunction {
  std::vector<double> t_gamma{20, 65, 175}; ///< N, rising
  std::vector<double> damage{0, 1e-5, 0};   ///< by passage, 1
  /// Above the last node: 0, or the last line goes on, below zero: there wear removes more than cracks grow.
  bool wear_is_negative = false;

  bool operator==(const DamageFunction&) const = default;
};

/// Of one passage, 1.
double damage_of(const DamageFunction& function, double t_gamma);

/// Throws InputError unless there are two nodes or more, finite and rising, each with a damage.
void validate(const DamageFunction& function);

} // namespace bem_contact::fatigue
