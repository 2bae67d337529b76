"""Stresses inside a body while a contact passes: the section, beside it that of a half-space, and both over the depth."""

import h5py
import numpy as np
from matplotlib.ticker import MaxNLocator

from . import style
from .kinds import text
from .refusals import refuse

LEVELS = 14
HALFSPACE = "in a half-space"


def places_of(section, shape):
    """Where the points are: in the frame of the body's profile if it is known, else arc length and depth."""
    if "y" in section:
        return section["y"][:].reshape(shape), section["z"][:].reshape(shape), "y, mm", "z down, mm"
    s, depth = np.meshgrid(section["s"][:], section["depth"][:], indexing="ij")
    return s, depth, "s along the surface, mm", "depth, mm"


def draw_section(axis, places, stress, levels, name):
    across, down, xlabel, ylabel = places
    image = axis.contourf(across, down, np.ma.masked_invalid(stress), levels=levels, cmap=style.STRESS)
    there = np.isfinite(stress[:, 0])
    axis.plot(across[there, 0], down[there, 0], color=style.RAIL, linewidth=2.5)
    at = np.unravel_index(np.nanargmax(stress), stress.shape)
    axis.plot(across[at], down[at], "+", color=style.ADHESION, markersize=13, markeredgewidth=2, label=f"largest: {stress[at]:.0f} MPa")
    axis.set(title=f"Von Mises stress {name}", xlabel=xlabel, ylabel=ylabel, aspect="equal")
    style.down(axis)
    axis.legend(loc="lower right")
    return image, at


def draw(files):
    with h5py.File(files[0]) as file:
        name = text(file.attrs.get("body", b"")) or text(file.attrs["side"])
        section = file["sections/1"]
        stress = section["von_mises"][:]
        if stress.ndim != 2:
            refuse(f"'{files[0]}' cannot be drawn", "it has stresses at points of your own, and no section", "Leave out --points.")
        has_body = "halfspace_von_mises" in section
        shown = [(stress, f"in {name}" if has_body else HALFSPACE)]
        if has_body:
            shown.append((section["halfspace_von_mises"][:], HALFSPACE))
        places, depth = places_of(section, stress.shape), section["depth"][:]
        figure, (axes,) = style.panels(1, len(shown) + 1, (5 * len(shown) + 4.5, 4.4))
        levels = MaxNLocator(LEVELS).tick_values(0, max(np.nanmax(values) for values, _ in shown))
        over = axes[-1]
        for axis, (values, title), dash in zip(axes, shown, ("-", "--")):
            image, at = draw_section(axis, places, values, levels, title)
            over.plot(values[at[0]], depth, dash, color=style.INK, label=f"{title}, below s = {section['s'][at[0]]:.2f} mm")
        figure.colorbar(image, ax=list(axes[:-1]), label="largest while the load passes, MPa", shrink=0.8)
        over.set(title="Over the depth", xlabel="von Mises stress, MPa", ylabel="depth, mm", xlim=(0, None))
        style.down(over)
        style.legend_beside(over, below=True, columns=1)
        return figure
