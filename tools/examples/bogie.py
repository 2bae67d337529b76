"""A bogie of two wheelsets whose wheel-rail forces come from bem_contact: a table, or solutions. Units mm, N, s, rad.

The bogie moves sideways and yaws, and so do its wheelsets; each wheelset turns about its axle without a torque. The body above
runs along the track with the speed V. y is to the right, yaw turns the front to the right, both from the track at that place.
Each wheel bears a constant load (in a curve the superelevation balances the centrifugal force), and its forces depend on three
numbers: how far it is to the right, its angle of attack, and its longitudinal creepage. Spin of the yawing wheelset is left out: its
force is a thousandth of the others.
"""

from dataclasses import dataclass

import numpy as np
from scipy.integrate import solve_ivp

import bem_contact
from linear_model import ConedPair
from wheelset import Wheelset


@dataclass(frozen=True)
class Parameters:
    wheelset_mass: float = 1.5  # N s^2/mm, which is tonnes
    wheelset_yaw: float = 8e5  # N mm s^2
    wheelset_pitch: float = 1e5  # N mm s^2, about the axle
    frame_mass: float = 2.5
    frame_yaw: float = 2.5e6
    half_base: float = 1250.0  # mm, from the middle of the bogie to a wheelset
    primary_lateral: float = 6e3  # N/mm, of a wheelset, both sides
    primary_yaw: float = 6e9  # N mm/rad, of a wheelset
    secondary_lateral: float = 400.0  # N/mm
    secondary_damper: float = 40.0  # N s/mm
    secondary_yaw: float = 3e8  # N mm/rad
    pivots: float = 9500.0  # mm, from the middle of the body to the middle of this bogie, the first one
    radius: float = 460.0  # mm, of the wheels at rest
    half_gauge: float = 750.0  # mm, from the middle of the track to the wheels
    weight: float = 1e5  # N, on a wheelset's two wheels
    roll: float = 0.0  # rad/mm, as a wheelset moves sideways; it turns the normals and moves the contacts
    roll_arm: float = 0.0  # mm: by it times the roll a wheel is farther to the right (a cone on an arc: both radii)


def coned_parameters():
    """Those of coned_bogie.toml. A cone moves sideways without a turn of the normals but for the roll (linear_model.py)."""
    pair, wheelset = ConedPair(), Wheelset()
    return Parameters(half_gauge=pair.half_distance, roll=pair.conicity(wheelset) / pair.half_distance,
                      roll_arm=pair.head_radius + pair.radius(wheelset))


COLUMNS = ["Fx", "Fy", "Mz", "reference_y"]
AXES = ["position.lateral", "position.yaw", "motion.xi"]


class TableContact:
    """A right wheel by a table of `bem_contact table`: forces with derivatives in one look-up."""

    def __init__(self, table):
        self.table, self.calls = table, 0

    def __call__(self, inputs):
        """Fx, Fy (N) and the moment about the vertical through the middle of the track (N mm), [3], and their derivatives [3][3]."""
        self.calls += 1
        found = self.table.force(list(inputs), COLUMNS)
        v = found["values"]
        d = {name: np.array([found["derivatives"][name][axis] for axis in AXES]) for name in COLUMNS}
        return (np.array([v["Fx"], v["Fy"], v["Mz"] - v["reference_y"] * v["Fx"]]),
                np.array([d["Fx"], d["Fy"], d["Mz"] - v["reference_y"] * d["Fx"] - v["Fx"] * d["reference_y"]]))


class SolvedContact:
    """The same by a solution each time, which starts from the one before; derivatives by differences, where they are asked for."""

    steps = 1e-3, 1e-6, 1e-6

    def __init__(self, scene, model="halfspace"):
        self.sequence, self.model, self.calls = bem_contact.Sequence(scene), model, 0

    def forces(self, inputs):
        self.calls += 1
        r = self.sequence.solve(dict(zip(AXES, map(float, inputs))) | {"solver.model": self.model})
        if not r.certified:
            raise RuntimeError(f"no certified solution at {inputs}")
        return np.array([r.Fx, r.Fy, r.Mz - r.reference_y * r.Fx])

    def __call__(self, inputs):
        inputs = np.asarray(inputs, dtype=float)
        slopes = np.array([(self.forces(inputs + h) - self.forces(inputs - h)) / (2 * h.sum())
                           for h in np.diag(self.steps)])
        return self.forces(inputs), slopes.T


