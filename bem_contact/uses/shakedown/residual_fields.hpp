#pragma once

#include "bem_contact/uses/shakedown/deviator.hpp"
#include "bem_contact/uses/shakedown/residual.hpp"

#include <vector>

namespace bem_contact::shakedown {

/// What the coefficients of the fields are at one point: `fields` numbers them, `stress` has their deviators
/// for a unit of each.
struct FieldsAtPoint {
  std::vector<int> fields;
  std::vector<Deviator> stress;
};

/// Residual stresses below a surface that balance themselves and do not vary along x. All of them follow from
/// two stress functions of the section (s, n), which are zero outside a block; on a flat surface
///
///     ss = d2F/dn2, nn = d2F/ds2, sn = -d2F/ds dn   (Airy), F and its slope zero on the block's boundary
///     xs = dH/dn, xn = -dH/ds                       (Prandtl), H zero there
///
/// and xx, which may be anything. Below a surface with the curvature c (above 0: convex) a step ds along the
/// surface is h ds at the depth n, h = 1 - c n, and the second derivatives along orthonormal axes are
///
///     ss = d2F/dn2, nn = d2F/ds2 / h2 - c/h dF/dn, sn = -(d2F/ds dn / h + c/h2 dF/ds), xn = -dH/ds / h
///
/// so that they balance exactly there, too. (A body of revolution: up to the patch over its radius.) F is a
/// cubic spline and H a quadratic one, each the product of one along s and one along n. By Melan's theorem no
/// more is needed: no elasticity, no eigenstrain.
class ResidualFields {
public:
  /// Knots, mm, rising; four of each at least. The first of `depth_knots` is the surface. `curvature`: of the
  /// surface, 1/mm; the block ends above the centre of curvature.
  ResidualFields(std::vector<double> s_knots, std::vector<double> depth_knots, Residual kind,
                 double curvature = 0);

  int size() const; ///< coefficients; xx is not among them
  /// Outside the block no field is there.
  FieldsAtPoint at(double s, double depth) const;

private:
  std::vector<double> s_knots_, depth_knots_;
  Residual kind_;
  double curvature_;
};

} // namespace bem_contact::shakedown
