#pragma once

#include "bem_contact/halfspace/kernels.hpp"

#include <span>

namespace bem_contact::halfspace {

/// Entry m of `line` is the influence number of two elements dx by ds whose centres are (m dx, s) apart: the
/// displacement of the half-space n > 0 (n into the body) under unit uniform traction on the one, averaged
/// over the other. Boussinesq-Cerruti: Love 1929; Kalker 1990, app. E. Symmetric by Maxwell-Betti to the last
/// digits. A whole line is about thirty times as fast as its elements one by one, because neighbours share
/// corners and quadrature points; tests compare it with these (tests/halfspace/rectangle_oracle.hpp) to
/// 1e-13. Throws InputError unless dx and ds are positive.
void averaged_line(const Material& material, double s, double dx, double ds, std::span<Matrix3> line);

} // namespace bem_contact::halfspace
