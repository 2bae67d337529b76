"""Contact without friction of a wheel and a rail with exact kinematics, in Python: nothing of the solver is used.

The gap is measured from the rail's deformed surface, along its deformed normal, to the wheel's deformed surface; pressure acts
along that normal, and the opposite force on the elements of the wheel which the normal meets. Displacements are linear in these
tractions, by influence numbers of each body. Everything is symmetric in x; elements have x >= 0 and are counted [column][row].
Signs and frames are those of bem_contact/theory/contact.md, section 2: mm, N, MPa.
"""

from dataclasses import dataclass

import numpy as np
from scipy.interpolate import CubicSpline
from scipy.sparse import coo_matrix

ROUNDS, GAP_TOLERANCE = 60, 1e-6  # mm


class Surface:
    """A profile in its section: y and z over the arc length s."""

    def __init__(self, s, y, z):
        self.y, self.z = CubicSpline(s, y), CubicSpline(s, z)
        order = np.argsort(y)
        self.s_of_y = CubicSpline(y[order], s[order])
        self.z_of_y = CubicSpline(y[order], z[order])

    def inclination(self, s):
        return np.arctan2(self.z(s, 1), self.y(s, 1))


def folded(numbers, columns):
    """The matrix from tractions to displacements of elements with x >= 0, [3 element + component], of influence numbers
    [m][I][i][J][j] with 2 columns - 1 offsets or more, and tractions symmetric in x."""
    rows = numbers.shape[1]
    odd = np.array([True, False, False])
    parity = np.where(odd[:, None] == odd[None, :], 1.0, -1.0)  # of A_ij in x
    mirror = np.where(odd, -1.0, 1.0)  # of t_j in x
    m = np.arange(columns)
    ahead, behind = m[:, None] - m[None, :], m[:, None] + m[None, :]
    out = np.zeros((columns, rows, 3, columns, rows, 3))
    direct = numbers[np.abs(ahead)]  # [m][m'][I][i][J][j]
    direct = np.where((ahead < 0)[:, :, None, None, None, None], direct * parity[None, None, None, :, None, :], direct)
    out += direct.transpose(0, 2, 3, 1, 4, 5)
    across = numbers[behind] * mirror * (m > 0)[None, :, None, None, None, None]
    out += across.transpose(0, 2, 3, 1, 4, 5)
    size = 3 * columns * rows
    return out.reshape(size, size)


@dataclass
class Bodies:
    """Where wheel and rail stand as they touch: (y, z) of their sections' origins, mm."""

    rail: Surface
    wheel: Surface
    rail_origin: tuple
    wheel_origin: tuple
    wheel_radius: float  # at z = 0 of its section


@dataclass
class Elements:
    """Rows on the rail, ascending, and about opposite on the wheel, descending; elements with x = 0, dx .. (columns - 1) dx."""

    rail_s: np.ndarray
    wheel_s: np.ndarray
    dx: float
    columns: int


