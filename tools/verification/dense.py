"""The slow obvious solver: dense matrices in NumPy, Kalker's active sets NORM and TANG in turn (Kalker 1990, sections 4.2, 4.3).

Influence numbers of the half-space come from point loads integrated over the loaded element (Love 1929) and a
numerical mean over the displaced element: nothing of this is the program's. Order of components: x, s, n.
"""

import numpy as np

X, S, N = 0, 1, 2


def smooth_rule(points=48):
    """Nodes and weights on -1 .. 1 that are dense at the ends, where the integrands have logarithms."""
    t, w = np.polynomial.legendre.leggauss(points)
    t = (t + 1) / 2
    return 2 * t**3 * (10 - 15 * t + 6 * t * t) - 1, w * 30 * t * t * (1 - t) ** 2


def at_point(x, s, a, b, shear, poisson):
    """Displacement [3][3] at (x, s) under 1 MPa on a rectangle 2a x 2b of one half-space, n into the body."""
    j1, j2, jxs, jx, js = (np.zeros(np.broadcast(x, s).shape) for _ in range(5))
    for sx in (1, -1):
        for ss in (1, -1):
            u, v, sign = x + sx * a, s + ss * b, sx * ss
            r = np.hypot(u, v)
            j1 += sign * v * np.arcsinh(u / np.abs(v))
            j2 += sign * u * np.arcsinh(v / np.abs(u))
            jxs -= sign * r
            jx += sign * (0.5 * v * np.log(u * u + v * v) + u * np.arctan(v / u))
            js += sign * (0.5 * u * np.log(u * u + v * v) + v * np.arctan(u / v))
    c, e = 1 / (2 * np.pi * shear), (1 - 2 * poisson) / (4 * np.pi * shear)
    zero = (1 - poisson) * (j1 + j2)
    return np.array([[c * (zero + poisson * j1), c * poisson * jxs, -e * jx],
                     [c * poisson * jxs, c * (zero + poisson * j2), -e * js],
                     [e * jx, e * js, c * zero]])


def mean_numbers(offsets_x, offsets_s, dx, ds, shear, poisson):
    """Means over displaced elements, [3][3][len(offsets_x)][len(offsets_s)], mm/MPa, of one half-space."""
    near, far = smooth_rule(), np.polynomial.legendre.leggauss(12)
    out = np.empty((3, 3, len(offsets_x), len(offsets_s)))
    for i, ox in enumerate(offsets_x):
        for k, os in enumerate(offsets_s):
            nodes, weights = far if max(abs(ox / dx), abs(os / ds)) > 4.5 else near
            wx = np.outer(weights, weights) / 4
            x, s = np.meshgrid(ox + nodes * dx / 2, os + nodes * ds / 2, indexing="ij")
            out[:, :, i, k] = np.sum(at_point(x, s, dx / 2, ds / 2, shear, poisson) * wx, axis=(2, 3))
    return out


TURN = np.array([1.0, -1.0, -1.0])  # between the own frames of rail and wheel


def halfspace_pair(mx, ms, dx, ds, rail, wheel):
    """[m][I][i][J][j], m = 0 .. mx + 1, as `bem_contact influence expand` writes them."""
    offsets = np.arange(mx + 2) * dx, np.arange(1 - ms, ms) * ds
    lower = mean_numbers(*offsets, dx, ds, *rail)
    upper = mean_numbers(*offsets, dx, ds, *wheel)[:, :, :, ::-1] * (TURN[:, None] * TURN)[:, :, None, None]
    return by_rows(lower + upper, ms)


def by_rows(numbers, ms):
    index = np.arange(ms)[:, None] - np.arange(ms) + ms - 1
    return numbers[:, :, :, index].transpose(2, 3, 0, 4, 1)  # [i][j][m][I][J] -> [m][I][i][J][j]


def tangent_plane_pair(mx, ms, dx, ds, rail, wheel, rows):
    """A = (Theta H + H Theta)/2 (bem_contact/theory/numbers.md, section 3) on rows of y, z, delta; H of equal bodies at the chord's length."""
    out = np.empty((mx + 2, ms, 3, ms, 3))
    known = {}
    for i in range(ms):
        for j in range(ms):
            chord = np.copysign(np.hypot(rows[i][0] - rows[j][0], rows[i][1] - rows[j][1]), i - j)
            theta = rows[i][2] - rows[j][2]
            key = (round(chord, 10), round(theta, 10))
            if key not in known:
                offsets = np.arange(mx + 2) * dx, [chord]
                c, s = np.cos(theta), np.sin(theta)
                turn = np.array([[1, 0, 0], [0, c, s], [0, -s, c]])
                lower = mean_numbers(*offsets, dx, ds, *rail)[..., 0]
                upper = mean_numbers(offsets[0], [-chord], dx, ds, *wheel)[..., 0] * (TURN[:, None] * TURN)[:, :, None]
                both = lower + upper
                known[key] = 0.5 * (np.einsum("ab,bcm->mac", turn, both) + np.einsum("abm,bc->mac", both, turn))
            out[:, i, :, j, :] = known[key]
    return out


def pair_of_bodies(rail, wheel):
    """A = A_rail + T A_wheel T; the wheel's rows run the other way."""
    return rail + wheel[:, ::-1, :, ::-1, :] * TURN[:, None, None] * TURN


