#pragma once

#include "bem_contact/influence/influence_numbers.hpp"

#include <array>
#include <memory>
#include <span>
#include <vector>

namespace bem_contact::contact {

/// u = A p on a grid [ms][mx] for numbers that depend on x_I - x_J and s_I - s_J alone: FFT in x and in s,
/// one small complex matrix (outputs x inputs) a pair of frequencies. Fields as for StripOperator, to which
/// this belongs. One object serves one thread at a time.
class PlaneOperator {
public:
  /// Of numbers that are not translational the pairs of rows about row `middle` stand for all that are
  /// equally far apart.
  PlaneOperator(const InfluenceNumbers& numbers, int mx, int ms, std::vector<int> outputs,
                std::vector<int> inputs, int middle = 0);
  ~PlaneOperator();
  PlaneOperator(PlaneOperator&&) noexcept;
  PlaneOperator& operator=(PlaneOperator&&) noexcept;

  void apply(std::span<const double> p, std::span<double> u, int columns) const;
  void apply_step(std::span<const double> p, std::span<double> u) const;

  /// Turns this into an approximate inverse of A (or of sum_k step[k] A(x + k dx)), for preconditioning: the
  /// inverse of the periodic operator, which knows nothing of the border of the contact. What rolls endlessly
  /// without change has no slip: `damping` is added to the symbol of the step, as if tractions were forgotten
  /// over 1/damping elements.
  void invert();
  void invert_step(const std::array<double, 3>& step, double damping);

private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

} // namespace bem_contact::contact
