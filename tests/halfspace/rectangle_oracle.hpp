#pragma once

#include "bem_contact/halfspace/kernels.hpp"

/// A slow way to the half-space's influence numbers, one element at a time, with which tests compare.
namespace bem_contact::halfspace {

/// Displacement at the surface point (x, s) under unit uniform traction on the rectangle 2a x 2b about the
/// origin, of the half-space n > 0 (n into the body). Boussinesq-Cerruti: Love 1929; Kalker 1990, app. E.
Matrix3 at_point(const Material& material, double x, double s, double a, double b);

/// The same averaged over a rectangle of the same size 2a x 2b whose centre is (x, s): the influence number
/// the whole project uses, symmetric by Maxwell-Betti to the last digits.
Matrix3 averaged(const Material& material, double x, double s, double a, double b);

} // namespace bem_contact::halfspace