class DeformedContact:
    """numbers: influence numbers [m][I][i][J][j] of each body in its own frame, mm per MPa on true area, rows in the order of
    the elements, 2 columns - 1 offsets or more."""

    def __init__(self, bodies, elements, rail_numbers, wheel_numbers):
        rail, wheel, wheel_radius = bodies.rail, bodies.wheel, bodies.wheel_radius
        rail_origin, rail_s, wheel_s = bodies.rail_origin, elements.rail_s, elements.wheel_s
        dx, columns = elements.dx, elements.columns
        self.wheel, self.wheel_origin, self.radius = wheel, np.asarray(bodies.wheel_origin, float), wheel_radius
        self.s, self.wheel_s, self.dx, self.columns = rail_s, wheel_s, dx, columns
        self.ds = rail_s[1] - rail_s[0]
        self.rail_matrix, self.wheel_matrix = folded(rail_numbers, columns), folded(wheel_numbers, columns)
        self.x, rows = dx * np.arange(columns), len(rail_s)
        self.weight = np.where(np.arange(columns) == 0, 1.0, 2.0)[:, None] * np.ones(rows) * dx * self.ds
        angle = rail.inclination(rail_s)
        self.es = np.stack([0 * angle, np.cos(angle), np.sin(angle)], -1)
        self.en = np.stack([0 * angle, -np.sin(angle), np.cos(angle)], -1)
        self.place = np.zeros((columns, rows, 3))
        self.place[..., 0] = self.x[:, None]
        self.place[..., 1] = rail_origin[0] + rail.y(rail_s)
        self.place[..., 2] = rail_origin[1] + rail.z(rail_s)
        self.rail_frame = np.broadcast_to(np.stack([np.broadcast_to([1.0, 0, 0], self.es.shape), self.es, self.en], -2),
                                          (columns, rows, 3, 3))  # [.., own component, track component]
        self.radius_here = wheel_radius + float(wheel.z(np.mean(wheel_s)))
        inclined = wheel.inclination(wheel_s)
        turn = self.x / self.radius_here
        flat = np.stack([np.stack([1 + 0 * inclined, 0 * inclined, 0 * inclined], -1),
                         np.stack([0 * inclined, np.cos(inclined), np.sin(inclined)], -1),
                         np.stack([0 * inclined, -np.sin(inclined), np.cos(inclined)], -1)], -2)
        c, s = np.cos(turn), np.sin(turn)
        about = np.zeros((columns, 3, 3))  # takes vectors of the section through the axle to the track
        about[:, 0, 0], about[:, 0, 2], about[:, 2, 0], about[:, 2, 2], about[:, 1, 1] = c, s, -s, c, 1
        self.wheel_frame = np.einsum("mab,Icb->mIca", about, flat)

    def at_wheel(self, points, approach, normal):
        """Distance from points along -normal to the wheel, lowered by `approach` but not deformed; where it is met, as
        (column, row) of the wheel's elements, fractional."""
        axle = self.wheel_origin[1] + approach - self.radius
        g = np.zeros(points.shape[:-1])
        for _ in range(8):
            p = points - g[..., None] * normal
            y, rho = p[..., 1] - self.wheel_origin[0], np.hypot(p[..., 0], p[..., 2] - axle)
            f = rho - self.radius - self.wheel.z_of_y(y)
            slope = (p[..., 0] * normal[..., 0] + (p[..., 2] - axle) * normal[..., 2]) / rho \
                - self.wheel.z_of_y(y, 1) * normal[..., 1]
            g = g + f / slope
        p = points - g[..., None] * normal
        s = self.wheel.s_of_y(p[..., 1] - self.wheel_origin[0])
        along = self.radius_here * np.arctan2(p[..., 0], p[..., 2] - axle)
        return g, along / self.dx, (self.wheel_s[0] - s) / self.ds

    def spread(self, column, row):
        """Matrix [element of the rail][element of the wheel] of linear interpolation."""
        rows = len(self.s)
        column, row = np.clip(column.ravel(), 0, self.columns - 1), np.clip(row.ravel(), 0, rows - 1)
        m, i = np.minimum(column.astype(int), self.columns - 2), np.minimum(row.astype(int), rows - 2)
        u, v, here = column - m, row - i, np.arange(column.size)
        parts = [(m, i, (1 - u) * (1 - v)), (m + 1, i, u * (1 - v)), (m, i + 1, (1 - u) * v), (m + 1, i + 1, u * v)]
        return coo_matrix((np.concatenate([w for _, _, w in parts]),
                           (np.tile(here, 4), np.concatenate([a * rows + b for a, b, _ in parts]))),
                          shape=(here.size, here.size)).tocsr()

    def moved(self, pressure, normal, spread, loaded):
        """Displacements of the rail's elements and, where their normals meet it, of the wheel; track frame. `spread`, `loaded`:
        where their normals meet it, and where it bears their forces."""
        shape = self.place.shape
        force = pressure[..., None] * normal
        own = np.einsum("mIca,mIa->mIc", self.rail_frame, force)
        rail = np.einsum("mIca,mIc->mIa", self.rail_frame, (self.rail_matrix @ own.ravel()).reshape(shape))
        double = self.weight.ravel()  # what an element stands for: the one at x = 0 is not doubled
        there = (loaded.T @ (-force.reshape(-1, 3) * double[:, None])) / double[:, None]
        own = np.einsum("mIca,mIa->mIc", self.wheel_frame, there.reshape(shape))
        wheel = np.einsum("mIca,mIc->mIa", self.wheel_frame, (self.wheel_matrix @ own.ravel()).reshape(shape))
        return rail, (spread @ wheel.reshape(-1, 3)).reshape(shape)

    def deformed_normal(self, rail):
        """Of the deformed rail."""
        mirrored = np.concatenate([rail[1:2] * [-1, 1, 1], rail])
        along = np.gradient(mirrored, self.dx, axis=0)[1:] + [1, 0, 0]
        across = np.gradient(rail, self.ds, axis=1) + self.es
        normal = np.cross(along, across)
        return normal / np.linalg.norm(normal, axis=-1)[..., None]

    def gap(self, pressure, approach, state, loaded):
        """Distance of the deformed surfaces along the rail's normal; `state`: (normal, spread) of the last round, and the
        next one is returned."""
        rail, wheel = self.moved(pressure, *state, loaded)
        normal = self.deformed_normal(rail)
        g, column, row = self.at_wheel(self.place + rail - wheel, approach, normal)
        return g, (normal, self.spread(column, row))

    def solve(self, force, slices=False, stay=False):
        """{quantity: value} under the vertical force. The area of pmax is the undeformed one, as influence numbers have it.
        slices: each column is a slice in plane strain, and contact may reach the last one. stay: forces on the wheel stay on
        the elements that were opposite as the bodies touched: not exact, and here to show what that does."""
        shape, en = self.place.shape[:2], np.broadcast_to(self.en, self.place.shape)
        g, column, row = self.at_wheel(self.place, 0.0, en)
        state = (en, self.spread(column, row))
        first, matrix = state[1], self.normal_matrix(state[1])
        pressure, approach = np.zeros(shape), 0.0
        cosine = np.broadcast_to(self.en[:, 2], shape)
        for rounds in range(ROUNDS):
            g, state = self.gap(pressure, approach, state, first if stay else state[1])
            h = g - (matrix @ pressure.ravel()).reshape(shape) + approach * cosine
            # All that is left of an exact solution: gap where there is pressure, overlap, and force.
            total = (pressure * state[0][..., 2] * self.weight).sum()
            error = max(np.abs(np.where(pressure > 0, g, np.minimum(g, 0))).max(), abs(total / force - 1) * 0.1)
            if rounds > 1 and error < GAP_TOLERANCE:
                break
            pressure, approach = solve_normal(matrix, h, cosine, state[0][..., 2] * self.weight, force, pressure > 0)
        else:
            raise ValueError(f"no solution after {ROUNDS} rounds: {error:.1e} mm are left")
        f = (pressure * self.weight)[..., None] * state[0]
        on = pressure > 0
        if on[:, [0, -1]].any() or (on[-1].any() and not slices):
            raise ValueError("the contact reaches the border of the strip")
        return {"Fy": f[..., 1].sum(), "Fz": f[..., 2].sum(), "approach": approach, "pmax": pressure.max(),
                "area": self.weight[on].sum(), "centre of pressure, s": (pressure * self.weight * self.s).sum()
                / (pressure * self.weight).sum()}

    def normal_matrix(self, spread):
        """d gap / d pressure of the undeformed geometry."""
        size = self.columns * len(self.s)
        n_rail = (self.rail_matrix.reshape(size, 3, size, 3))[:, 2, :, 2]
        double = self.weight.ravel()
        n_wheel = (self.wheel_matrix.reshape(size, 3, size, 3))[:, 2, :, 2]
        return n_rail + spread @ (n_wheel * (1 / double)) @ spread.T.toarray() * double


