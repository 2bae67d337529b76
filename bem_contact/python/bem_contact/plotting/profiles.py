"""Profiles and their curvature over arc length; the first is drawn in ink, the others behind it."""

import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np

from ..program import program_file
from . import style
from .kinds import is_standard, kind_of
from .refusals import InputError, refuse

BEHIND = ((style.BOUND, "--"), (style.RAIL, "-."), (style.WHEEL, ":"))


def read(name, options, on=None):
    """Columns s, y, z, inclination, curvature; of a standard that is laid on the unworn part of the profile `on` also the depth
    worn off it."""
    if kind_of(name) == "profile table":
        return np.loadtxt(name, delimiter=",", skiprows=1, unpack=True)
    return table_of(name, ["--on", on, *options] if on else [] if is_standard(name) else options)


def table_of(name, options):
    """The columns of what `bem_contact profile --csv` writes. The program reads as a scene would; its warnings go to the terminal."""
    with tempfile.TemporaryDirectory() as folder:
        csv = Path(folder) / "profile.csv"
        program = program_file()
        if program is None:
            refuse(f"'{name}' cannot be read", "the program bem_contact was not found", "Put it on the PATH, or its folder into CONFORMAL_BIN.")
        done = subprocess.run([program, "profile", name, "--csv", csv, *options], stdout=subprocess.DEVNULL,  # its table of radii
                              stderr=subprocess.PIPE, text=True, errors="replace")
        if done.returncode != 0:
            raise InputError(done.stderr.strip().removeprefix("error: "))
        sys.stderr.write(done.stderr)
        return np.loadtxt(csv, delimiter=",", skiprows=1, unpack=True)


def draw(files, options=()):
    options = list(options)
    measured = files[0] if not is_standard(files[0]) and kind_of(files[0]) == "profile" else None
    curves = [(Path(name).name, read(name, options, measured if is_standard(name) else None)) for name in files]
    if "--smoothing" in options:
        at = options.index("--smoothing")
        curves.append(("as measured", read(files[0], options[:at] + options[at + 2:])))
    together = len(files) > 1  # arc length counts from each profile's own origin
    first = curves[0][1]
    flat = 0.3 + np.ptp(first[2]) / np.ptp(first[1])
    figure, axes = style.panels(3 if together else 2, 1, (10, 9.5 * flat + (8 if together else 4.2)),
                                height_ratios=(9.5 * flat, 4, 4)[:3 if together else 2])
    shape, bend = axes[0, 0], axes[-1, 0]
    for k, (name, (s, y, z, _, curvature, *depth)) in reversed(list(enumerate(curves))):
        colour, dash = (style.INK, "-") if k == 0 else BEHIND[(k - 1) % len(BEHIND)]
        look = {"color": colour, "linestyle": dash, "linewidth": 1.8 if k == 0 else 1.3, "label": name}
        shape.plot(y, z, **look)
        bend.plot(y if together else s, curvature, **look)
        if together and k and depth:  # along the normal: a flank may be steep
            axes[1, 0].plot(y, depth[0], label=f"{curves[0][0]}: worn off {name}", color=style.INK, linestyle=dash)
        elif together and k:
            shared = (first[1] >= y.min()) & (first[1] <= y.max())
            order = np.argsort(y)
            axes[1, 0].plot(first[1][shared], np.interp(first[1][shared], y[order], z[order]) - first[2][shared],
                            label=f"{curves[0][0]} above {name}", color=style.INK, linestyle=dash)
    shape.set(xlabel="y, mm, to the field side", ylabel="z down, mm", aspect="equal", title="Profile")
    shape.invert_yaxis()
    if together:
        worn = any(len(columns) > 5 for _, columns in curves)
        axes[1, 0].set(xlabel="y, mm", ylabel="depth, mm" if worn else "height, mm",
                       title="Depth along the normal" if worn else "Difference of height", ylim=clipped(axes[1, 0]))
        axes[1, 0].legend()
    style.legend(shape)
    largest = np.quantile(np.abs(first[4]), 0.99)
    bend.set(xlabel="y, mm" if together else "s, arc length, mm", ylabel="curvature, 1/mm", title="Curvature: above 0 convex, below concave",
             ylim=(-1.3 * largest, 1.3 * largest))
    bend.axhline(0, color=style.FRAME, linewidth=0.8, zorder=0)
    return figure


def clipped(axis):
    """Limits that leave out what a steep flank makes of a shift along y."""
    values = np.concatenate([line.get_ydata() for line in axis.get_lines()])
    values = values[np.isfinite(values)]
    low, high = np.quantile(values, (0.03, 0.97))
    room = 0.3 * (high - low) + 1e-3
    return low - room, high + room
