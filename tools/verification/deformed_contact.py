"""Contact without friction of a wheel and a rail with exact kinematics, in Python: nothing of the solver is used.

The gap is measured from the rail's deformed surface, along its deformed normal, to the wheel's deformed surface; pressure acts
along that normal, and the opposite force on the elements of the wheel which the normal meets. Displacements are linear in these
tractions, by influence numbers of each body. Everything is symmetric in x; elements have x >= 0 and are counted [column][row].
Signs and frames are those of bem_contact/THEORY.md, section 2: mm, N, MPa.
"""

import numpy as np
from scipy.interpolate import CubicSpline
from scipy.sparse import coo_matrix

ROUNDS, GAP_TOLERANCE = 60, 1e-8  # mm


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


class DeformedContact:
    """Rail rows at `rail_s`, wheel rows at `wheel_s` (opposite, so descending), elements dx long, `columns` of them with
    x >= 0. Poses: (y, z) of the sections' origins, the wheel's where it just touches. numbers: [m][I][i][J][j] per MPa
    on true area, rows as in rail_s and wheel_s."""

    def __init__(self, rail, wheel, rail_origin, wheel_origin, wheel_radius, rail_s, wheel_s, dx, columns, rail_numbers,
                 wheel_numbers, kinematics="exact"):
        self.rail, self.wheel, self.wheel_origin, self.radius = rail, wheel, np.asarray(wheel_origin, float), wheel_radius
        self.s, self.wheel_s, self.dx, self.columns = rail_s, wheel_s, dx, columns
        self.ds, self.kinematics = rail_s[1] - rail_s[0], kinematics
        self.rail_matrix, self.wheel_matrix = folded(rail_numbers, columns), folded(wheel_numbers, columns)
        self.x, rows = dx * np.arange(columns), len(rail_s)
        self.weight = np.where(np.arange(columns) == 0, 1.0, 2.0)[:, None] * np.ones(rows) * dx * self.ds
        angle = rail.inclination(rail_s)
        self.delta = angle
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

    def moved(self, pressure, normal, spread):
        """Displacements of the rail's elements and, where their normals meet it, of the wheel; track frame."""
        shape = self.place.shape
        force = pressure[..., None] * normal
        own = np.einsum("mIca,mIa->mIc", self.rail_frame, force)
        rail = np.einsum("mIca,mIc->mIa", self.rail_frame, (self.rail_matrix @ own.ravel()).reshape(shape))
        double = self.weight.ravel()  # what an element stands for: the one at x = 0 is not doubled
        there = (spread.T @ (-force.reshape(-1, 3) * double[:, None])) / double[:, None]
        own = np.einsum("mIca,mIa->mIc", self.wheel_frame, there.reshape(shape))
        wheel = np.einsum("mIca,mIc->mIa", self.wheel_frame, (self.wheel_matrix @ own.ravel()).reshape(shape))
        return rail, (spread @ wheel.reshape(-1, 3)).reshape(shape)

    def deformed_normal(self, rail):
        """Of the deformed rail, and its area over that of the undeformed one."""
        mirrored = np.concatenate([rail[1:2] * [-1, 1, 1], rail])
        along = np.gradient(mirrored, self.dx, axis=0)[1:] + [1, 0, 0]
        across = np.gradient(rail, self.ds, axis=1) + self.es
        normal = np.cross(along, across)
        area = np.linalg.norm(normal, axis=-1)
        return normal / area[..., None], area

    def gap(self, pressure, approach, state):
        """Distance of the deformed surfaces along the rail's normal; `state`: (normal, spread, area) of the last round, and the
        next one is returned."""
        normal, spread, area = state
        rail, wheel = self.moved(pressure, normal, spread)
        if self.kinematics == "linear":
            g, _, _ = self.at_wheel(self.place, 0.0, normal)
            return g - approach * self.en[:, 2] - np.einsum("mIa,mIa->mI", wheel - rail, normal), state
        if self.kinematics != "undeformed normal":
            normal, area = self.deformed_normal(rail)
        g, column, row = self.at_wheel(self.place + rail - wheel, approach, normal)
        return g, (normal, self.spread(column, row), area)

    def solve(self, force):
        """{quantity: value} under the vertical force."""
        shape, en = self.place.shape[:2], np.broadcast_to(self.en, self.place.shape)
        g, column, row = self.at_wheel(self.place, 0.0, en)
        state = (en.copy(), self.spread(column, row), np.ones(shape))
        matrix = self.normal_matrix(state[1])
        pressure, approach = np.zeros(shape), 0.0
        cosine = np.broadcast_to(self.en[:, 2], shape)
        for rounds in range(ROUNDS):
            g, state = self.gap(pressure, approach, state)
            h = g - (matrix @ pressure.ravel()).reshape(shape) + approach * cosine
            # All that is left of an exact solution: gap where there is pressure, overlap, and force.
            total = (pressure * state[0][..., 2] * self.weight).sum()
            error = max(np.abs(np.where(pressure > 0, g, np.minimum(g, 0))).max(), abs(total / force - 1) * 0.1)
            if rounds > 1 and error < GAP_TOLERANCE:
                break
            pressure, approach = solve_normal(matrix, h, cosine, state[0][..., 2] * self.weight, force, pressure > 0)
        normal, _, area = state
        f = (pressure * self.weight)[..., None] * normal
        on = pressure > 0
        self.require_inside(on)
        return {"Fy": f[..., 1].sum(), "Fz": f[..., 2].sum(), "approach": approach, "pmax": (pressure / area).max(),
                "area": self.weight[on].sum(), "centre of pressure, s": (pressure * self.weight * self.s).sum()
                / (pressure * self.weight).sum(), "rounds": rounds, "error": error, "pressure": pressure, "normal": normal}

    def require_inside(self, on):
        if on[:, [0, -1]].any() or on[-1].any():
            raise ValueError("the contact reaches the border of the strip")

    def normal_matrix(self, spread):
        """d gap / d pressure of the undeformed geometry."""
        size = self.columns * len(self.s)
        n_rail = (self.rail_matrix.reshape(size, 3, size, 3))[:, 2, :, 2]
        double = self.weight.ravel()
        n_wheel = (self.wheel_matrix.reshape(size, 3, size, 3))[:, 2, :, 2]
        return n_rail + spread @ (n_wheel * (1 / double)) @ spread.T.toarray() * double


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
