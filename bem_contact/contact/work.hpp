#pragma once

#include "bem_contact/base/stopped.hpp"

#include <atomic>

namespace bem_contact {

/// The work that one case may cost in all its loops together. One unit is one element in one product with
/// translational influence numbers, about 30 ns (50 ns with everything around it); every other operation
/// counts as the units that it costs. No clock is used, so that every machine accepts or refuses the same
/// cases. A usual case takes 1e6 units, one with 20,000 elements in contact 4e7, and with influence numbers
/// that depend on both rows 7e8.
class WorkBudget {
public:
  WorkBudget(); ///< settings.hpp: most_work
  /// A budget of this many units.
  explicit WorkBudget(double most) : most_(most) {}
  /// The usual budget, which ends when another thread sets `stop`. Null: nobody does.
  explicit WorkBudget(const std::atomic<bool>* stop);

  /// Throws ConvergenceError if less than `units` are left, Stopped if `stop` is set.
  void spend(double units);
  double used() const { return used_; } ///< units so far
  /// A usual budget of its own, which the same `stop` ends.
  WorkBudget another() const { return WorkBudget(stop_); }

private:
  double most_, used_ = 0;
  const std::atomic<bool>* stop_ = nullptr;
};

/// Units for one element in a product with influence numbers of `rows` rows. Numbers that depend on both rows
/// are multiplied row by row.
double product_work(bool translational, int rows);
/// Units for the spectra of influence numbers that depend on both rows, before the first product: `pairs` of
/// components, on that many rows and columns. Those of translational numbers cost no more than some products.
double spectra_work(bool translational, int pairs, double rows, double columns);
/// Units for a Gauss-Seidel sweep over so many elements.
double sweep_work(double elements);

} // namespace bem_contact
