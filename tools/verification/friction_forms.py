"""Closed forms with friction, each on several grids: Carter, Cattaneo, Kalker, Bentall and Johnson, Spence, full slip, power."""

import numpy as np

from . import exact
from .checks import norm_of_difference
from .posing import G, MODULUS, NU, PATCH, count, middle_means, size

LONG = 2000.0  # mm: one row, long against its contact, stands for a plane problem


def carter(program):
    a, inner, radius, mu = 1.0, 0.6, 500.0, 0.3
    force, creepage = np.pi * a * a * G / (4 * radius * (1 - NU)) * LONG, mu * (a - inner) / radius

    def solve(n):
        dx = size(2 * a, n)
        scene = PATCH | {"load.force": force, "motion.friction": mu, "grid.dx": dx, "grid.ds": LONG, "grid.mx": count(n),
                         "grid.ms": 1, "gap.a": 1 / (2 * radius)}
        r = program.solve(scene | {"motion.xi": creepage})
        by_force = program.solve(scene | {"load.force_x": 0.64 * mu * force})
        x, p0 = r.fields["x"], 2 * force / LONG / (np.pi * a)
        p = mu * p0 * (middle_means(x, dx, a) - inner / a * middle_means(x - (a - inner), dx, inner))
        return {"Fx": (r["Fx"], (1 - inner**2) * mu * force),
                "creepage, Fx given": (by_force.json["quantities"]["creepage_x"], creepage),
                "adhesion, length": (np.sum(r.fields["state"] == 1) * dx, 2 * inner),
                "p_x, r.m.s. difference": norm_of_difference(r.fields["p_x"][0], p)}
    return solve


def cattaneo(program):
    shear, a, curvature, mu, share = 200.0, 1.0, 0.01, 0.4, 7 / 8
    force = 8 / 3 * curvature * shear * a**3  # nu = 0: E* = G; Hertz: F = 4/3 E* a^3/R, 1/R = 2 curvature
    inner = (1 - share) ** (1 / 3) * a
    shift = (1 - (inner / a)**2) * 3 * mu * force * 2 / (8 * shear * a)
    material = {f"{body}.material.{key}": v for body in ("rail", "wheel")
                for key, v in (("shear_modulus", shear), ("poisson", 0.0))}

    def solve(n):
        m, d = count(n), size(2 * a, n)
        r = program.solve(PATCH | material | {
            "load.force": force, "load.force_x": share * mu * force, "motion.kind": "shift", "motion.friction": mu, "grid.dx": d,
            "grid.ds": d, "grid.mx": m, "grid.ms": m, "gap.a": curvature, "gap.b": curvature})
        x, s = np.meshgrid(r.fields["x"], r.fields["s"])
        square, p0 = x * x + s * s, 1.5 * force / (np.pi * a * a)
        p = mu * p0 / a * (np.sqrt(np.maximum(a * a - square, 0)) - np.sqrt(np.maximum(inner**2 - square, 0)))
        return {"shift": (r.json["quantities"]["creepage_x"], shift),
                "adhesion, area": (np.sum(r.fields["state"] == 1) * d * d, np.pi * inner**2),
                "p_x, r.m.s. difference": norm_of_difference(r.fields["p_x"], p)}
    return solve


def creep_coefficients(program):
    """Circle, nu = 0. c^2 = area in contact / pi."""
    shear, a, curvature, small = 1.0, 1.0, 1e-3, 1e-4
    force = 8 / 3 * curvature * shear * a**3
    material = {f"{body}.material.{key}": v for body in ("rail", "wheel")
                for key, v in (("shear_modulus", shear), ("poisson", 0.0))}

    def solve(n):
        m, d = count(n), size(2 * a, n)
        scene = PATCH | material | {"load.force": force, "motion.friction": 1e6, "grid.dx": d, "grid.ds": d, "grid.mx": m,
                                    "grid.ms": m, "gap.a": curvature, "gap.b": curvature}
        along, lateral, spin = (program.solve(scene | {f"motion.{key}": small}) for key in ("xi", "eta", "phi"))
        square = along["area"] / np.pi
        c = np.sqrt(square)
        return {"C11": (along["Fx"] / (square * small), exact.CREEP_CIRCLE["C11"]),
                "C22": (lateral["Fy"] / (square * small), exact.CREEP_CIRCLE["C22"]),
                "C23": (0.5 * (spin["Fy"] - lateral["Mz"]) / (square * c * small), exact.CREEP_CIRCLE["C23"]),
                "C33": (spin["Mz"] / (square * square * small), exact.CREEP_CIRCLE["C33"])}
    return solve


