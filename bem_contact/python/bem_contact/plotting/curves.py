"""Creep curves and fits: each force over each creepage, with the bound of friction and the slopes of linear theory."""

import h5py
import numpy as np

from . import style
from .kinds import number, require_columns, text

AXES = {"xi": "longitudinal creepage xi", "eta": "lateral creepage eta", "phi": "spin phi, 1/mm"}
EXPLAINED = ("Each panel changes one creepage, and the other two stay as in the scene. With little creepage the force grows along Kalker's\n"
             "straight line, if the other two are zero; with much of it the whole contact slips, and the force stays within the bound of friction.")
LABELS = {"Fx": "Fx / (μ Fn)", "Fs": "Fs / (μ Fn)", "Mz": "Mz / (μ Fn c)"}


def draw_curve(panel, name, curve, scales, kalker):
    creepage, sure = curve["creepage"][:], curve["certified"][:] > 0
    for row, (force, label) in enumerate(LABELS.items()):
        colour, dash, _ = style.FORCES[force]
        values = curve[force][:] / scales[force]
        panel.plot(creepage[sure], values[sure], dash, color=colour, label=label)
        if not sure.all():
            panel.plot(creepage[~sure], values[~sure], "x", color=colour, label=f"{force}, not certified")
        slope = kalker[row, list(AXES).index(name)] / scales[force] if kalker is not None else 0
        if slope:
            reach = min(0.6 / abs(slope), np.abs(creepage).max())
            panel.plot([-reach, reach], [-reach * slope, reach * slope], color=colour, linewidth=0.8,
                       label="thin lines: Kalker's linear theory" if row == (name != "xi") else None)
    style.limit(panel, 1, "bound of friction")
    panel.axhline(-1, color=style.BOUND, linestyle=(0, (2, 2)), linewidth=1.5, zorder=1)
    panel.set(xlabel=AXES[name], ylim=(-1.3, 1.3), xlim=(creepage.min(), creepage.max()))
    panel.ticklabel_format(axis="x", scilimits=(-2, 2))


def draw_measured(panel, measured, scales, band=None):
    force, points = text(measured.attrs["force"]), measured["points"]
    if band is not None:
        panel.fill_between(band["creepage"][:], band["low"][:] / scales[force], band["high"][:] / scales[force], color=style.FORCES[force][0],
                           alpha=0.2, linewidth=0, label=f"95 % of what the points allow of {force}")
    scatter = points["scatter"][:] / scales[force] if "scatter" in points else None
    panel.errorbar(points["creepage"][:], points["measured"][:] / scales[force], scatter, fmt="s", color=style.INK, fillstyle="none",
                   capsize=3, markersize=5, label=f"{force} as measured")


def draw_pressures(panel, line):
    over, points = text(line.attrs["over"]), line["points"]
    order = np.argsort(points[over][:])
    panel.plot(points[over][:][order], points["computed"][:][order], "o-", color=style.FORCES["Fx"][0], markersize=3, label="as computed")
    panel.errorbar(points[over][:], points["measured"][:], points["scatter"][:] if "scatter" in points else None, fmt="s", color=style.INK,
                   fillstyle="none", capsize=3, markersize=5, label="as measured")
    panel.set(xlabel=f"{over}, mm", ylabel="pressure, MPa")
    panel.legend()


def draw_fit_of_pressures(file):
    names = [name for name in file if name.split("_")[0] == "pressures"]
    figure, axes = style.panels(1, len(names), (1.2 + 4.4 * len(names), 4.6))
    for panel, name in zip(axes[0], names):
        draw_pressures(panel, file[name])
    figure.suptitle(f"Fit to measured pressures: vertical force {number(file, 'Fz'):.6g} N", fontsize=10.5)
    return figure


def draw(files):
    with h5py.File(files[0]) as file:
        if "curves" not in file:
            return draw_fit_of_pressures(file)
        curves = file["curves"]
        force, bound, radius = (number(file, name) for name in ("Fz", "bound", "radius"))
        names = [name for name in AXES if name in curves]
        figure, axes = style.panels(1, len(names), (1.2 + 4.4 * len(names), 5.2), sharey=True)
        for panel, name in zip(axes[0], names):
            require_columns(curves[name])
            scales = {"Fx": bound, "Fs": bound, "Mz": bound * radius}
            draw_curve(panel, name, curves[name], scales, file["kalker"][:] if "kalker" in file else None)
            if "measured" in file and text(file["measured"].attrs["creepage"]) == name:
                draw_measured(panel, file["measured"], scales, file.get("band"))
        axes[0, 0].set_ylabel("force on the rail over its bound")
        middle = axes[0, len(names) // 2]
        style.legend_beside(middle, below=True, columns=5 if len(names) > 1 else 2)
        what = "Fit to measured forces" if "parameters" in file else "Creep curves"
        figure.suptitle(f"{what}: vertical force {force:.6g} N, bound of friction μ Fn = {bound:.6g} N, "
                        f"mean radius of the contact c = {radius:.3g} mm\n" + EXPLAINED, fontsize=10.5)
        return figure
