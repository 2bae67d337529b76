"""Influence functions by finite elements against closed forms and an independent 3-D analysis, and the limits of models."""

import h5py
import numpy as np

from . import exact, posing
from .checks import Check, Study, norm_of_difference

BODIES = ("disc", "bore", "flat_block", "rail_60E1_gauge_corner", "wheel_S1002_flange_root")


def plane_strain_kernel(file):
    """g_nn at wavenumber 0 as a matrix over stations, the stations' arc lengths, width, and (G, nu)."""
    with h5py.File(file) as f:
        lower, stations = f["kernel"][0], f["stations"][:, 0]
        n = 3 * len(stations)
        whole = np.zeros((n, n))
        whole[np.tril_indices(n)] = lower
        whole = whole + np.tril(whole, -1).T
        return whole[2::3, 2::3], stations, f.attrs["station_width"], (f.attrs["shear_modulus"], f.attrs["poisson"])


def michell_kernel(stations, width, radius, shear, poisson, hole):
    """Displacement into the body under 1 MPa on each station, without the modes n = 1 (Michell 1899)."""
    kappa, half = 3 - 4 * poisson, width / radius / 2
    n = np.arange(2, 6000)
    outer, inner = (1 / (n - 1), 1 / (n + 1)) if hole else (1 / (n + 1), 1 / (n - 1))
    mode = radius / (4 * shear) * (kappa * outer + inner)
    weight = 2 * half / np.pi * (np.sin(n * half) / (n * half)) ** 2 * mode
    breathing = radius / (2 * shear) * (1 if hole else 1 - 2 * poisson) * half / np.pi
    steps = np.arange(len(stations)) * width / radius
    series = breathing + np.cos(steps[:, None] * n) @ weight
    return series[np.abs(np.subtract.outer(np.arange(len(stations)), np.arange(len(stations))))]


def michell_check(body, file, radius, bar):
    """Loads without resultant, displacements without rigid motion: what holds the body does not matter then."""
    ours, stations, width, material = plane_strain_kernel(file)
    theory = michell_kernel(stations, width, radius, *material, hole=body == "bore")
    rigid = np.linalg.qr(np.column_stack([np.cos(stations / radius), np.sin(stations / radius)]))[0]
    project = np.eye(len(stations)) - rigid @ rigid.T
    ours, theory = project @ ours @ project, project @ theory @ project
    check = Check(f"Michell, {body}", "largest difference of influence numbers, of self", "", "Michell 1899", bar,
                  scale=1.0)
    check.add(len(stations), np.abs(ours - theory).max() / theory.diagonal().max(), 0.0)
    return check


def persson_fem(program, files):
    half, radius, clearance = np.radians(30), 10.0, 0.2
    ratio, pressure = exact.persson(half)
    force = posing.MODULUS * 2 * clearance / ratio

    def solve(n):
        ds = posing.size(2 * half * radius, n)
        r = program.solve(posing.PATCH | {
            "rail.influence": files["bore"], "wheel.influence": files["disc"], "load.force": force, "motion.frictionless": True,
            "grid.plane_strain": True, "grid.mx": 1, "grid.ms": posing.count(n), "grid.ds": ds, "strip.radius": -radius,
            "strip.upper_radius": radius - clearance}, "fem")
        return {"largest pressure": (r["pmax"], float(pressure(0.0)) * force / radius),
                "half angle, degrees": (np.degrees(r["area"] / 2 / radius), 30)}
    return Study("Persson, finite elements", "Persson 1964", solve, (20, 40, 80),
                 {"largest pressure": ("MPa", 4e-3, 0), "half angle, degrees": ("", 0.015, 0)})


def flat_block(program, files):
    radius, force = 400.0, 20000.0
    h = exact.hertz(1 / (2 * radius), 1 / (2 * radius), posing.MODULUS, force)

    def solve(n):
        m, d = posing.count(n), posing.size(2 * h["a"], n)
        r = program.solve(posing.PATCH | {
            "rail.influence": files["flat_block"], "wheel.influence": files["flat_block"], "load.force": force,
            "motion.frictionless": True, "grid.dx": d, "grid.ds": d, "grid.mx": m, "grid.ms": m,
            "gap.a": 1 / (2 * radius), "gap.b": 1 / (2 * radius)}, "fem")
        x, s = np.meshgrid(r.fields["x"], r.fields["s"])
        p = h["pmax"] * np.sqrt(np.maximum(1 - (x * x + s * s) / h["a"]**2, 0))
        return {"largest pressure": (r["pmax"], h["pmax"]),
                "pressure, r.m.s. difference": norm_of_difference(r.fields["p_n"], p)}
    return Study("Hertz, finite elements of a flat block", "Johnson 1985, ch. 4", solve, (8, 16, 30),
                 {"largest pressure": ("MPa", 3e-3, 0), "pressure, r.m.s. difference": ("", 0.03, 0, 1.0)})


def model_limits(program, quick):
    """Rows: half angle, error of pmax by half-space and by tangent-plane influence numbers, and the half-space's prediction."""
    rows = []
    for degrees in (10, 20, 30) if quick else (5, 10, 15, 20, 30, 45, 60):
        angle, radius, clearance, n = np.radians(degrees), 10.0, 2e-4, 80
        ratio, pressure = exact.persson(angle)
        force = posing.MODULUS * 2 * clearance / ratio
        scene = posing.PATCH | {
            "load.force": force, "motion.frictionless": True, "grid.plane_strain": True, "grid.mx": 1,
            "grid.ms": int(1.4 * n), "grid.ds": posing.size(2 * angle * radius, n),
            "strip.radius": -radius, "strip.upper_radius": radius - clearance}
        pmax = float(pressure(0.0)) * force / radius
        rows.append([degrees] + [program.solve(scene, m)["pmax"] / pmax - 1 for m in ("halfspace", "tangent_plane")]
                    + [0.66 * angle**2])
    return rows
