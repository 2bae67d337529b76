#pragma once

namespace bem_contact {

/// One total for all that a case may cost, whatever loop it is spent in: elements times products with
/// translational influence numbers, 30 ns each (50 with all that goes with them); what else is done counts as
/// that many of them. No clock: the same case is refused on every machine. The usual case takes 1e6, one of
/// 20,000 elements in contact 4e7, with numbers full in s 7e8.
class WorkBudget {
public:
  explicit WorkBudget(double most = 1e10) : most_(most) {} // some minutes

  /// Throws ConvergenceError where that is more than is left.
  void spend(double elements);
  double used() const { return used_; }

private:
  double most_, used_ = 0;
};

/// Of a product on so many rows, an element: numbers full in s are multiplied row by row.
constexpr double product_work(bool translational, int rows) {
  return translational ? 1.0 : 1.0 + rows / 20.0;
}
/// Of the spectra of numbers full in s, before the first product: `pairs` of components on that many rows and
/// columns. Those of translational numbers cost no more than some products.
constexpr double spectra_work(bool translational, int pairs, double rows, double columns) {
  return translational ? 0.0 : pairs * rows * rows * columns * columns / 75;
}
/// Of a Gauss-Seidel sweep over so many elements.
constexpr double sweep_work(double elements) {
  return 0.08 * elements * elements;
}

} // namespace bem_contact
