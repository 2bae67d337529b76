"""One contact: the patch from above, cuts with the bound of friction, the section, stresses below."""

import numpy as np
from matplotlib.collections import LineCollection
from matplotlib.lines import Line2D

from . import style
from .kinds import number, text

ADHERES = 1
MOST_ROWS, MOST_COLUMNS = 8, 12  # of arrows
MOST_SLENDER = 15  # length over width of a patch that is drawn in its proportions
SETS = {"at_equal_forces": "At equal forces", "at_equal_position": "At equal position and vertical force"}


class Contact:
    """Coordinates, fields and numbers of one result, which is a group of a file."""

    def __init__(self, group):
        self.model, self.group = text(group.attrs["model"]), group
        self.x, self.s, self.y, self.z = (group[c][:] for c in "xsyz")
        self.dx, self.ds = (number(group["quantities"], name) for name in ("dx", "ds"))
        self.friction = number(group, "friction")
        self.left = text(group.attrs["side"]) == "left"
        self.rail, self.wheel = group["rail_profile"][:], group["wheel_profile"][:]
        self.state, self.pressure, self.px, self.ps = (group[name][:] for name in ("state", "p_n", "p_x", "p_s"))
        self.numbers = {name: float(data[()]) for name, data in group["quantities"].items()}
        self.units = {name: text(data.attrs["unit"]) for name, data in group["quantities"].items()}

    def verdict(self):
        """Whether it is certified, and its worst violation."""
        worst, tolerance = number(self.group["quantities"], "certificate"), number(self.group["certificate"], "tolerance")
        return f"{'certified' if self.group.attrs['certified'] else 'NOT certified'}: {worst:.0e}, at most {tolerance:.0e}"

    @property
    def shear(self):
        """Size of the shear traction."""
        return np.hypot(self.px, self.ps)

    def peak(self):
        return np.unravel_index(self.pressure.argmax(), self.pressure.shape)

    @property
    def slender(self):
        """Whether it is too long to be drawn in its proportions, as a cylinder's contact is. Arrows would be distorted."""
        sizes = [np.ptp(limits) for limits in self.window()]
        return max(sizes) > MOST_SLENDER * min(sizes)

    def window(self, margin=3):
        """What lies around the contact: limits of x and of s."""
        limits = []
        for middles, width, touched in ((self.x, self.dx, self.state.any(axis=0)), (self.s, self.ds, self.state.any(axis=1))):
            at = np.where(touched)[0] if touched.any() else np.array([0, len(middles) - 1])
            limits.append((middles[at[0]] - margin * width, middles[at[-1]] + margin * width))
        return limits


def contacts_in(group):
    """The results of a group, the most exact model first."""
    return [Contact(group[name]) for name in style.MODELS.those_of([name for name in group if "p_n" in group[name]])]


def set_of(comparison):
    """The name of the results of a comparison: at equal forces or at equal position."""
    return next(name for name in SETS if name in comparison)


def edges(middle, width):
    return np.append(middle - width / 2, middle[-1] + width / 2)


def outline(axis, contact, inside, **look):
    """The border of a set of elements, along their edges."""
    padded = np.pad(inside, 1)
    x, s = edges(contact.x, contact.dx), edges(contact.s, contact.ds)
    lines = [[(x[j], s[i]), (x[j + 1], s[i])] for i, j in zip(*np.where(padded[1:, 1:-1] != padded[:-1, 1:-1]))]
    lines += [[(x[j], s[i]), (x[j], s[i + 1])] for i, j in zip(*np.where(padded[1:-1, 1:] != padded[1:-1, :-1]))]
    axis.add_collection(LineCollection(lines, capstyle="round", **look))