def full_matrix(numbers, mx, ahead=0):
    """[(I, ix) i][(J, jx) j] as one array [i][j][e][f], e = I mx + ix; `ahead`: displacements so many columns ahead."""
    ms = numbers.shape[1]
    parity = np.where((np.arange(3) == X)[:, None] != (np.arange(3) == X), -1.0, 1.0)
    m = np.arange(mx)[:, None] + ahead - np.arange(mx)
    block = numbers[np.abs(m)] * np.where((m < 0)[:, :, None, None, None, None], parity[None, None, None, :, None, :], 1.0)
    return block.transpose(3, 5, 2, 0, 4, 1).reshape(3, 3, ms * mx, ms * mx)  # [ix][jx][I][i][J][j]


def steady_matrix(numbers, mx):
    """Slip of steady rolling: S = dx w - B p (bem_contact/theory/contact.md, section 4)."""
    return 1.5 * full_matrix(numbers, mx) - 2 * full_matrix(numbers, mx, 1) + 0.5 * full_matrix(numbers, mx, 2)


def norm(a, gap, cosine, force, contact):
    """Pressure and approach for a force (over an element's area): the worst element out or in, one after the other."""
    n = len(gap)
    for _ in range(40 * n):
        c = np.flatnonzero(contact)
        system = np.block([[a[np.ix_(c, c)], -cosine[c, None]], [cosine[None, c], np.zeros((1, 1))]])
        y = np.linalg.solve(system, np.append(-gap[c], force))
        p = np.zeros(n)
        p[c] = y[:-1]
        if p.min() < 0:
            contact[p < 0] = False
            continue
        e = gap - y[-1] * cosine + a @ p
        e[c] = 0
        if e.min() >= -1e-13 * np.abs(a @ p).max():
            return p, y[-1]
        contact[np.argmin(e)] = True
    raise RuntimeError("NORM did not end")


def newton(b, drive, bound, contact, slips, p):
    """For given sets: S = 0 where it sticks; |p| = bound and p parallel to S where it slips. p is [x of all, s of all]."""
    n, m = len(bound), len(contact)
    index = np.concatenate([contact, n + contact])
    slip = slips[contact]
    matrix, scale, slip_scale = b[np.ix_(index, index)], bound.max(), np.abs(drive).max()
    g = bound[contact] / scale
    for _ in range(60):
        t = p[index] / scale
        w = (drive[index] - matrix @ p[index]) / slip_scale
        px, ps, wx, ws = t[:m], t[m:], w[:m], w[m:]
        f = np.concatenate([np.where(slip, px**2 + ps**2 - g**2, wx), np.where(slip, px * ws - ps * wx, ws)])
        if np.abs(f).max() < 1e-12:
            return True
        d = -matrix * scale / slip_scale
        j = np.zeros((2 * m, 2 * m))
        stick = np.flatnonzero(~slip)
        j[stick], j[m + stick] = d[stick], d[m + stick]
        k = np.flatnonzero(slip)
        j[k, k], j[k, m + k] = 2 * px[k], 2 * ps[k]
        j[m + k] = px[k, None] * d[m + k] - ps[k, None] * d[k]
        j[m + k, k] += ws[k]
        j[m + k, m + k] -= wx[k]
        step = np.linalg.solve(j, -f)
        p[index] += scale * step
        if np.linalg.norm(step) < 1e-13 * np.sqrt(2 * m):
            return True
    return False


def tang(b, drive, bound):
    """Adhesion everywhere at first; what exceeds its bound slips; what would slip against its traction sticks again."""
    n = len(bound)
    p, slips, contact = np.zeros(2 * n), np.zeros(n, bool), np.flatnonzero(bound > 0)
    for _ in range(200):
        length = np.hypot(p[:n], p[n:])
        for i in np.flatnonzero(slips & (length > 0)):
            p[[i, n + i]] *= bound[i] / length[i]
        if not newton(b, drive, bound, contact, slips, p):
            raise RuntimeError("TANG: Newton's method did not end")
        w = drive - b @ p
        wrong = np.zeros(n, bool)
        wrong[contact] = ~slips[contact] & (np.hypot(p[contact], p[n + contact]) > bound[contact] * (1 + 1e-12))
        if wrong.any():
            slips |= wrong
            continue
        wrong[contact] = slips[contact] & (p[contact] * w[contact] + p[n + contact] * w[n + contact] < 0)
        if not wrong.any():
            return p
        slips &= ~wrong
    raise RuntimeError("TANG did not end")


def solve(numbers, mx, dx, gap, delta, force, friction, slip):
    """Steady rolling. gap, slip (2) by element, delta by element; force per element's area. Returns p_n, p_x, p_s, approach."""
    n = len(gap)
    a, b = full_matrix(numbers, mx), steady_matrix(numbers, mx)
    tt = np.block([[b[X, X], b[X, S]], [b[S, X], b[S, S]]])
    tn = np.vstack([b[X, N], b[S, N]])
    nt = np.hstack([a[N, X], a[N, S]])
    pt, pn, contact = np.zeros(2 * n), np.zeros(n), np.ones(n, bool)
    for _ in range(200):
        before = np.concatenate([pn, pt])
        pn, approach = norm(a[N, N], gap + nt @ pt, np.cos(delta), force - np.sin(delta) @ pt[n:], contact)
        pt = tang(tt, dx * slip - tn @ pn, friction * pn)
        if np.abs(np.concatenate([pn, pt]) - before).max() <= 1e-11 * pn.max():
            return pn, pt[:n], pt[n:], approach
    raise RuntimeError("NORM and TANG did not settle")
