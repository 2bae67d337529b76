#!/usr/bin/env python3
"""Reads a table of bem_contact (HDF5) and interpolates in it. Copy the class into your own program.

    table_reader.py creep.h5 6 4 82000 30000 0.001 0 0    # a, b (mm), G (MPa), mu N (N), xi, eta, phi (1/mm)
    table_reader.py forces.h5 0.5 6e4                     # of a scene: one number for each axis
"""

import sys

import h5py
import numpy as np


class Table:
    def __init__(self, file):
        with h5py.File(file) as f:
            words = {name: np.bytes_(f.attrs[name]).decode().split() for name in ("axes", "columns")}
            self.axes = [f["axes"][name][()] for name in words["axes"]]
            self.values = {name: f["values"][name][()] for name in words["columns"]}
            self.scale = {name: data[()] for name, data in f.get("creep_scale", {}).items()}

    def value(self, column, point):
        """Cubic in each coordinate, by the slopes of parabolas through three points; constant beyond the ends."""
        f = self.values[column]
        for x, at in zip(self.axes, point):
            i, n = np.clip(np.searchsorted(x, at, "right") - 1, 0, len(x) - 2), len(x)
            h, share = np.diff(x), np.clip((at - x[i]) / (x[i + 1] - x[i]), 0, 1)
            before, chord, after = ((f[j + 1] - f[j]) / h[j] for j in (max(i - 1, 0), i, min(i + 1, n - 2)))
            first = last = chord
            if i > 0:
                first = (h[i] * before + h[i - 1] * chord) / (h[i - 1] + h[i])
            if i + 2 < n:
                last = (h[i + 1] * chord + h[i] * after) / (h[i] + h[i + 1])
            first, last = (2 * chord - last if i == 0 else first), (2 * chord - first if i + 2 == n else last)
            f = f[i] + share * h[i] * (chord + (1 - share) * ((first - chord) * (1 - share) - (last - chord) * share))
        return f

    def creep_forces(self, a, b, shear_modulus, bound, xi, eta, phi):
        """Fx, Fy (N) and Mz (N mm) on the rail; semi-axes a along x and b (mm), bound = mu N (N)."""
        log_ratio, c = np.log10(a / b), np.sqrt(a * b)
        c11, c22, c23 = (np.interp(log_ratio, self.scale["log10_a_over_b"], self.scale[name])
                         for name in ("C11", "C22", "C23"))
        unit, sign = shear_modulus * c * c / bound, -1 if eta < 0 else 1
        x, y, z = unit * c11 / 3 * abs(xi), sign * unit * c22 / 3 * eta, sign * unit * c * c23 * phi
        w = np.sqrt(x * x + y * y + z * z)
        point = log_ratio, np.arctan2(np.hypot(y, z), x), np.arctan2(z, y), w / (1 + w)
        return (np.copysign(bound, xi) * self.value("Fx", point), sign * bound * self.value("Fy", point),
                sign * bound * c * self.value("Mz", point))


if __name__ == "__main__":
    table, numbers = Table(sys.argv[1]), [float(word) for word in sys.argv[2:]]
    if table.scale:
        print(*(f"{force:.12g}" for force in table.creep_forces(*numbers)))
    else:
        print(*(f"{table.value(column, numbers):.12g}" for column in ("Fx", "Fy", "Mz")))
