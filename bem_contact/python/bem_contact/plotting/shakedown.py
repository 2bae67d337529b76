"""Limits of the shakedown diagram: what p0/k does a surface bear where the used friction is mu?

The room fatigue has the limit below the surface of each patch (`uses/fatigue/shakedown.hpp`); here are the lines of the picture.
Below the surface they are those of a long contact (a Hertz line contact that slips all over), where they follow from the
stresses in closed form (McEwen 1949; Johnson 1985, eqs. 4.49 and 7.8). The steel is elastic and perfectly plastic.
A patch as wide as it is long bears more, by a sixth without friction (4.7: Ponter, Hearle and Johnson 1985).
"""

import numpy as np

POISSON = 0.3
X, Z = np.meshgrid(np.linspace(-1.5, 1.5, 301), np.linspace(0, 1.5, 151))  # over the half width of the contact


def line_stresses(x, z, mu):
    """xx, zz and xz over p0, tension positive, z down from the surface; lengths over the half width of the contact."""
    sum_, root = 1 - x**2 + z**2, 2 * x * z
    size = np.hypot(sum_, root)
    m, n = np.sqrt((size + sum_) / 2), np.sign(x) * np.sqrt(np.maximum(size - sum_, 0) / 2)
    square = np.maximum(m**2 + n**2, 1e-12)  # 0 at the edges of the contact
    share = (z**2 + n**2) / square
    xx, zz, xz = -(m * (1 + share) - 2 * z), -m * (1 - share), -n * (m**2 - z**2) / square
    return xx + mu * (n * (2 - (z**2 - m**2) / square) - 2 * x), zz + mu * xz, xz + mu * xx


def elastic_limit(mu):
    """p0/k up to which nothing flows (von Mises): 3.1 without friction."""
    xx, zz, xz = line_stresses(X, Z, mu)
    yy = POISSON * (xx + zz)
    return 1 / np.sqrt((((xx - yy)**2 + (yy - zz)**2 + (zz - xx)**2) / 6 + xz**2).max())


def shakedown_limit(mu):
    """p0/k up to which the steel, having flowed at first, stays elastic: residual stresses cancel all but the shear along the
    surface, so that this shear must not exceed k anywhere (Melan's theorem; Johnson 1985, section 9.2). 4 without friction,
    and 1/mu from mu = 0.367 on, where the surface flows first."""
    return 1 / np.abs(line_stresses(X, Z, mu)[2]).max()