def arrows(axis, contact, longest):
    """Shear tractions on some elements, dark with a light border, so that they are seen on every pressure."""
    touched = contact.state > 0
    size = [np.any(touched, axis=k).sum() * width for k, width in ((1, contact.ds), (0, contact.dx))]
    apart = max(size[0] / MOST_ROWS, size[1] / MOST_COLUMNS)  # mm, the same along x and s
    rows, columns = (max(1, round(apart / width)) for width in (contact.ds, contact.dx))
    shown = np.zeros_like(touched)
    shown[rows // 2::rows, columns // 2::columns] = True
    i, j = np.where(shown & touched)
    look = {"angles": "xy", "scale_units": "xy", "scale": longest / (0.9 * apart), "pivot": "mid", "units": "dots", "headwidth": 4.5,
            "headlength": 5, "headaxislength": 4.5, "minlength": 0.4}
    tractions = (contact.x[j], contact.s[i], contact.px[i, j], contact.ps[i, j])
    axis.quiver(*tractions, color="white", edgecolor="white", linewidth=2.4, width=2.0, zorder=3, **look)
    axis.quiver(*tractions, color=style.INK, width=2.0, zorder=4, **look)


def draw_patch(axis, contact, pmax, shear, title):
    """Pressure, adhesion and slip, shear tractions. Returns what a colour bar needs."""
    touched = contact.state > 0
    image = axis.pcolormesh(edges(contact.x, contact.dx), edges(contact.s, contact.ds),
                            np.ma.masked_where(~touched, contact.pressure), cmap=style.PRESSURE, vmin=0, vmax=pmax, rasterized=True)
    outline(axis, contact, touched, color=style.INK, linewidth=1.4)
    if shear > 0:
        outline(axis, contact, contact.state == ADHERES, color=style.ADHESION, linewidth=2.6, zorder=2.5)
        if not contact.slender:
            arrows(axis, contact, shear)
    axis.set_title(title, pad=18)
    axis.annotate(contact.verdict(), (0, 1),
                  xycoords="axes fraction", xytext=(0, 5), textcoords="offset points", fontsize=9)
    axis.set(aspect="auto" if contact.slender else "equal", facecolor=style.OUTSIDE, ylabel=style.UP)
    axis.grid(False)
    return image


def patch_key(axis, contacts, columns=3, below=True):
    """What the lines and arrows of patches mean: below a panel, or in one of its own."""
    shear = max(c.shear.max() for c in contacts)
    handles = [Line2D([], [], color=style.INK, linewidth=1.4, label="border of the contact"),
               Line2D([], [], color=style.ADHESION, linewidth=2.6, label="adhesion within, slip around"),
               Line2D([], [], color=style.INK, marker=">", markersize=13, linestyle="none",
                      label=f"shear traction on the rail, longest {shear:.0f} MPa")][:2 if all(c.slender for c in contacts) else 3]
    look = {"handles": handles, "fontsize": 8.5, "handlelength": 1.6}
    if shear > 0 and below:
        style.legend_beside(axis, below=True, columns=columns, **look)
    elif shear > 0:
        axis.legend(loc="center", ncol=columns, **look)


def draw_cut(axis, contact, along="x"):
    """Traction and friction bound along x or s, through the largest pressure."""
    row, column = contact.peak()
    cut = (row, slice(None)) if along == "x" else (slice(None), column)
    at = contact.x if along == "x" else contact.s
    if contact.friction > 0 and contact.shear.max() > 0:
        bound = contact.friction * contact.pressure[cut]
        axis.fill_between(at, bound, color=style.BOUND, alpha=0.18, linewidth=0)
        axis.plot(at, bound, color=style.BOUND, linestyle=(0, (2, 2)), label=f"friction bound {contact.friction:g} p")
        axis.plot(at, contact.shear[cut], color=style.INK, linewidth=1.3, label="shear traction")
        axis.plot(at, contact.px[cut], color=style.ALONG_X, linestyle="--", label="along x")
        axis.plot(at, contact.ps[cut], color=style.ALONG_S, linestyle="-.", label="along s")
        axis.set_ylabel("traction on the rail, MPa")
        style.legend_beside(axis)
    else:
        axis.plot(at, contact.pressure[cut], color=style.DEEPEST_PRESSURE)
        axis.set_ylabel("pressure, MPa")
    window = contact.window()
    if along == "x":
        axis.set(xlabel=f"{style.ACROSS} (cut at s = {contact.s[row]:.2f} mm)", xlim=window[0])
    else:
        axis.set(xlabel=f"{style.UP} (cut at x = {contact.x[column]:.2f} mm)", xlim=window[1])


def draw_history(axis, group):
    """Forces on the rail by load step."""
    for name in ("Fx", "Fy", "Fz"):
        axis.plot(np.arange(len(group[name])) + 1, group[name][:], **style.line(style.FORCES[name], markersize=3), label=name)
    axis.set(title="Forces on the rail", xlabel="load step", ylabel="N")
    style.whole_numbers(axis.xaxis)
    axis.legend()


def draw_section(axis, contacts):
    """Both profiles at the contact, looking along the track; a band for each contact in its model's line."""
    first = contacts[0]
    axis.plot(*first.rail.T, color=style.RAIL, linewidth=2, label="rail")
    axis.plot(*first.wheel.T, color=style.WHEEL, linewidth=2, linestyle="--", label="wheel, undeformed, just touching")
    for k, c in enumerate(contacts):
        touched = (c.state > 0).any(axis=1)
        shift = 0.35 * (k + 1)  # mm into the rail, so that no line hides another
        delta = np.gradient(c.z, c.s), np.gradient(c.y, c.s)
        alone = touched & ~np.append(touched[1:], False) & ~np.append(False, touched[:-1])
        y, z = c.y - shift * delta[0], c.z + shift * delta[1]
        axis.plot(y[alone], z[alone], ".", color=style.DEEPEST_PRESSURE)  # a patch of one row
        axis.plot(np.where(touched, y, np.nan), np.where(touched, z, np.nan), color=style.DEEPEST_PRESSURE,
                  linestyle=style.MODELS[c.model][2], linewidth=3,
                  label=f"contact, {style.MODELS[c.model][1]}")
    half = max(np.ptp(first.y), np.ptp(first.z)) * 0.5 + 4
    side = "left" if first.left else "right"
    axis.locator_params(nbins=6)
    axis.set(xlim=(first.y.mean() - half, first.y.mean() + half), ylim=(first.z.mean() + half, first.z.mean() - half),
             aspect="equal", adjustable="datalim", xlabel=f"y to the {side}, mm; contact is drawn inside the rail", ylabel="z down, mm", title="Section across the track")
    axis.set_autoscale_on(True)  # one pair of limits gives way to the equal scales; matplotlib 3.10 remarks that of fixed ones
    axis.legend(loc="best", fontsize=8.5)


def draw_stresses(axis, group):
    """The von Mises stress below the surface: over depth, or as a section where the scene asks for many places. Of the real rail (or wheel)
    where the scene asks for it, over depth beside that of a half-space."""
    body = group.get("rail", group.get("wheel"))
    x, depths = group["x"][:], group["depths"][:]
    s, stress = ((body or group)[name][:] for name in ("s", "von_mises"))
    at = np.unravel_index(np.nanargmax(stress), stress.shape)
    name = f"largest: {stress[at]:.0f} MPa, {depths[at[2]]:.2f} mm deep"
    if len(s) > 1 or len(x) > 1:
        over, values, label = (s, stress[at[0]], style.UP) if len(s) > 1 else (x, stress[:, at[1]], style.ACROSS)
        image = axis.contourf(over, depths, values.T, levels=12, cmap=style.STRESS)
        axis.plot(over[at[1] if len(s) > 1 else at[0]], depths[at[2]], "+", color=style.INK, markersize=12, label=name)
        axis.figure.colorbar(image, ax=axis, label="von Mises, MPa")
        axis.set(xlabel=label, ylabel="depth, mm")
    else:
        axis.plot(stress[0, 0], depths, "-o", color=style.INK, label="von Mises")
        if body:
            axis.plot(body["halfspace_von_mises"][0, 0], depths, "--", color=style.INK, label="of a half-space")
        axis.plot(stress[at], depths[at[2]], "+", color=style.INK, markersize=14, label=name)
        axis.set(xlabel=f"MPa, below x = {x[0]:.2f}, s = {s[0]:.2f} mm", ylabel="depth, mm")
    axis.set_title(f"Stress below the surface, in {text(body.attrs['body'])}" if body else "Stress below the surface")
    style.down(axis)
    axis.legend(loc="lower right")