class Bogie:
    """The equations of motion: state' = matrix @ state + constant + the wheels.

    A state is y and yaw of the first wheelset, of the second, and of the frame, their rates in the same order, and for each wheelset
    how much faster than the bogie its wheels turn (mm/s at the nominal radius): [14]. `curve`: radius in mm, above 0 to the right.
    """

    names = "1R", "1L", "2R", "2L"

    def __init__(self, contact, speed, parameters=Parameters(), curve=np.inf):
        p = self.parameters = parameters
        self.contact, self.speed, self.curve = contact, speed, curve
        # What each wheel is given, by the state: inputs = of_state @ state + of_curve.
        self.of_state, self.of_curve, self.into = [], [], []
        for axle in range(2):
            for side in (1, -1):
                rows = np.zeros((3, 14))
                rows[0, 2 * axle] = side * (1 + p.roll * p.roll_arm)
                rows[1, 2 * axle + 1] = side
                rows[1, 6 + 2 * axle] = -side * (1 + p.roll * p.radius) / speed
                rows[2, 7 + 2 * axle] = -side * p.half_gauge / speed
                rows[2, 12 + axle] = -1 / speed
                self.of_state.append(rows)
                self.of_curve.append(np.array([0, 0, -side * p.half_gauge / curve]))
                into = np.zeros((14, 3))  # forces on the rail act on the wheelset the other way; a left wheel is a mirror image
                into[6 + 2 * axle, 1] = -side / p.wheelset_mass
                into[7 + 2 * axle, 2] = -side / p.wheelset_yaw
                into[12 + axle, 0] = p.radius**2 / p.wheelset_pitch
                self.into.append(into)
        self.matrix, self.constant = np.zeros((14, 14)), np.zeros(14)
        self.matrix[:6, 6:12] = np.eye(6)
        self.springs()

    def springs(self):
        p, a = self.parameters, self.parameters.half_base
        mass = np.array([p.wheelset_mass, p.wheelset_yaw] * 2 + [p.frame_mass, p.frame_yaw])

        def spring(stiffness, stretch, offset=0.0, damper=0.0):
            """Of energy stiffness (stretch @ q + offset)^2 / 2."""
            self.matrix[6:12, :6] -= stiffness * np.outer(stretch, stretch) / mass[:, None]
            self.matrix[6:12, 6:12] -= damper * np.outer(stretch, stretch) / mass[:, None]
            self.constant[6:12] -= stiffness * offset * np.array(stretch) / mass

        # In a curve the track is at the wheelsets to the right of its tangent in the middle, and turned.
        for y in (0, 2):  # the load, as the normals turn
            spring(p.weight * p.roll, [i == y for i in range(6)])
        spring(p.primary_lateral, [1, 0, 0, 0, -1, -a], a**2 / (2 * self.curve))
        spring(p.primary_lateral, [0, 0, 1, 0, -1, a], a**2 / (2 * self.curve))
        spring(p.primary_yaw, [0, 1, 0, 0, 0, -1], a / self.curve)
        spring(p.primary_yaw, [0, 0, 0, 1, 0, -1], -a / self.curve)
        spring(p.secondary_lateral, [0, 0, 0, 0, 1, 0], damper=p.secondary_damper)
        spring(p.secondary_yaw, [0, 0, 0, 0, 0, 1], p.pivots / self.curve)

    def inputs(self, state):
        """Of each wheel: to the right, angle of attack, longitudinal creepage; a left one as its mirror image. [4][3]"""
        return [rows @ state + more for rows, more in zip(self.of_state, self.of_curve)]

    def __call__(self, time, state):
        forces = self.contact.forces if hasattr(self.contact, "forces") else lambda inputs: self.contact(inputs)[0]
        return self.matrix @ state + self.constant + sum(into @ forces(at) for into, at in zip(self.into, self.inputs(state)))

    def jacobian(self, time, state):
        """From the derivatives of the contact: no differences of the motion."""
        return self.matrix + sum(into @ self.contact(at)[1] @ rows
                                 for into, rows, at in zip(self.into, self.of_state, self.inputs(state)))

    def run(self, start, duration, jacobian=None, **more):
        """SciPy's Radau. Another bogie's jacobian will do where it is too dear here: it only guides the integrator."""
        return solve_ivp(self, [0, duration], start, method="Radau", jac=jacobian or self.jacobian,
                         **{"rtol": 1e-6, "atol": 1e-7, **more})
