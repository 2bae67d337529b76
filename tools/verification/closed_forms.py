"""Closed forms that a scene can pose, each on several grids: those without friction, and the list `studies()` of all.

n is elements across the contact. A `solve(n)` returns {quantity: (ours, exact)}.
"""

import numpy as np

from . import exact
from .checks import Study, norm_of_difference
from .friction_forms import bentall_johnson, carter, cattaneo, creep_coefficients, power, pure_spin, spence
from .posing import MODULUS, NU, PATCH, count, middle_means, size


def hertz_ellipse(program):
    shear, poisson, force = 210000 / 2.6, 0.3, 1e5
    a, b = 1 / 920, 1 / 600
    h = exact.hertz(a, b, exact.contact_modulus(shear, poisson), force)

    def solve(n):
        m, dx, ds = count(n), size(2 * h["a"], n), size(2 * h["b"], n)
        material = {f"{body}.material.{key}": v for body in ("rail", "wheel")
                    for key, v in (("shear_modulus", shear), ("poisson", poisson))}
        r = program.solve(PATCH | material | {"load.force": force, "motion.frictionless": True, "grid.dx": dx, "grid.ds": ds,
                                              "grid.mx": m, "grid.ms": m, "gap.a": a, "gap.b": b})
        x, s = np.meshgrid(r.fields["x"], r.fields["s"])
        p = h["pmax"] * np.sqrt(np.maximum(1 - (x / h["a"])**2 - (s / h["b"])**2, 0))
        return {"largest pressure": (r["pmax"], h["pmax"]), "approach": (r["approach"], h["approach"]),
                "area": (r["area"], np.pi * h["a"] * h["b"]), "pressure, r.m.s. difference": norm_of_difference(r.fields["p_n"], p)}
    return solve


def hertz_line(program):
    radius, force = 300.0, 1000.0
    a, p0 = exact.hertz_line(radius, MODULUS, force)

    def solve(n):
        ds = size(2 * a, n)
        r = program.solve(PATCH | {"load.force": force, "motion.frictionless": True, "grid.plane_strain": True, "grid.mx": 1,
                                   "grid.ms": count(n), "grid.ds": ds, "gap.b": 1 / (2 * radius)})
        p = p0 * middle_means(r.fields["s"], ds, a)[:, None]
        return {"largest pressure": (r["pmax"], p0), "pressure, r.m.s. difference": norm_of_difference(r.fields["p_n"], p)}
    return solve


def steuermann(program):
    radius, coefficient = 3.0, 1e-4
    approach, force = 8 / 3 * coefficient * radius**4, 64 / 15 * MODULUS * coefficient * radius**5

    def solve(n):
        m, d = count(n), size(2 * radius, n)
        place = (np.arange(m) - (m - 1) / 2) * d
        rows = [(ix, i, coefficient * (place[ix]**2 + place[i]**2)**2) for i in range(m) for ix in range(m)]
        r = program.solve(PATCH | {"load.approach": approach, "motion.frictionless": True, "grid.dx": d, "grid.ds": d,
                                   "grid.mx": m, "grid.ms": m, "gap.table": ("ix,is,h", rows)})
        return {"force": (r["Fz"], force)}
    return solve


def persson(program, degrees):
    angle, radius, clearance = np.radians(degrees), 10.0, 2e-4
    ratio, pressure = exact.persson(angle)
    force = MODULUS * 2 * clearance / ratio  # E1* = E/(1 - nu^2) = 2 G/(1 - nu)

    def solve(n):
        ds = size(2 * angle * radius, n)
        r = program.solve(PATCH | {"load.force": force, "motion.frictionless": True, "grid.plane_strain": True, "grid.mx": 1,
                                   "grid.ms": count(n), "grid.ds": ds, "strip.radius": -radius,
                                   "strip.upper_radius": radius - clearance}, "tangent_plane")
        where = np.abs(r.fields["s"] / radius)
        p = np.where(where < angle, pressure(np.minimum(where, angle)), 0) * force / radius
        return {"largest pressure": (r["pmax"], float(pressure(0.0)) * force / radius),
                "half angle, degrees": (np.degrees(r["area"] / 2 / radius), degrees),
                "pressure, r.m.s. difference": norm_of_difference(r.fields["p_n"][:, 0], p)}
    return solve


