#pragma once

namespace bem_contact::contact {

/// Finds which part N of a vertical force the pressure bears where inclined shear tractions bear the rest:
/// N + S(N) = force. The sum need not be monotone in N. Where all slips S is proportional to N, so that one
/// look tells the answer. Secants, kept inside a bracket once there is one (after Dekker 1969).
class ForceBalance {
public:
  /// `force` > 0, N.
  explicit ForceBalance(double force) : force_(force) {}

  /// Where to look next after `pressed` (> 0) was seen to bear `borne` = N + S in all.
  double next(double pressed, double borne);

  /// Where so many times the force do not bear it nothing does: friction pulls the bodies together as hard as
  /// they press each other apart.
  static constexpr double most = 30;
  bool at_the_most(double pressed, double borne) const { return pressed >= most * force_ && borne < force_; }

private:
  double force_, last_ = 0, last_borne_ = 0, slope_ = 1;
  double low_ = 0, high_ = 0; ///< too little is borne, and enough; high_ 0: not known
  double step_ = 0, step_before_ = 0;
};

} // namespace bem_contact::contact
