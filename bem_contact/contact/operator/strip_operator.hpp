#pragma once

#include "bem_contact/contact/grid/boxes.hpp"
#include "bem_contact/influence/influence_numbers.hpp"

#include <array>
#include <memory>
#include <span>
#include <vector>

namespace bem_contact::contact {

class TransformPool;

/// u = A p on the grid [ms][mx], for some components. The influence numbers depend on x_I - x_J and on both
/// rows: FFT in x, and one real (outputs * ms) x (inputs * ms) matrix for each frequency. The matrix is real
/// because longitudinal tractions and displacements are multiplied by i, where the numbers are odd in x.
/// Translational numbers use FFT in x and s (plane_operator.hpp).
///
/// Fields are component-major: component c of element (ix, is) at (c * ms + is) * mx + ix, in the order of
/// `inputs` and `outputs`. One object, and all that are made with one `pool`, serve one thread at a time.
/// `Real`: double, or float where a few digits are enough.
template <class Real> class BasicStripOperator {
public:
  /// Works on all rows of the numbers.
  BasicStripOperator(const InfluenceNumbers& numbers, int mx, std::vector<int> outputs,
                     std::vector<int> inputs, TransformPool* pool = nullptr);
  /// Works on boxes of the grid; fields [component][box][ms][mx]. Where the numbers are not translational the
  /// boxes have the same columns.
  BasicStripOperator(const InfluenceNumbers& numbers, const Boxes& boxes, std::vector<int> outputs,
                     std::vector<int> inputs, TransformPool* pool = nullptr);
  /// Makes the same operator in another precision.
  template <class Other>
  explicit BasicStripOperator(const BasicStripOperator<Other>& other, TransformPool* pool = nullptr);
  ~BasicStripOperator();
  BasicStripOperator(BasicStripOperator&&) noexcept;
  BasicStripOperator& operator=(BasicStripOperator&&) noexcept;

  /// u(x + columns dx), inputs * ms * mx values to outputs * ms * mx values; needs numbers of mx + columns
  /// offsets, columns <= 2.
  void apply(std::span<const Real> p, std::span<Real> u, int columns = 0) const;

  /// sum_k rolling_step[k] u(x + k dx) (slip_step.hpp). Needs numbers of mx + 2 offsets.
  void apply_step(std::span<const Real> p, std::span<Real> u) const;

  /// BasicPlaneOperator::change_to_steps(). False where the numbers are not translational: nothing changes.
  bool change_to_steps(const std::array<double, 3>& step);

private:
  template <class Other> friend class BasicStripOperator;
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

extern template class BasicStripOperator<double>;
extern template class BasicStripOperator<float>;
using StripOperator = BasicStripOperator<double>;

} // namespace bem_contact::contact
