"""Sections of a rail or wheel from above and from the side: which points of them correspond."""

import numpy as np

from . import style
from .kinds import kind_of
from .profiles import table_of

COLUMNS = ("body", "t", "line", "section", "u", "y", "z")


def draw_net(axis, p, height):
    """Lines of corresponding points, and across them the sections."""
    for body in np.unique(p["body"]):
        own = p["body"] == body
        for t in np.unique(p["t"][own]):
            at = own & (p["t"] == t)
            line = p["line"][at].any()
            gaps = np.where(np.diff(p["u"][at]) > 4.5 * np.median(np.diff(p["u"][at])), np.nan, 0) if at.sum() > 2 else np.zeros(at.sum() - 1)
            axis.plot(p["u"][at], height[at] + np.append(gaps, 0), color=style.ADHESION if line else style.RAIL, linewidth=1.8 if line else 0.5)
        for u in np.unique(p["u"][own & (p["section"] > 0)]):
            at = own & (p["u"] == u)
            order = np.argsort(p["t"][at])
            axis.plot(p["u"][at][order], height[at][order], color=style.INK, linewidth=0.8)


def draw(files):
    rows = table_of(files[0], ()) if kind_of(files[0]) == "sections" else np.loadtxt(files[0], delimiter=",", skiprows=1, unpack=True)
    p = dict(zip(COLUMNS, rows))
    figure, axes = style.panels(2, 1, (14, 9), sharex=True)
    above, side = axes[:, 0]
    draw_net(above, p, p["y"])
    draw_net(side, p, p["z"])
    for axis in (above, side):
        axis.invert_yaxis()  # y to the right of who looks ahead, z down
    above.set(title="From above: sections (dark), lines along which they are joined (orange), what corresponds between these", ylabel="y, mm")
    side.set(title="From the side", ylabel="z, mm", xlabel="along the track, mm (a wheel: angle, rad)")
    return figure
