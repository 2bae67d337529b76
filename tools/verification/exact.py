"""Exact solutions, written from the formulas of bem_contact/theory/estimates_and_heat.md, section 4, and of the sources named there.

Nothing here comes from the program. Units: mm, N, MPa, rad.
"""

import numpy as np


def elliptic(m):
    """Complete integrals K and E of the parameter m, by the arithmetic-geometric mean."""
    a, b, c, power, total = 1.0, np.sqrt(1 - m), np.sqrt(m), 0.5, 0.5 * m
    for _ in range(40):
        a, b, c, power = (a + b) / 2, np.sqrt(a * b), (a - b) / 2, 2 * power
        total += power * c * c
    k = np.pi / (2 * a)
    return k, k * (1 - total)


def contact_modulus(shear, poisson):
    """E* of two equal bodies: 1/E* = 2 (1 - nu^2)/E."""
    return shear / (1 - poisson)


def hertz(across_x, across_s, modulus, force):
    """Gap A x^2 + B s^2: semi-axes along x and s, largest pressure, approach (Hertz 1882; Johnson 1985, ch. 4)."""
    lo, hi = min(across_x, across_s), max(across_x, across_s)
    low, high = 1e-8, 1.0
    for _ in range(200):
        ratio = 0.5 * (low + high)
        k, e = elliptic(1 - ratio**2)
        low, high = (ratio, high) if (k - e) / (e / ratio**2 - k) < lo / hi else (low, ratio)
    if lo == hi:
        ratio, k, e = 1.0, np.pi / 2, np.pi / 2
    else:
        k, e = elliptic(1 - ratio**2)
    a = (3 * force * e / (2 * np.pi * modulus * ratio**2 * (lo + hi))) ** (1 / 3)
    b = ratio * a
    return {"a": a if across_x <= across_s else b, "b": b if across_x <= across_s else a,
            "pmax": 3 * force / (2 * np.pi * a * b), "approach": 3 * force * k / (2 * np.pi * a * modulus)}


def hertz_line(radius, modulus, force):
    """Half width and largest pressure of a cylinder, force per length (Johnson 1985, eqs. 4.43 to 4.45)."""
    a = np.sqrt(4 * force * radius / (np.pi * modulus))
    return a, 2 * force / (np.pi * a)


def persson(half_angle):
    """E1* dR / Q of Persson (1964), and p R / Q as a function of the angle."""
    b = np.tan(half_angle / 2)
    root = np.sqrt(b * b + 1)

    def pressure(angle):
        y = np.tan(np.asarray(angle, float) / 2)
        inner = np.sqrt(np.maximum(b * b - y * y, 0))
        p = 2 * inner / (np.pi * root * (1 + y * y))
        return p + np.log((root + inner) / (root - inner)) / (2 * np.pi * b * b * (1 + b * b))

    return (2 - np.log(b * b + 1) - 2 * b**4) / (np.pi * (b * b + 1) * b * b), pressure


def michell_pair(angle, width, modulus, radius):
    """Radial difference hole less disc under 1 MPa on an arc `width` mm long, mean over an arc as long, `angle` away
    (Michell 1899; equal bodies, plane strain), up to a rigid motion, which adds a multiple of cos(angle)."""
    half = width / radius / 2
    nodes, weights = np.polynomial.legendre.leggauss(24)
    t = (nodes + 1) / 2
    smooth, slope = t**3 * (10 - 15 * t + 6 * t * t), 30 * t * t * (1 - t) ** 2  # ends where the integrand is singular
    total = 0.0
    for sign in (-1, 1):  # the distance of two random points of the arcs has a triangular density
        u = sign * 2 * half * smooth
        theta = angle + u
        w = weights / 2 * slope * 2 * half * (1 - smooth) / (2 * half)
        total += np.sum(w * (-np.cos(theta) * np.log(2 * np.abs(np.sin(theta / 2)) + 1e-300) - 0.25))
    return 4 * width / (np.pi * modulus) * total


def axis_von_mises(depth, pmax, poisson):
    """On the axis of a circular Hertz contact, `depth` in radii of the contact (Johnson 1985, eq. 3.45)."""
    normal = -pmax / (1 + depth**2)
    across = -pmax * ((1 + poisson) * (1 - depth * np.arctan(1 / depth)) - 0.5 / (1 + depth**2))
    return abs(normal - across)


# Bentall and Johnson 1967: xi = factor kappa a / R, factor = sqrt(1 - z^2)/2 with z sqrt(1 - z^2) + arcsin z = pi/4.
def bentall_johnson_factor():
    low, high = 0.0, 1.0
    for _ in range(100):
        z = 0.5 * (low + high)
        low, high = (z, high) if z * np.sqrt(1 - z * z) + np.arcsin(z) < np.pi / 4 else (low, z)
    return np.sqrt(1 - z * z) / 2


# Kalker's linear theory on a circle at nu = 0 (Kalker 1967).
CREEP_CIRCLE = {"C11": 32 / (3 * np.pi), "C22": 32 / (3 * np.pi), "C23": 4 / 3, "C33": 512 / (135 * np.pi)}
