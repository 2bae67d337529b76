"""A free wheelset on straight track whose wheel-rail forces all come from bem_contact. Units mm, N, s, rad.

The wheelset moves sideways (y, to the right) and yaws (psi, its front to the right), held by springs between it and a
frame that runs straight ahead with the speed V. It turns about its axle without a torque. Vertically and in roll it
follows the rails: its height and its roll are those at which the contact forces carry the weight. So vertical vibrations
are left out, as in the textbook model (Wickens 2003; Knothe and Stichel 2017).
"""

import time
from dataclasses import dataclass

import numpy as np
from scipy.interpolate import CubicSpline
from scipy.optimize import brentq

import bem_contact


@dataclass(frozen=True)
class Wheelset:
    mass: float = 1.25  # N s^2/mm, which is tonnes
    yaw_inertia: float = 7e5  # N mm s^2
    pitch_inertia: float = 1e5  # N mm s^2, about the axle
    weight: float = 1e5  # N, of the wheelset and what it carries
    lateral_stiffness: float = 200.0  # N/mm, between frame and wheelset, both sides
    yaw_stiffness: float = 4e8  # N mm/rad
    radius: float = 460.0  # mm, at the tape circle


@dataclass
class Forces:
    """On the rail, track axes, about the wheelset's centre: N, N mm. Each [3]."""

    force: np.ndarray
    moment: np.ndarray
    approach: float  # mm, negative: the wheel hangs above the rail
    arm: float  # mm, where Fz acts, to the right


class Wheel:
    """One of the two wheels. It remembers its last case, so that each solution starts from the one before."""

    def __init__(self, scene, side, warm=True):
        self.scene, self.side, self.sign = scene, side, 1 if side == "right" else -1
        self.sequence = bem_contact.Sequence(scene)
        self.warm, self.calls, self.seconds = warm, 0, 0.0

    def solve(self, changes):
        begin = time.perf_counter()
        changes = changes | {"position.side": self.side}
        result = self.sequence.solve(changes) if self.warm else bem_contact.solve(self.scene, changes)
        self.seconds += time.perf_counter() - begin
        self.calls += 1
        if not result.certified:
            raise RuntimeError(f"no certified solution at {changes}")
        return result

    def forces(self, changes, centre):
        """Sums of the tractions; `centre`: (y, z) of the wheelset."""
        r = self.solve(changes)
        area = (r.x[1] - r.x[0]) * (r.s[1] - r.s[0])
        cosine, sine = np.cos(r.delta), np.sin(r.delta)
        along_x, along_s, normal = (area * p for p in (r.p_x, r.p_s, r.p_n))
        rows = np.array([along_x.sum(1), cosine * along_s.sum(1) - sine * normal.sum(1),
                         sine * along_s.sum(1) + cosine * normal.sum(1)])  # [3][ms]
        shear_ahead, normal_ahead = along_s @ r.x, normal @ r.x
        y, z = r.y - self.sign * centre[0], r.z - centre[1]
        fx, fy, fz = rows
        moment = [y @ fz - z @ fy, z @ fx - (sine * shear_ahead + cosine * normal_ahead).sum(),
                  (cosine * shear_ahead - sine * normal_ahead).sum() - y @ fx]
        # The left wheel is a mirror image: what points along y changes sign, and so do moments about x and z.
        mirror = np.array([1, self.sign, 1])
        arm = self.sign * (y @ fz / r.Fz if r.Fz > 0 else y.mean())
        return Forces(mirror * rows.sum(1), self.sign * mirror * moment, r.approach, arm)


