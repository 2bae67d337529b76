"""A result, a comparison of models, both wheels of a wheelset."""

import h5py
import numpy as np

from . import style
from .contact import Contact, draw_cut, draw_history, draw_patch, draw_section, draw_stresses, patch_key
from .kinds import text

SETS = {"equal_forces": "At equal forces", "equal_position": "At equal position and vertical force"}
NUMBERS = (("pmax", "MPa", 1), ("area", "mm²", 1), ("Fx", "N", 1), ("Fy", "N", 1), ("Fz", "N", 1), ("Mz", "N mm", 1), ("approach", "mm", 1),
           ("lateral", "mm", 1), ("free_rolling_xi", "‰", 1e3), ("Tmax_rail", "°C", 1), ("Tmax_wheel", "°C", 1))  # scale last
SIDES = ("left", "right")
OF_WHEELSET = ("lateral", "roll", "yaw", "rolling_radius", "Fx", "Fy", "Fz", "roll_moment", "yaw_moment", "torque")
ON_TRACK = (("share", "1"), ("Fx", "N"), ("Fy", "N"), ("Fz", "N"), ("Y_over_Q", "1"), ("radius", "mm"), ("delta", "rad"), ("pmax", "MPa"),
            ("area", "mm²"))


def with_error(value, error):
    """ "1859 ± 4": as many digits as the error has meaning."""
    if not np.isfinite(value):
        return "–"
    if not (np.isfinite(error) and error > 0):
        return f"{0.0 if abs(value) < 1e-6 else value:.6g}"
    if abs(value) < 1e-6:
        value = 0.0
    digits = min(6, max(0, int(np.ceil(-np.log10(error) + 0.3))))
    return f"{value:.{digits}f} ± {error:.{digits}f}"


def write_table(axis, title, head, lines, height=0.085):
    axis.axis("off")
    axis.set_title(title)
    width = 0.72 / max(1, len(head))
    for i, row in enumerate([["", *head], *lines]):
        for k, cell in enumerate(row):
            axis.text(0 if k == 0 else 1 - width * (len(head) - k), 0.97 - height * i, cell, transform=axis.transAxes, va="top",
                      ha="left" if k == 0 else "right", fontsize=9.5, fontweight="bold" if i == 0 else "normal")


def numbers_of(contacts):
    """Lines of a table, those that any model knows."""
    for name, unit, scale in NUMBERS:
        values = [c.numbers.get(name, np.nan) * scale for c in contacts]
        if np.isfinite(values).any():
            yield [f"{name}, {unit}", *(with_error(v, c.numbers.get(f"{name}_error", np.nan) * scale)
                                        for v, c in zip(values, contacts))]


def draw_patches(figure, axes, contacts, titles, key=-1, columns=3):
    """Patches on one scale, with one colour bar and one key."""
    pmax = max(c.pressure.max() for c in contacts) or 1.0
    shear = max(c.shear.max() for c in contacts)
    for axis, contact, title in zip(axes, contacts, titles):
        image = draw_patch(axis, contact, pmax, shear, title)
        axis.set(xlim=contact.window()[0], ylim=contact.window()[1])
    axes[-1].set_xlabel(style.ACROSS)
    figure.colorbar(image, ax=axes, label="pressure, MPa", shrink=0.8, pad=0.02, aspect=30)
    patch_key(axes[key], shear, columns, not all(c.slender for c in contacts))


def one_window(axes, contacts):
    """The same limits for all, to compare."""
    limits = np.array([c.window() for c in contacts])
    for axis in axes:
        axis.set(xlim=(limits[:, 0, 0].min(), limits[:, 0, 1].max()), ylim=(limits[:, 1, 0].min(), limits[:, 1, 1].max()))


def draw_result(files):
    with h5py.File(files[0]) as file:
        contact = next(Contact(m, file, file[m]) for m in style.MODELS if m in file)
        stresses = contact.group.get("stresses")
        figure, axes = style.panels(2, 2, (12, 8.6), width_ratios=(1.35, 1), height_ratios=(1.5, 1))
        draw_patches(figure, axes[:1, 0], [contact], [style.MODELS[contact.model][0]], columns=1)
        draw_cut(axes[1, 0], contact)
        if stresses is not None:
            draw_stresses(axes[0, 1], stresses)
        elif np.ptp(contact.rail[:, 1]) > 0.02 * np.ptp(contact.rail[:, 0]):
            draw_section(axes[0, 1], [contact])
        elif "history" in contact.group:
            draw_history(axes[0, 1], contact.group["history"])
        else:
            draw_cut(axes[0, 1], contact, "s")
        write_table(axes[1, 1], "Numbers (± size of elements)", ["value"], list(numbers_of([contact])), 0.105)
        return figure


def draw_pressures(axis, contacts):
    """Pressure along s through its largest value, by each model."""
    for k, c in enumerate(contacts):
        _, column = c.peak()
        axis.plot(c.s, c.pressure[:, column], color=style.DEEPEST_PRESSURE, linestyle=style.MODELS[c.model][2], linewidth=2.6 - 0.6 * k,
                  label=style.MODELS[c.model][1])
    axis.set(title="Pressure through its largest value", xlabel=style.UP, ylabel="MPa", xlim=contacts[0].window()[1])
    axis.legend()


def draw_comparison(files):
    with h5py.File(files[0]) as file:
        name = next(name for name in SETS if name in file)
        contacts = [Contact(m, file[name][m], file[name][m]) for m in style.MODELS if m in file[name]]
        count = len(contacts)
        figure = style.plt.figure(figsize=(14, 1.5 + 3.3 * count), layout="constrained")
        grid = figure.add_gridspec(count, 2, width_ratios=(1.1, 1))
        axes = [figure.add_subplot(grid[k, 0]) for k in range(count)]
        draw_patches(figure, axes, contacts, [style.MODELS[c.model][0] for c in contacts])
        one_window(axes, contacts)
        draw_section(figure.add_subplot(grid[0, 1]), contacts)
        rows = figure.add_subplot(grid[1, 1])
        shown = contacts[::-1]  # the simplest model first, as the program prints
        write_table(rows, SETS[name], [style.MODELS[c.model][1] for c in shown], list(numbers_of(shown)),
                    0.105)
        if count > 2:
            draw_pressures(figure.add_subplot(grid[2, 1]), contacts)
        return figure


def draw_wheelset(files):
    """The left wheel on the left: both patches in the frame of their side, and a table in the track frame."""
    with h5py.File(files[0]) as file:
        contacts = [Contact(text(file[side].attrs["model"]), file[side], file[side]) for side in SIDES]
        figure, axes = style.panels(3, 2, (12.5, 13), height_ratios=(1, 1.1, 0.6))
        draw_patches(figure, axes[0], contacts, [f"{side.capitalize()} wheel" for side in SIDES], 0, 1)
        axes[0, 0].set_xlabel(style.ACROSS)
        for axis, contact in zip(axes[1], contacts):
            draw_section(axis, [contact])
        axes[1, 0].invert_xaxis()  # y to the left: the field side is on the left
        number = {name: f"{data[()]:.6g}" for name, data in file["wheelset"].items()}
        write_table(axes[2, 0], "Each wheel, y to the right", SIDES, [
            [style.titled(name, unit), *(f"{file[side]['track'][name][()]:.6g}" for side in SIDES)]
            for name, unit in ON_TRACK], 0.11)
        write_table(axes[2, 1], "The wheelset", ["value"], [
            [style.titled(name, text(data.attrs["unit"])), number[name]] for name, data in file["wheelset"].items()
            if name in OF_WHEELSET and np.isfinite(data[()])], 0.11)
        return figure
