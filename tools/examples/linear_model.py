"""The textbook's linear model of the coned wheelset: two degrees of freedom, Kalker's creep coefficients. Units mm, N, s, rad."""

from dataclasses import dataclass

import numpy as np
from scipy.optimize import brentq
from scipy.special import ellipe, ellipkm1

from wheelset import Wheelset

SHEAR_MODULUS, POISSON = 82000.0, 0.28  # MPa; bem_contact's defaults
# Kalker's coefficients at nu = 0.28 of an ellipse with a/b = 1.3298 (bem_contact/reference/creep_coefficients.hpp;
# tests/reference/test_rolling.cpp compares; Kalker 1990, table E3, agrees between its lines).
A_OVER_B, C11, C22, C23, C33 = 1.3298, 4.5458, 4.1367, 1.8588, 0.9916


def hertz_ellipse(curvature_x, curvature_s, force):
    """Semi-axes along x and s, mm, where the gap is A x^2 + B s^2 with A < B (Johnson 1985, eqs 4.26 to 4.32)."""
    modulus = SHEAR_MODULUS / (1 - POISSON)  # of two equal bodies
    ratio = curvature_x / curvature_s

    def mismatch(k):  # b/a
        first, second = ellipkm1(k**2), ellipe(1 - k**2)
        return (first - second) / (second / k**2 - first) - ratio

    k = brentq(mismatch, 1e-3, 1 - 1e-9)
    a = (3 * force * ellipe(1 - k**2) / (2 * np.pi * modulus * k**2 * (curvature_x + curvature_s))) ** (1 / 3)
    return a, k * a


@dataclass(frozen=True)
class ConedPair:
    """Of coned_wheelset.toml. A cone touches the rail's head where that has the cone's slope."""

    slope: float = 1 / 40
    head_radius: float = 300.0  # mm
    rail: float = 750.0  # mm, of the rail's top from the middle of the track

    @property
    def half_distance(self):  # of the two contacts, mm
        return self.rail - self.head_radius * np.sin(self.slope)

    def radius(self, wheelset):  # rolling radius in the middle of the track, mm
        return wheelset.radius + self.slope * (self.rail - self.half_distance)

    def conicity(self, wheelset):
        """Half of the difference of rolling radii over y, with the wheelset's roll (Wickens 2003, section 2.2)."""
        b = self.half_distance
        return self.slope * (b + self.head_radius * self.slope) / (b - self.radius(wheelset) * self.slope)

    def klingel(self, wheelset):
        """Wavelength of the kinematic motion, mm (Klingel 1883)."""
        return 2 * np.pi * np.sqrt(self.half_distance * self.radius(wheelset) / self.slope)


def matrix(speed, wheelset=Wheelset(), pair=ConedPair()):
    """d/dt (y, psi, y', psi') = matrix (y, psi, y', psi'). Wickens 2003, section 2.5; the lateral velocity at the rail is
    more than that of the centre, because the wheelset rolls about it."""
    b, r, conicity = pair.half_distance, pair.radius(wheelset), pair.conicity(wheelset)
    semi_axes = hertz_ellipse(0.5 / r, 0.5 / pair.head_radius, wheelset.weight / 2)
    assert abs(semi_axes[0] / semi_axes[1] / A_OVER_B - 1) < 1e-2, "the creep coefficients are for another ellipse"
    c = np.sqrt(np.prod(semi_axes))
    f11, f22, f23, f33 = SHEAR_MODULUS * np.array([c**2 * C11, c**2 * C22, c**3 * C23, c**4 * C33])
    at_rail = 1 + r * conicity / b
    gravity = wheelset.weight * conicity / b  # the contacts' normals turn with the roll
    lateral = np.array([-wheelset.lateral_stiffness - gravity, 2 * f22, -2 * f22 * at_rail / speed, -2 * f23 / speed])
    yaw = np.array([-2 * f11 * b * conicity / r, -wheelset.yaw_stiffness - 2 * f23, 2 * f23 * at_rail / speed,
                    -2 * (f11 * b**2 + f33) / speed])
    return np.array([[0, 0, 1, 0], [0, 0, 0, 1], lateral / wheelset.mass, yaw / wheelset.yaw_inertia])


def least_damped(speed, wheelset=Wheelset()):
    """The eigenvalue with the largest real part (1/s), and its motion with y = 1 mm at the time 0, [4]."""
    values, motions = np.linalg.eig(matrix(speed, wheelset))
    i = int(np.argmax(values.real + 1e-12 * values.imag))
    return values[i], motions[:, i] / motions[0, i]


def critical_speed(wheelset=Wheelset()):
    """mm/s, above which small motions grow."""
    return brentq(lambda speed: least_damped(speed, wheelset)[0].real, 1e4, 3e5)
