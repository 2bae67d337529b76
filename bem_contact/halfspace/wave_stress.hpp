#pragma once

#include "bem_contact/halfspace/stress.hpp"

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace bem_contact::halfspace {

/// What tractions along x, s and n make, in this order.
using UnitStresses = std::array<Stress, 3>;

/// Stresses in the half-space n > 0 under tractions of 1 MPa on the strip |s| < width / 2, endless along x,
/// that vary as cos(kx) along s and n and as sin(kx) along x: amplitudes at s = 0, width, 2 width ...,
/// [depth][count], of which xx, ss, nn and sn vary as cos(kx), xs and xn as sin(kx). A Fourier integral along
/// s of the stresses under a plane wave (from Airy's function in the plane of the wave vector and n, Johnson
/// 1985, section 2.4, and a shear across it), good to 1e-6. Lengths in mm, depths above 0; k >= 0 in 1/mm.
std::vector<UnitStresses> strip_wave_stresses(double poisson, double k, double width, std::size_t count,
                                              std::span<const double> depths);

/// The same at the distance with the other sign.
UnitStresses mirrored(const UnitStresses& at);

} // namespace bem_contact::halfspace