def stress_below(program):
    radius, a = 200.0, 2.0
    force, p0 = 4 / 3 * MODULUS * a**3 / radius, 2 * MODULUS * a / (np.pi * radius)

    def solve(n):
        m, d = count(n), size(2 * a, n)
        r = program.solve(PATCH | {"load.force": force, "motion.frictionless": True, "grid.dx": d, "grid.ds": d, "grid.mx": m,
                                   "grid.ms": m, "gap.a": 1 / (2 * radius), "gap.b": 1 / (2 * radius),
                                   "stresses.x": [0.0], "stresses.s": [0.0], "stresses.depths": [0.25 * a, 0.5 * a, a]})
        found = np.ravel(r.json["stresses"]["von_mises"])
        return {f"von Mises' stress, depth {z} a": (found[i], exact.axis_von_mises(z, p0, NU))
                for i, z in enumerate((0.25, 0.5, 1.0))}
    return solve


def studies(program):
    """Bars are errors allowed on the finest grid, and least orders of convergence."""
    theory = "bem_contact/theory/estimates_and_heat.md, section 4"
    field = "pressure, r.m.s. difference"
    out = [
        Study("Hertz, ellipse", "Hertz 1882; Johnson 1985, eqs. 4.25 to 4.32", hertz_ellipse(program), (10, 20, 40, 80),
              {"largest pressure": ("MPa", 2e-3, 1), "approach": ("mm", 1e-3, 1), "area": ("mm2", 0.02, 0),
               field: ("", 0.02, 0.5, 1.0)}),
        Study("Hertz, line", "Johnson 1985, eqs. 4.43 to 4.45", hertz_line(program), (20, 40, 80, 160),
              {"largest pressure": ("MPa", 1e-3, 1), field: ("", 0.01, 0.5, 1.0)}),
        Study("Quartic gap", "Steuermann 1939; Johnson 1985, section 5.3", steuermann(program), (10, 20, 40, 80),
              {"force": ("N", 5e-3, 1)}),
    ]
    for degrees in (10, 20, 30, 45, 60):
        out.append(Study(f"Persson, {degrees} degrees", "Persson 1964", persson(program, degrees), (40, 80, 160),
                         {"largest pressure": ("MPa", 2e-3, 0), "half angle, degrees": ("", 0.015, 0), field: ("", 0.01, 0.5, 1.0)}))
    out += [
        Study("Carter", "Carter 1926; Johnson 1985, eqs. 8.17 to 8.21", carter(program), (20, 40, 80, 160),
              {"Fx": ("N", 5e-3, 0.5), "creepage, Fx given": ("", 5e-3, 0.5), "adhesion, length": ("mm", 0.03, 0),
               "p_x, r.m.s. difference": ("", 0.03, 0.5, 1.0)}),
        Study("Cattaneo and Mindlin", "Cattaneo 1938, Mindlin 1949; Johnson 1985, section 7.2d", cattaneo(program), (10, 20, 40, 80),
              {"shift": ("mm", 3e-3, 1), "adhesion, area": ("mm2", 0.05, 0), "p_x, r.m.s. difference": ("", 0.03, 0.5, 1.0)}),
        Study("Kalker's creep coefficients", "Kalker 1967, circle, Poisson's ratio 0", creep_coefficients(program), (20, 40, 80),
              {"C11": ("", 0.01, 0), "C22": ("", 0.01, 0), "C23": ("", 0.015, 0), "C33": ("", 0.02, 0)}),
        Study("Bentall and Johnson", "Bentall and Johnson 1967", bentall_johnson(program), (20, 40, 80, 160),
              {"creepage of free rolling": ("", 5e-3, 0)}),
        Study("Spence", "Spence 1975, Poisson's ratio 0, friction 0.2986 (three digits)", spence(program), (10, 20, 40),
              {"largest pressure over Hertz's": ("", 0.01, 0), "radius of adhesion over that of contact": ("", 0.05, 0)}),
        Study("Full slip by spin", "Johnson 1985, section 8.3; " + theory, pure_spin(program), (10, 20, 40, 80),
              {"force": ("N", 2e-3, 1), "moment": ("N mm", 2e-3, 1)}),
        Study("Power of friction", "energy balance of steady rolling", power(program), (20, 40, 80),
              {"power": ("N", 0.02, 0.5)}),
        Study("Stress below a circle", "Johnson 1985, eq. 3.45", stress_below(program), (10, 20, 40),
              {f"von Mises' stress, depth {z} a": ("MPa", 3e-3, 0) for z in (0.25, 0.5, 1.0)}),
    ]
    return out
