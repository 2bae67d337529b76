#pragma once

#include "bem_contact/contact/grid/boxes.hpp"
#include "bem_contact/influence/influence_numbers.hpp"

#include <array>
#include <memory>
#include <span>
#include <vector>

namespace bem_contact::contact {

class TransformPool;

/// u = A p on a grid [ms][mx] for influence numbers that depend on x_I - x_J and s_I - s_J alone: FFT in x
/// and in s, and one small complex matrix (outputs x inputs) for each pair of frequencies. Fields are those
/// of StripOperator, which uses this class. Operators that are made with one `pool` share their transforms
/// and the scratch of these, and serve one thread at a time. `Real`: double, or float where a few digits are
/// enough.
template <class Real> class BasicPlaneOperator {
public:
  /// `periodic`: the transforms are hardly longer than the grid, so that its ends act on each other. That is
  /// a quarter of the work and good enough for a preconditioner.
  enum class Form { exact, periodic };
  /// Works on boxes that act on each other; fields [component][box][ms][mx]. If the numbers are not
  /// translational, the pairs of rows about the middle of the first box stand for all pairs at the same
  /// distance.
  BasicPlaneOperator(const InfluenceNumbers& numbers, const Boxes& boxes, const std::vector<int>& outputs,
                     const std::vector<int>& inputs, Form form = Form::exact, TransformPool* pool = nullptr);
  /// Makes the same operator in another precision.
  template <class Other>
  explicit BasicPlaneOperator(const BasicPlaneOperator<Other>& other, TransformPool* pool = nullptr);
  explicit BasicPlaneOperator(const BasicPlaneOperator& other);
  ~BasicPlaneOperator();
  BasicPlaneOperator(BasicPlaneOperator&&) noexcept;
  BasicPlaneOperator& operator=(BasicPlaneOperator&&) noexcept;

  void apply(std::span<const Real> p, std::span<Real> u, int columns) const;
  void apply_step(std::span<const Real> p, std::span<Real> u) const;

  /// Changes this operator to sum_k step[k] A(x + k dx). In single precision that has more digits than
  /// apply_step(), whose terms cancel: on a line of hundreds of elements they are thousands of times as large
  /// as their sum.
  void change_to_steps(const std::array<double, 3>& step);

  /// Changes this operator (one component) to an approximate inverse of A, for preconditioning: the inverse
  /// of the periodic operator, which knows nothing of the border of the contact.
  void invert();

  /// Does the same for a factor of A = A_ahead A_behind (Wiener, Hopf 1931). A_behind p at x depends only on
  /// p behind x and at it, A_ahead p only on p ahead and at it. Between the two factors a border across x can
  /// be respected.
  void invert_behind();

  /// Changes this operator to its mirror image, whose numbers are those at -x, -s: the inverse of A_behind to
  /// that of A_ahead.
  void mirror();

  /// The inverse of `shift` + scale sum_k step[k] A(x + k dx), A that of `of` (one component, periodic, made
  /// positive), which this was made from.
  void invert_shifted(const BasicPlaneOperator& of, Real shift, Real scale,
                      const std::array<double, 3>& step);

private:
  template <class Other> friend class BasicPlaneOperator;
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

extern template class BasicPlaneOperator<double>;
extern template class BasicPlaneOperator<float>;
using PlaneOperator = BasicPlaneOperator<double>;

} // namespace bem_contact::contact