def bentall_johnson(program):
    long, radius, a = 1e4, 50.0, 0.1  # radius of each roller
    soft, hard = (23000.0, 0.31), (G, NU)
    modulus = 1 / ((1 - soft[1]) / (2 * soft[0]) + (1 - hard[1]) / (2 * hard[0]))
    force = np.pi * modulus * a * a / (4 * radius / 2) * long
    shear = 2 / (1 / soft[0] + 1 / hard[0])
    poisson = shear * 0.5 * (soft[1] / soft[0] + hard[1] / hard[0])
    k = shear * 0.25 * ((1 - 2 * soft[1]) / soft[0] - (1 - 2 * hard[1]) / hard[0])
    creepage = exact.bentall_johnson_factor() * 2 * k / (1 - poisson) * a / (radius / 2)

    def solve(n):
        r = program.solve(PATCH | {
            "rail.material.shear_modulus": soft[0], "rail.material.poisson": soft[1], "load.force": force, "load.force_x": 0,
            "motion.friction": 1e-4, "grid.dx": size(2 * a, n), "grid.ds": long, "grid.mx": count(n), "grid.ms": 1,
            "gap.a": 1 / radius})
        return {"creepage of free rolling": (r.json["quantities"]["creepage_x"], creepage)}
    return solve


def spence(program):
    """A sphere on a body a million times stiffer, load growing in steps: pressure and shear act on each other."""
    shear, a, curvature, mu = 1000.0, 1.0, 0.01, 0.2986
    force = 4 / 3 * 2 * shear * 2 * curvature * a**3  # nu = 0: E* of one body is 2 G

    def solve(n):
        m, d = count(n), size(2 * a, n)
        steps = [(force * ((k + 1) / 20)**3,) for k in range(20)]
        material = {"rail.material.shear_modulus": shear, "rail.material.poisson": 0.0,
                    "wheel.material.shear_modulus": 1e6 * shear, "wheel.material.poisson": 0.0}
        r = program.solve(PATCH | material | {
            "load.force": force, "motion.kind": "shift", "motion.step_table": ("load", steps),
            "motion.friction": mu, "grid.dx": d, "grid.ds": d, "grid.mx": m, "grid.ms": m, "gap.a": curvature, "gap.b": curvature})
        state = r.fields["state"]
        return {"largest pressure over Hertz's": (r["pmax"] / (1.5 * force / (np.pi * a * a)), 1.31),
                "radius of adhesion over that of contact": (np.sqrt(np.sum(state == 1) / np.sum(state > 0)), 0.5)}
    return solve


def pure_spin(program):
    radius, a, mu = 500.0, 3.0, 0.3
    force = 4 / 3 * MODULUS * a**3 / radius

    def solve(n):
        m, d = count(n), size(2 * a, n)
        r = program.solve(PATCH | {"load.approach": a * a / radius, "motion.friction": mu, "motion.phi": 1.0, "grid.dx": d,
                                   "grid.ds": d, "grid.mx": m, "grid.ms": m, "gap.a": 1 / (2 * radius), "gap.b": 1 / (2 * radius)})
        return {"force": (r["Fz"], force), "moment": (r["Mz"], 3 * np.pi / 16 * mu * force * a)}
    return solve


def power(program):
    """What friction dissipates is what the creepages supply (equal bodies, steady rolling): xi Fx + eta Fy + phi Mz."""
    h, creepages = exact.hertz(1e-3, 2e-3, MODULUS, 4000.0), {"xi": 2e-4, "eta": -3e-4, "phi": 2e-4}

    def solve(n):
        m = count(n)
        r = program.solve(PATCH | {"load.force": 4000.0, "motion.friction": 0.3, "grid.dx": size(2 * h["a"], n),
                                   "grid.ds": size(2 * h["b"], n), "grid.mx": m, "grid.ms": m, "gap.a": 1e-3, "gap.b": 2e-3}
                          | {f"motion.{k}": v for k, v in creepages.items()})
        supplied = creepages["xi"] * r["Fx"] + creepages["eta"] * r["Fy"] + creepages["phi"] * r["Mz"]
        return {"power": (r["T_gamma"], supplied)}
    return solve
