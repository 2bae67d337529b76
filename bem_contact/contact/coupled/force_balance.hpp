#pragma once

#include <limits>

namespace bem_contact::contact {

/// Splits a vertical force between pressure and inclined shear tractions.
///
/// On a steep flange friction carries part of the load. If the pressure carries N, the shear tractions carry
/// S(N), and we look for N + S(N) = force. S depends on N through a whole tangential problem, and N + S(N)
/// need not increase with N. Secant steps find it; they stay inside a bracket as soon as one is known (after
/// Dekker 1969). If all elements slip, S is proportional to N and one evaluation is enough.
class ForceBalance {
public:
  /// `force` > 0, N.
  explicit ForceBalance(double force) : force_(force) {}

  /// The pressure force to try first, from a start near the solution: its pressure carries `pressed` (> 0),
  /// and with its shear tractions `borne`. Shear then is taken to grow no faster than least_start_slope says.
  double start(double pressed, double borne);

  /// The pressure force to try after `pressed` (> 0) was seen to carry `borne` = N + S, N.
  double next(double pressed, double borne);

  /// Says whether the largest pressure force that is tried (settings.hpp: largest_force_ratio) does not carry
  /// the force. Then nothing does: friction pulls the bodies together as hard as they press each other apart.
  bool at_the_most(double pressed, double borne) const;

private:
  double force_, last_ = 0, last_borne_ = 0, slope_ = 0;
  double least_slope_ = -std::numeric_limits<double>::infinity(); ///< of the first secant
  double low_ = 0, high_ = 0; ///< carries too little, and enough; high_ 0: not known
  double step_ = 0, step_before_ = 0;
};

} // namespace bem_contact::contact
