#pragma once

#include "bem_contact/base/material.hpp"
#include "fem_influence/harmonic/section.hpp"
#include "fem_influence/shared/elements.hpp"

#include <array>
#include <memory>
#include <span>
#include <vector>

namespace bem_contact::fem {

/// K(k) = K0 + k K1 + k^2 K2, real and symmetric, of the displacement
///     u_x = U sin kx, u_y = V cos kx, u_z = W cos kx
/// on the section (per unit length, or per unit of R_ref theta). Degree of freedom 3 node + component.
/// Stored cell by cell: blocks (a, b) of the cell's nodes, b not before a.
struct SectionOperator {
  /// What a block is made of: K0 has the entries xx, yy, yz, zy, zz; K1 has xy, xz, yx, zx; K2 is diagonal,
  /// the shapes' product times lambda + 2 mu, mu, mu.
  struct Block {
    std::array<double, 5> k0{};
    std::array<double, 4> k1{};
    double product = 0;
  };
  Elements cells;            ///< nodes
  double lambda = 0, mu = 0; ///< Lame's constants
  std::span<const Block>
      block; ///< cell after cell, of its first node with itself and all after it, and so on
  std::shared_ptr<const std::vector<Block>> own; ///< where `block` lies, unless somebody else keeps it

  std::size_t block_count() const; ///< of these cells

  /// Block e of K(k), row-major.
  std::array<double, 9> at(std::size_t e, double k) const {
    const Block& b = block[e];
    const double kk = k * k * b.product, stiff = lambda + 2 * mu;
    return {b.k0[0] + stiff * kk, k * b.k1[0], k * b.k1[1],      k * b.k1[2], b.k0[1] + mu * kk, b.k0[2],
            k * b.k1[3],          b.k0[3],     b.k0[4] + mu * kk};
  }
  /// K(k) u over all degrees of freedom.
  std::vector<double> apply(double k, std::span<const double> u) const;
};

/// Strains of a prism (reference_radius == 0):
///     e_xx = k U, g_xy = U_y - k V, g_xz = U_z - k W, e_yy = V_y, e_zz = W_z, g_yz = V_z + W_y.
/// Of a body of revolution with r = R_ref + z, rho = r / R_ref, k = n / R_ref, weight rho dA:
///     e_xx = (k/rho) U + W/r, g_xy = U_y - (k/rho) V, g_xz = U_z - U/r - (k/rho) W, the rest as above.
/// lay_out() gives all but the blocks. fill() computes the blocks, in `memory` (for block_count() of them,
/// which must live as long as the operator) or in the operator's own memory. Throws InputError when a node of
/// a body of revolution lies on or beyond the axle (r <= 0).
SectionOperator lay_out(const Section& section, const Material& material, double reference_radius);
void fill(SectionOperator& op, const Section& section, double reference_radius,
          std::span<SectionOperator::Block> memory = {});

/// Nodal values [3 node + component] of the body's rigid motions that are the same all along it. A prism:
/// translations x, y, z and the rotation about x. Revolution: along the axle and about it.
std::vector<std::vector<double>> rigid_motions(std::span<const Point2> nodes, double reference_radius);

} // namespace bem_contact::fem
