#pragma once

#include "bem_contact/contact/grid/boxes.hpp"
#include "bem_contact/influence/influence_numbers.hpp"

#include <array>
#include <memory>
#include <span>
#include <vector>

namespace bem_contact::contact {

class TransformPool;

/// u = A p on a grid [ms][mx] for numbers that depend on x_I - x_J and s_I - s_J alone: FFT in x and in s,
/// one small complex matrix (outputs x inputs) a pair of frequencies. Fields as for StripOperator, to which
/// this belongs. What is made with one `pool` shares transforms and serves one thread at a time. `Real`:
/// double, or float where a few digits are enough.
template <class Real> class BasicPlaneOperator {
public:
  /// Of numbers that are not translational the pairs of rows about row `middle` stand for all that are
  /// equally far apart.
  /// `periodic`: the transforms are hardly longer than the grid, its ends feel each other: a quarter of the
  /// work, good enough for a preconditioner.
  enum class Form { exact, periodic };
  BasicPlaneOperator(const InfluenceNumbers& numbers, int mx, int ms, std::vector<int> outputs,
                     std::vector<int> inputs, Form form = Form::exact, int middle = 0,
                     TransformPool* pool = nullptr);
  /// On several boxes at once, which act on each other (exact); fields [component][box][ms][mx].
  BasicPlaneOperator(const InfluenceNumbers& numbers, const Boxes& boxes, const std::vector<int>& outputs,
                     const std::vector<int>& inputs, TransformPool* pool = nullptr);
  /// The same in another precision.
  template <class Other>
  explicit BasicPlaneOperator(const BasicPlaneOperator<Other>& other, TransformPool* pool = nullptr);
  explicit BasicPlaneOperator(const BasicPlaneOperator& other);
  ~BasicPlaneOperator();
  BasicPlaneOperator(BasicPlaneOperator&&) noexcept;
  BasicPlaneOperator& operator=(BasicPlaneOperator&&) noexcept;

  void apply(std::span<const Real> p, std::span<Real> u, int columns) const;
  void apply_step(std::span<const Real> p, std::span<Real> u) const;

  /// Turns this (one component) into an approximate inverse of A, for preconditioning: the inverse of the
  /// periodic operator, which knows nothing of the border of the contact.
  void invert();

  /// The same of one of the two factors of A: A = A_ahead A_behind, where A_behind p at x depends on p at
  /// <= x alone and A_ahead on p at >= x. Between them a border across x can be respected (Wiener, Hopf
  /// 1931).
  enum class Factor { behind, ahead };
  void invert_factor(Factor factor);

  /// The inverse of `shift` + scale sum_k step[k] A(x + k dx), A that of `of` (one component, periodic, made
  /// positive), which this was made from.
  void invert_shifted(const BasicPlaneOperator& of, Real shift, Real scale,
                      const std::array<double, 3>& step);

private:
  template <class Other> friend class BasicPlaneOperator;
  struct Impl;
  void prepare(int mx, int ms, int outputs, int inputs, Form form, TransformPool* pool);
  std::unique_ptr<Impl> impl_;
};

extern template class BasicPlaneOperator<double>;
extern template class BasicPlaneOperator<float>;
using PlaneOperator = BasicPlaneOperator<double>;

} // namespace bem_contact::contact
