"""What the exact problems have in common: material, grid, and means over elements."""

import numpy as np

from . import exact

G, NU = 82000.0, 0.28  # the program's default material
MODULUS = exact.contact_modulus(G, NU)
PATCH = {"kind": "patch", "solver.tolerance": 1e-10}


def count(n):
    """Elements of a grid that is a fifth wider than a contact n elements wide."""
    return 2 * round(0.6 * n + 1)


def size(across, n):
    """Of an element. The contact is not a whole number of elements wide: a grid that fits it would flatter us."""
    return across / (n + 0.37)


def middle_means(x, h, half):
    """Mean of sqrt(1 - (x/half)^2) over elements of length h: a constant element should hold the mean."""
    def integral(t):
        t = np.clip(t / half, -1, 1)
        return half * 0.5 * (t * np.sqrt(1 - t * t) + np.arcsin(t))
    return (integral(x + h / 2) - integral(x - h / 2)) / h