def plane_strain_numbers(rows, ds, shear, poisson, distance=40.0):
    """Of a half-space in slices of plane strain, [4][I][i][J][j] (bem_contact/theory/numbers.md, section 2); columns do not meet."""
    step = np.arange(rows)[:, None] - np.arange(rows)[None, :]

    def mean(antiderivative):
        return sum(w * antiderivative((step + k) * ds) for k, w in ((-1, 1), (0, -2), (1, 1))) / ds**2
    log = mean(lambda s: 0.5 * s * s * np.log(np.maximum(np.abs(s), 1e-300)) - 0.75 * s * s) - np.log(distance)
    sign = mean(lambda s: 0.5 * s * np.abs(s))
    out = np.zeros((4, rows, 3, rows, 3))
    out[0, :, 2, :, 2] = out[0, :, 1, :, 1] = -(1 - poisson) / (np.pi * shear) * ds * log
    out[0, :, 0, :, 0] = -ds / (np.pi * shear) * log
    out[0, :, 2, :, 1] = (1 - 2 * poisson) / (4 * shear) * ds * sign
    out[0, :, 1, :, 2] = -out[0, :, 2, :, 1]
    return out


def solve_normal(matrix, h, cosine, lift, force, start):
    """Pressure and approach: gap = h - q cos + matrix p >= 0, p >= 0, p gap = 0, sum(lift p) = force (active sets)."""
    shape, h, c, lift = h.shape, h.ravel(), cosine.ravel(), lift.ravel()
    on = start.ravel().copy()
    if not on.any():
        on = h < np.partition(h, 20)[20]
    for _ in range(200):
        k = np.flatnonzero(on)
        both = np.linalg.solve(matrix[np.ix_(k, k)], np.column_stack([-h[k], c[k]]))
        approach = (force - lift[k] @ both[:, 0]) / (lift[k] @ both[:, 1])
        p = np.zeros(h.size)
        p[k] = both[:, 0] + approach * both[:, 1]
        gap = h - approach * c + matrix @ p
        following = np.where(on, p > 0, gap < 0)
        if (following == on).all():
            return p.reshape(shape), approach
        on = following
    raise ValueError("the active sets do not end")
