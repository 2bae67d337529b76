"""The program against the dense solver, on problems with and without coupling of pressure and shear."""

from dataclasses import dataclass

import numpy as np

from . import dense
from .program import ROOT

STEEL, SOFT = (82000.0, 0.28), (23000.0, 0.31)
RAIL, WHEEL = (ROOT / "data" / "influence" / f"small_{name}.h5" for name in ("rail", "wheel"))

RAIL_S, WHEEL_S = -32.75, 36.75  # mm: stations of the files, about opposite each other on the arcs of 13 mm


@dataclass
class Comparison:
    name: str
    elements: int
    contact: int
    adhesion: int
    pressure: float  # largest difference, of the largest pressure
    shear: float     # the same of shear tractions, of the largest bound mu p_n
    approach: float  # relative
    bar: float = 1e-6  # what the certificate allows

    def passed(self):
        return max(self.pressure, self.shear, self.approach) <= self.bar


@dataclass
class Problem:
    name: str
    model: str
    wheel: tuple = STEEL
    rail: tuple = STEEL
    mx: int = 16
    ms: int = 14
    dx: float = 0.5
    ds: float = 0.5
    force: float = 5e3
    friction: float = 0.3
    creepages: tuple = (6e-4, -4e-4, 3e-4)
    gap: tuple = (1e-3, 2e-3)
    radius: float = 0.0
    upper: float = 0.0

    def scene(self):
        out = {"kind": "patch", "solver.tolerance": 1e-11, "load.force": self.force, "motion.friction": self.friction,
               "grid.dx": self.dx, "grid.ds": self.ds, "grid.mx": self.mx, "grid.ms": self.ms, "gap.a": self.gap[0],
               "gap.b": self.gap[1]} | dict(zip(("motion.xi", "motion.eta", "motion.phi"), self.creepages))
        for body, material in (("rail", self.rail), ("wheel", self.wheel)):
            out |= {f"{body}.material.shear_modulus": material[0], f"{body}.material.poisson": material[1]}
        if self.radius:
            out |= {"strip.radius": self.radius} | ({"strip.upper_radius": self.upper} if self.upper else {})
        if self.model == "fem":
            out |= {"rail.influence": RAIL, "wheel.influence": WHEEL, "strip.rail_s0": RAIL_S, "strip.wheel_s0": WHEEL_S}
        return out

    def numbers(self, program, rows):
        if self.model == "fem":
            grid = (self.dx, self.ds, self.mx + 2, self.ms)
            return dense.pair_of_bodies(program.body_numbers(RAIL, *grid, RAIL_S), program.body_numbers(WHEEL, *grid, WHEEL_S))
        if self.model == "tangent_plane":
            return dense.tangent_plane_pair(self.mx, self.ms, self.dx, self.ds, self.rail, self.wheel, rows)
        return dense.halfspace_pair(self.mx, self.ms, self.dx, self.ds, self.rail, self.wheel)

    def rows(self, s):
        if not self.radius:
            return [(v, 0.0, 0.0) for v in s]
        return [(self.radius * np.sin(v / self.radius), self.radius * (1 - np.cos(v / self.radius)), v / self.radius) for v in s]

    def compare(self, program):
        r = program.solve(self.scene(), self.model)
        f = r.fields
        rows = self.rows(f["s"])
        delta = np.repeat([row[2] for row in rows], self.mx)
        x, s = np.tile(f["x"], self.ms), np.repeat(f["s"], self.mx)
        xi, eta, phi = self.creepages
        slip = np.concatenate([xi - phi * s, eta + phi * x])
        pn, px, ps, q = dense.solve(self.numbers(program, rows), self.mx, self.dx, f["gap"].ravel(), delta,
                                    self.force / (self.dx * self.ds), self.friction, slip)
        shear = max(np.abs(f["p_x"].ravel() - px).max(), np.abs(f["p_s"].ravel() - ps).max())
        return Comparison(self.name, self.mx * self.ms, int((pn > 0).sum()), int((f["state"] == 1).sum()),
                          np.abs(f["p_n"].ravel() - pn).max() / pn.max(), shear / (self.friction * pn.max()),
                          abs(r["approach"] / q - 1))


def problems():
    return [
        Problem("half-space, partial slip", "halfspace"),
        Problem("half-space, small creepage", "halfspace", creepages=(1e-4, 5e-5, 0.0), friction=0.6),
        Problem("half-space, full slip", "halfspace", creepages=(5e-3, 3e-3, 1e-3)),
        Problem("half-space, long elements", "halfspace", dx=1.0, ds=0.25, mx=12, ms=20),
        Problem("half-space, unlike materials", "halfspace", rail=SOFT, force=3e3),
        Problem("tangent plane, groove of 12 mm", "tangent_plane", radius=-12.0, upper=11.0, gap=(1e-3, 0.0), force=4e3),
        Problem("tangent plane, crown of 12 mm", "tangent_plane", radius=12.0, upper=60.0, gap=(1e-3, 0.0), force=1e3, ds=0.25),
        Problem("finite elements, partial slip", "fem", radius=13.0, ms=15, gap=(1e-3, 3e-3), force=6e3),
        Problem("finite elements, little friction", "fem", radius=13.0, ms=15, gap=(1e-3, 3e-3), force=6e3, friction=0.1, creepages=(2e-4, 1e-4, 1e-4)),
    ]