class Track:
    """Wheelset, springs and rails: the right-hand side of the equations of motion.

    A state is y, psi, dy/dt, dpsi/dt and the angular speed about the axle.
    """

    usual_approach = 0.06  # mm, where the search for the equilibrium begins
    longest_step = 0.05  # mm, of that search

    def __init__(self, scene, speed, wheelset=Wheelset(), reach=1.0, warm=True):
        self.speed, self.wheelset = speed, wheelset
        self.wheels = Wheel(scene, "right", warm), Wheel(scene, "left", warm)
        self.pitch_rate = speed / wheelset.radius
        self.rest = lambda y, order=0: np.zeros(2)
        self.last = 0.0, np.zeros(2)  # y, height and roll of the last equilibrium
        self.follow(reach)
        # Now that which turns the wheelset freely:
        self.pitch_rate = brentq(lambda rate: self(0, [0, 0, 0, 0, rate])[4], 0.99 * self.pitch_rate,
                                 1.01 * self.pitch_rate, xtol=1e-7 * self.pitch_rate)

    def follow(self, reach):
        """Height and roll at rest, up to `reach` mm to both sides, from the centre outwards. Their slopes give the
        vertical and the roll velocity in motion; their values, where the search for the equilibrium begins."""
        lateral = np.linspace(0, reach, 2 * int(np.ceil(reach / 0.5)) + 1)
        found = []
        for y in lateral:
            self.equilibrium([y, 0, 0, 0, self.pitch_rate])
            found.append(self.last[1])
        height, roll = np.array(found).T
        both_sides = np.array([np.concatenate([height[:0:-1], height]), np.concatenate([-roll[:0:-1], roll])])
        self.rest = CubicSpline(np.concatenate([-lateral[:0:-1], lateral]), both_sides.T)

    def contact(self, state, height, roll):
        y, yaw, lateral_velocity, yaw_rate, pitch_rate = state
        sink, tilt = self.rest(y, 1) * lateral_velocity
        changes = {"position.lateral": y, "position.yaw": yaw, "position.roll": roll, "position.vertical": height,
                   "motion.speed": self.speed, "motion.pitch_rate": pitch_rate,
                   "motion.lateral_velocity": lateral_velocity, "motion.yaw_rate": yaw_rate,
                   "motion.vertical_velocity": sink, "motion.roll_rate": tilt}
        return [wheel.forces(changes, (y, height - self.wheelset.radius)) for wheel in self.wheels]

    def equilibrium(self, state):
        """The contact forces with which the wheelset carries its weight: vertical force and moment about x."""
        y, weight = state[0], self.wheelset.weight
        position = self.last[1] + self.rest(y) - self.rest(self.last[0])
        jacobian = before = step = None
        for attempt in range(50):
            # Forces jump by some 1e-5 of the weight where an element enters the contact: then the search may stop there.
            allowed = (1e-5 if attempt < 12 else 2e-4) * weight
            try:
                both = self.contact(state, *position)
            except bem_contact.InputError as error:  # far too deep
                if "beyond elastic" not in str(error):
                    raise
                position, before = position - [2.0, 0.0], None
                continue
            missing = np.array([weight - sum(f.force[2] for f in both), -sum(f.moment[0] for f in both)])
            if abs(missing[0]) + abs(missing[1]) / 750 < allowed:
                self.last = y, position
                return both
            arms = np.array([[1.0, f.arm] for f in both])
            approach = np.array([f.approach for f in both])
            if approach.min() <= 0 or approach.max() > 8 * self.usual_approach:
                step, before = np.linalg.solve(arms, self.usual_approach - approach), None
            else:
                if before is None or attempt % 12 == 0:  # Hertz: Fz grows with the power 3/2 of the approach
                    stiffness = [1.5 * f.force[2] / f.approach for f in both]
                    jacobian = arms.T @ (np.array(stiffness)[:, None] * arms)
                else:  # Broyden
                    jacobian = jacobian + np.outer(before - missing - jacobian @ step, step) / (step @ step)
                step, before = np.linalg.solve(jacobian, missing), missing
                step *= min(1.0, self.longest_step / (abs(step[0]) + 750 * abs(step[1])))
            position = position + step
        raise RuntimeError(f"no vertical equilibrium at y = {y} mm (N, N mm missing: {missing})")

    def __call__(self, time, state):
        y, yaw, lateral_velocity, yaw_rate, _ = state
        w = self.wheelset
        both = self.equilibrium(state)
        force, moment = sum(f.force for f in both), sum(f.moment for f in both)
        return np.array([lateral_velocity, yaw_rate,
                         (-force[1] - w.lateral_stiffness * y) / w.mass,
                         (-moment[2] - w.yaw_stiffness * yaw) / w.yaw_inertia,
                         moment @ [-yaw, 1.0, self.last[1][1]] / w.pitch_inertia])
