#pragma once

namespace bem_contact {

/// One total for all that a case may cost, whatever loop it is spent in: elements times products with the
/// influence numbers (a sweep over n elements in contact counts as n / 100 products). No clock: the same case
/// is refused on every machine. The usual case takes 1e6, one of 20,000 elements in contact 1e7.
class WorkBudget {
public:
  explicit WorkBudget(double most = 3e9) : most_(most) {} // some minutes

  /// Throws ConvergenceError where that is more than is left.
  void spend(double elements);
  double used() const { return used_; }

private:
  double most_, used_ = 0;
};

} // namespace bem_contact
