#!/usr/bin/python3
"""Shapes the head of a rail: which steel has to go so that wheels wear and press less? (README.md beside this file)

    PYTHONPATH=build/python tools/examples/shape_rail_head.py [--stations 8] [--most 0.3]

The rail is 60E1 as a curve through points. Its shape is the depth of steel removed at some stations, with straight lines between, each
between 0 and `--most` mm. What is made small is the mean over a collective of contacts of T-gamma and of pmax, each over what 60E1 has.
Its gradient comes with the solutions: derivatives = ["rail_profile"] gives what T-gamma and pmax change by as each point of the profile
moves along its normal. scipy's L-BFGS-B descends along it within the bounds. At the end both shapes are solved again, on other elements.
"""

import argparse

import numpy as np
from scipy.optimize import minimize

import bem_contact

RAIL_Y = 753.481  # mm, of the middle of the rail from the track's centre line: gauge 1435 mm
# lateral displacement (mm), load (N) and share of the collective: eight places even out what single elements do
COLLECTIVE = [(lateral, 8e4, 1 / 8) for lateral in np.linspace(-2.0, 4.0, 8)]


def scene(profile, lateral, load, size):
    return {"rail": {"profile": profile, "place": "absolute", "y": RAIL_Y}, "wheel": {"profile": "S1002"}, "load": {"force": load},
            "position": {"lateral": lateral}, "motion": {"xi": 1e-3, "friction": 0.35, "free_rolling": False},
            "grid": {"dx": size, "ds": size}, "solver": {"model": "halfspace"}}


class Shape:
    """The points of 60E1 on its upper side, and what they are where steel is removed."""

    def __init__(self, stations, step=1.0):
        p = bem_contact.profile("60E1")
        s, y, z, inclination = (np.array(p[name]) for name in ("s", "y", "z", "inclination"))
        at = np.arange(s[0], s[-1], step)
        self.y, self.z, turn = (np.interp(at, s, values) for values in (y, z, inclination))
        self.outwards = np.column_stack([np.sin(turn), -np.cos(turn)])
        self.stations = np.linspace(-32.0, 16.0, stations)
        # what each point is lowered by for 1 mm at each station: straight lines between; the ends of the head stay. [point][station]
        knots = np.concatenate([[self.stations[0] - 6], self.stations, [self.stations[-1] + 6]])
        self.share = np.column_stack([np.interp(at, knots, row) for row in np.eye(len(knots))[1:-1]])

    def points(self, depth):
        lowered = (self.share @ depth)[:, None] * self.outwards
        return self.y - lowered[:, 0], self.z - lowered[:, 1]

    def profile(self, depth):
        return bem_contact.Profile(*self.points(depth), "rail")


def collective(shape, depth, size, derivatives=None):
    """T-gamma (N) and pmax (MPa) of each contact."""
    found = [bem_contact.solve(scene(shape.profile(depth), lateral, load, size), derivatives=derivatives)
             for lateral, load, _ in COLLECTIVE]
    if not all(r.certified for r in found):
        raise RuntimeError("a contact has no certified solution")
    return found


class Objective:
    """The mean over the collective of (T-gamma over that of 60E1 + pmax over that of 60E1) / 2, and its gradient."""

    def __init__(self, shape, size):
        self.shape, self.size, self.solutions = shape, size, 0
        self.first = [(r.T_gamma, r.pmax) for r in collective(shape, np.zeros(len(shape.stations)), size)]

    def value(self, depth):
        found = collective(self.shape, depth, self.size)
        return sum(share * (r.T_gamma / wear + r.pmax / pressure) / 2
                   for r, (wear, pressure), (_, _, share) in zip(found, self.first, COLLECTIVE))

    def __call__(self, depth):
        """The value and its gradient."""
        value, slope = 0.0, np.zeros(len(depth))
        found = collective(self.shape, depth, self.size, ["rail_profile"])
        self.solutions += len(found)
        for r, (wear, pressure), (_, _, share) in zip(found, self.first, COLLECTIVE):
            value += share * (r.T_gamma / wear + r.pmax / pressure) / 2
            points = r.derivatives["rail_profile"]["points"]
            by_point = np.array(points["T_gamma"]) / wear + np.array(points["pmax"]) / pressure
            # the point as read is this one; its normal has turned a little with the shape
            slope -= share / 2 * (by_point @ self.shape.share)
        return value, slope


def shaped(stations=8, most=0.3, size=0.6, steps=20):
    """The shape, its objective, depths, and the values before and after."""
    shape = Shape(stations)
    objective = Objective(shape, size)
    start = objective(np.zeros(stations))[0]
    found = minimize(objective, np.zeros(stations), jac=True, method="L-BFGS-B", bounds=[(0, most)] * stations,
                     options={"maxiter": steps, "ftol": 1e-6})
    return shape, objective, found.x, start, found.fun


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--stations", type=int, default=8, help="at which depths are chosen (8)")
    parser.add_argument("--most", type=float, default=0.3, help="largest depth, mm (0.3)")
    parser.add_argument("--size", type=float, default=0.6, help="of elements, mm (0.6)")
    asked = parser.parse_args()
    shape, objective, depth, start, end = shaped(asked.stations, asked.most, asked.size)
    print(f"objective {start:.4f} -> {end:.4f} with {objective.solutions} solutions")
    for s, d in zip(shape.stations, depth):
        print(f"  s = {s:6.1f} mm: {d:.3f} mm of steel removed")
    fine = Objective(shape, 0.7 * asked.size)
    print(f"solved again on elements of {fine.size:.2f} mm: 1.0000 -> {fine.value(depth):.4f}")
    for (wear, pressure), r, (lateral, _, _) in zip(fine.first, collective(shape, depth, fine.size), COLLECTIVE):
        print(f"  lateral {lateral:5.2f} mm: T-gamma {wear:6.2f} -> {r.T_gamma:6.2f} N, pmax {pressure:6.0f} -> {r.pmax:6.0f} MPa")


if __name__ == "__main__":
    main()
