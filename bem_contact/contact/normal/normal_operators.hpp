#pragma once

#include "bem_contact/contact/grid/boxes.hpp"
#include "bem_contact/contact/normal/bordered_factor.hpp"
#include "bem_contact/contact/normal/normal_lines.hpp"
#include "bem_contact/contact/operator/plane_operator.hpp"
#include "bem_contact/contact/operator/plane_transforms.hpp"
#include "bem_contact/contact/operator/strip_operator.hpp"
#include "bem_contact/contact/work.hpp"

#include <Eigen/Core>

#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace bem_contact::contact {

/// A_nn on boxes around the active set and an approximate inverse of it. Conjugate gradients run in single
/// precision and correct a solution that is kept in double precision.
struct NormalBox {
  NormalBox(const InfluenceNumbers& numbers, const Boxes& boxes, TransformPool* pool = nullptr);

  Boxes boxes;
  StripOperator nn;
  BasicStripOperator<float> fast;
  BasicPlaneOperator<float> inverse;

  /// out = about A^-1 in, each box by itself.
  void invert(std::span<const float> in, std::span<float> out) const;
  /// Writes a field on the boxes into the field of the grid.
  void copy_to_grid(std::span<const double> from, int grid_mx, Eigen::VectorXd& field) const;
};

/// Scratch of conjugate gradients: fields on the boxes, allocated once for all iterations.
struct NormalBoxVectors {
  std::vector<double> p, u;         ///< pressure and A p
  std::vector<float> x, r, z, d, q; ///< x corrects p
  std::vector<int> local;           ///< places of the active elements on the boxes

  void resize(int size);
};

/// What is prepared of A_nn, for one set of influence numbers on one grid: every call gives the same numbers
/// and the same grid. Each operator is made when it is first asked for; it is complete then and stays as it
/// is. Serves one thread at a time.
class NormalOperators {
public:
  explicit NormalOperators(std::shared_ptr<TransformPool> pool = std::make_shared<TransformPool>());

  /// The next linear system has a factor of its own elements.
  void forget_solutions() { borders_ = false; }
  /// Returns the operator on the whole grid.
  const StripOperator& whole(const InfluenceNumbers& numbers, int mx, WorkBudget& work);
  const NormalLines& lines(const InfluenceNumbers& numbers, int mx);
  /// Returns the operator on boxes around these elements. The former boxes are used again while they serve.
  const NormalBox& box_around(const std::vector<int>& elements, const InfluenceNumbers& numbers,
                              const ContactGrid& grid, WorkBudget& work);
  NormalBoxVectors& vectors() { return vectors_; }
  /// right := A_CC^-1 right on these elements, in rising order, two columns; false where A_CC is not positive
  /// definite. The contact area settles long before the forces do. So the factor is used again, and for the
  /// same elements also the second column, the response to a unit approach, where it is the same.
  bool solve_dense(const std::vector<int>& elements, const InfluenceNumbers& numbers, int mx,
                   Eigen::MatrixXd& right);

private:
  struct UnitResponse {
    Eigen::VectorXd unit, response; ///< the second column and its solution
  };
  std::shared_ptr<TransformPool> pool_;
  std::optional<StripOperator> whole_;
  std::optional<NormalLines> lines_;
  std::optional<NormalBox> box_;
  std::optional<BorderedFactor> factor_;
  bool borders_ = false; ///< whether a factor of other elements may be bordered
  UnitResponse unit_;    ///< by factor_ as it is
  NormalBoxVectors vectors_;
};

} // namespace bem_contact::contact
