#pragma once

#include "bem_contact/base/conventions.hpp"
#include "bem_contact/base/material.hpp"

#include <array>

namespace bem_contact::halfspace {

/// 3 x 3, row i = displacement, column j = traction, mm/MPa.
using Matrix3 = std::array<std::array<double, 3>, 3>;

/// Displacement at the surface point (x, s) under unit uniform traction on the rectangle 2a x 2b about the
/// origin, of the half-space n > 0 (n into the body). Boussinesq-Cerruti: Love 1929; Kalker 1990, app. E.
Matrix3 at_point(const Material& material, double x, double s, double a, double b);

/// The same averaged over a rectangle of the same size 2a x 2b whose centre is (x, s): the influence number
/// the whole project uses, symmetric by Maxwell-Betti to the last digits.
Matrix3 averaged(const Material& material, double x, double s, double a, double b);

} // namespace bem_contact::halfspace
