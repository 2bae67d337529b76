#pragma once

#include "bem_contact/contact/grid/boxes.hpp"
#include "bem_contact/contact/operator/plane_operator.hpp"
#include "bem_contact/contact/operator/strip_operator.hpp"
#include "bem_contact/contact/slip_step.hpp"
#include "bem_contact/contact/tangential/gcr.hpp"
#include "bem_contact/contact/tangential/settings.hpp"

#include <Eigen/Core>

#include <array>
#include <span>
#include <vector>

namespace bem_contact::contact {

/// The matrix of one rolling step or load step, tangential components:
/// B = sum_k present[k] A(x_I + k dx - x_J) (SlipStep::present), mm/MPa. Its entries between some rows of a
/// grid depend on the offset along x alone: for each pair of rows I, J and components c, d the 2 mx - 1
/// values of offset mx - 1 .. -(mx - 1).
class StepNumbers {
public:
  /// Between these rows of the numbers, for `columns` columns. Below, a row is its place in `rows`.
  StepNumbers(const InfluenceNumbers& numbers, const std::vector<int>& rows, int columns,
              const std::array<double, 3>& present);

  int rows() const { return rows_; }
  int columns() const { return columns_; }
  /// Value at [ix'] is B_cd of the element (ix, row_i) under a load at (ix', row_j).
  const double* line(int ix, int row_i, int c, int row_j, int d) const {
    return &values_[start(row_i, c, row_j, d) + columns_ - 1 - ix];
  }
  /// Value at [t] is B_cd of the element (columns - 1 - t, row_i) under a load at (ix, row_j).
  const double* under_load(int ix, int row_i, int c, int row_j, int d) const {
    return &values_[start(row_i, c, row_j, d) + ix];
  }

private:
  std::size_t start(int row_i, int c, int row_j, int d) const {
    return (((static_cast<std::size_t>(row_i) * rows_ + row_j) * 2 + c) * 2 + d) * (2 * columns_ - 1);
  }
  int rows_, columns_;
  std::vector<double> values_;
};

/// Where some elements of a grid stand among their own rows and columns.
struct ElementPlaces {
  /// `elements`: numbers on a grid with mx columns.
  ElementPlaces(const std::vector<int>& elements, int mx);

  std::vector<int> rows;        ///< of the grid, in the order in which the elements name them
  int first_column, columns;    ///< of the grid
  std::vector<int> row, column; ///< of each element: place in `rows`; column less first_column
};

/// B (StepNumbers) on boxes around the contact, and approximate inverses of it in single precision.
/// Fields are [2][boxes.rows()][boxes.mx()], x before s.
class StepBox {
public:
  /// `present`: the weights of the step (SlipStep::present).
  StepBox(const InfluenceNumbers& numbers, const Boxes& boxes, const std::array<double, 3>& present,
          TransformPool* pool = nullptr);

  const Boxes& boxes() const { return boxes_; }
  int size() const { return boxes_.size(); } ///< of one component

  /// out = B in
  void step(std::span<const double> in, std::span<double> out) const;
  void step(std::span<const float> in, std::span<float> out) const;

  /// out = about B_SS^-1 in, S the elements whose `sticks` is set; zero elsewhere, in `in` as well.
  ///
  /// B = D A with D = sum_k present[k] (x + k dx), x and s apart. Where S ends ahead, at the leading edge,
  /// the inverse is nearly exact: A_behind^-1, then D^-1 from that edge on, then A_ahead^-1, each on S alone.
  void invert(const std::vector<char>& sticks, std::span<const float> in, std::span<float> out) const;

  /// Approximates (shift + stiffness B)^-1, x and s apart: what slips obeys such a matrix along its own
  /// bound, where the shift damps so well that borders need no respect.
  class DampedInverse {
  public:
    explicit DampedInverse(const StepBox& box);
    /// Takes new values, without allocating.
    void set(const StepBox& box, double shift, double stiffness);
    void apply(const StepBox& box, std::span<const float> in, std::span<float> out) const;

  private:
    std::vector<BasicPlaneOperator<float>> inverse_; ///< of x and of s
  };

private:
  /// Of x and of s, each box by itself. `from` and `to` may be the same.
  void apply_each(const std::vector<BasicPlaneOperator<float>>& of, std::span<const float> from,
                  std::span<float> to) const;
  template <class Real>
  void step_by(const BasicStripOperator<Real>& a, std::span<const Real> in, std::span<Real> out) const;

  Boxes boxes_;
  std::array<double, 3> present_;
  StripOperator tt_;
  BasicStripOperator<float> fast_;                                   ///< of B, or of A as tt_
  bool fast_has_steps_;                                              ///< of B
  std::vector<BasicPlaneOperator<float>> behind_, ahead_, periodic_; ///< of A_xx, A_ss
};

/// An element as the preconditioner sees it (box_jacobian.hpp): J is not the identity in the direction of
/// `along`, and there its inverse is about `after` X `before` with the inverse X of a matrix alike
/// everywhere.
struct PreconditionedElement {
  int number; ///< among the elements in contact
  Eigen::Matrix2f along;
  float before, after;
};

/// Scratch of Newton's linear systems on a StepBox, allocated once for all iterations.
struct StepBoxScratch {
  explicit StepBoxScratch(const StepBox& box);

  std::vector<char> sticks;
  std::vector<PreconditionedElement> sticking, slipping; ///< elements in contact
  std::vector<double> in, out;
  std::vector<float> fast_in, fast_out;
  StepBox::DampedInverse damped;
  Gcr gcr{{kept_solutions, kept_directions}};
};

} // namespace bem_contact::contact
