#pragma once

#include "bem_contact/contact/grid/boxes.hpp"
#include "bem_contact/contact/operator/plane_operator.hpp"
#include "bem_contact/contact/operator/strip_operator.hpp"

#include <Eigen/Core>

#include <span>
#include <vector>

namespace bem_contact::contact {

/// A_nn on boxes around the active set and an approximate inverse of it. Conjugate gradients run in single
/// precision, where they correct what is known in double precision.
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

} // namespace bem_contact::contact
