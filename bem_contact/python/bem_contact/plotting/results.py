"""A result, a comparison of models, both wheels of a wheelset."""

import h5py
import numpy as np

from . import style
from .contact import SETS, Contact, contacts_in, draw_cut, draw_history, draw_patch, draw_section, draw_stresses, patch_key, set_of
from .kinds import text
from .shared import VIEWS

PER_MILLE = ("free_rolling_xi",)
SHARES = ("MPa", "mm2")  # differences of pressures and areas are relative
ROUNDING = 1e-6  # in the unit of a line: less is not shown
INCOMPARABLE = ("approach",)  # of each model relative to another place
PATCH_WIDTH, PATCH_HEIGHTS = 4.0, (1.3, 4.0)  # inches
SIDES = ("left", "right")


def with_error(value, error):
    """ "1859 ± 4": as many digits as the error has meaning."""
    if not np.isfinite(value):
        return "–"
    digits = digits_of(error)
    if digits is None:
        return f"{0.0 if abs(value) < ROUNDING else value:.6g}"
    return f"{round(value, digits) + 0.0:.{digits}f} ± {error:.{digits}f}"


def digits_of(error):
    """How many digits behind the point have meaning; None: nothing is known of the error, or it is that of rounding."""
    return min(6, max(0, int(np.ceil(-np.log10(error) + 0.3)))) if np.isfinite(error) and error > ROUNDING else None


def write_table(axis, title, head, lines, height=0.085):
    axis.axis("off")
    axis.set_title(title)
    width = 0.72 / max(1, len(head))
    for i, row in enumerate([["", *head], *lines]):
        for k, cell in enumerate(row):
            axis.text(0 if k == 0 else 1 - width * (len(head) - k), 0.97 - height * i, cell, transform=axis.transAxes, va="top",
                      ha="left" if k == 0 else "right", fontsize=9.5, fontweight="bold" if i == 0 else "normal")


def numbers_of(contacts):
    """Lines of a table, those that any model knows; of two models their difference, too."""
    for name in VIEWS["result"]["picture"]:
        unit, scale = ("‰", 1e3) if name in PER_MILLE else (next((c.units[name] for c in contacts if name in c.units), ""), 1)
        values, errors = ([c.numbers.get(column, np.nan) * scale for c in contacts] for column in (name, f"{name}_error"))
        if np.isfinite(values).any():
            yield [style.titled(name, unit), *map(with_error, values, errors),
                   *([difference(name, unit, values, errors)] if len(contacts) == 2 else [])]


def difference(name, unit, values, errors):
    """The second less the first: of pressures and areas relative to the first, else in the unit of the line."""
    change, digits = values[1] - values[0], digits_of(np.fmax(*errors))
    if name in INCOMPARABLE or not np.isfinite(change):
        return "–"
    if unit in SHARES and values[0]:
        return f"{100 * change / values[0]:+.2f} %"
    if digits is not None:
        change = round(change, digits)
        return f"{change:+.{digits}f}" if change else "0"
    return f"{change:+.3g}" if abs(change) > ROUNDING * max(1, abs(values[0])) else "0"


def draw_patches(figure, axes, contacts, titles):
    """Patches on one scale, with one colour bar."""
    pmax = max(c.pressure.max() for c in contacts) or 1.0
    shear = max(c.shear.max() for c in contacts)
    for axis, contact, title in zip(axes, contacts, titles):
        image = draw_patch(axis, contact, pmax, shear, title)
        axis.set(xlim=contact.window()[0], ylim=contact.window()[1])
        axis.set_xlabel(style.ACROSS)
    figure.colorbar(image, ax=axes, label="pressure, MPa", shrink=0.8, pad=0.02, aspect=30)


def one_window(axes, contacts):
    """The same limits for all, to compare."""
    limits = np.array([c.window() for c in contacts])
    for axis in axes:
        axis.set(xlim=(limits[:, 0, 0].min(), limits[:, 0, 1].max()), ylim=(limits[:, 1, 0].min(), limits[:, 1, 1].max()))


def draw_result(files):
    with h5py.File(files[0]) as file:
        contact = Contact(file)
        stresses = contact.group.get("stresses")
        figure, axes = style.panels(2, 2, (12, 8.6), width_ratios=(1.35, 1), height_ratios=(1.5, 1))
        draw_patches(figure, axes[:1, 0], [contact], [style.MODELS[contact.model][0]])
        patch_key(axes[0, 0], [contact], columns=1)
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


def cut_through_peak(contact):
    """Pressure along s through its largest value."""
    return contact.pressure[:, contact.peak()[1]]


def draw_pressures(pressures, differences, contacts):
    """Pressure along s by each model; below it what the first has more than each of the others."""
    first, *others = contacts
    for k, c in enumerate(contacts):
        pressures.plot(c.s, cut_through_peak(c), color=style.DEEPEST_PRESSURE, linestyle=style.MODELS[c.model][2], linewidth=2.6 - 0.6 * k,
                       label=style.MODELS[c.model][1])
    for c in others:
        differences.plot(first.s, cut_through_peak(first) - np.interp(first.s, c.s, cut_through_peak(c)), color=style.INK, linewidth=1.3,
                         linestyle=style.MODELS[c.model][2], label=f"{style.MODELS[first.model][1]} less {style.MODELS[c.model][1]}")
    windows = [c.window()[1] for c in contacts]
    pressures.set(title="Pressure through its largest value", ylabel="pressure, MPa", xlim=(min(w[0] for w in windows), max(w[1] for w in windows)))
    pressures.legend(fontsize=8.5)
    pressures.tick_params(labelbottom=False)
    differences.axhline(0, color=style.FRAME, linewidth=0.8, zorder=0)
    differences.set(xlabel=style.UP, ylabel="difference, MPa")
    differences.legend(fontsize=8.5)


def patch_height(contacts):
    """Of a panel, inches: patches are drawn in their proportions."""
    x, s = (np.ptp([c.window()[k] for c in contacts]) for k in (0, 1))
    return np.clip(PATCH_WIDTH * s / x, *PATCH_HEIGHTS) + 0.9  # with title and labels


def draw_comparison(files):
    with h5py.File(files[0]) as file:
        name = set_of(file)
        contacts = contacts_in(file[name])
        lines = list(numbers_of(contacts[::-1]))  # the simplest model first, as the program prints
        rows = -(-len(contacts) // 2)
        heights = (rows * patch_height(contacts), 0.3, 3.6, 0.5 + 0.27 * len(lines))
        figure = style.figure((10, sum(heights)))
        patches, key, details, table = figure.add_gridspec(4, 1, height_ratios=heights)
        panels = patches.subgridspec(rows, 2)
        axes = [figure.add_subplot(panels[k // 2, k % 2]) for k in range(len(contacts))]
        draw_patches(figure, axes, contacts, [style.MODELS[c.model][0] for c in contacts])
        one_window(axes, contacts)
        below = figure.add_subplot(key)
        below.axis("off")
        patch_key(below, contacts, below=False)
        section, pressures = details.subgridspec(1, 2)
        draw_section(figure.add_subplot(section), contacts)
        upper, lower = pressures.subgridspec(2, 1, height_ratios=(1.6, 1))
        axis = figure.add_subplot(upper)
        draw_pressures(axis, figure.add_subplot(lower, sharex=axis), contacts)
        head = [style.MODELS[c.model][1] for c in contacts[::-1]]
        head += [" less ".join(head[::-1])] * (len(contacts) == 2)
        write_table(figure.add_subplot(table), SETS[name], head, lines, 0.95 / (len(lines) + 1))
        return figure


def in_table(value, unit):
    """A number whose unit stands in front; an angle also in degrees."""
    return f"{value:.4g} ({np.degrees(value):.3g}°)" if unit == "rad" else f"{value:.6g}"


def lines_of(view, groups):
    """The numbers of a view that any of these groups knows."""
    for name in VIEWS[view]["picture"]:
        numbers = [group[name] for group in groups if name in group]
        if np.isfinite([number[()] for number in numbers]).any():
            unit = text(numbers[0].attrs["unit"])
            yield [style.titled(name, unit), *(in_table(number[()], unit) for number in numbers)]


def draw_wheelset(files):
    """The left wheel on the left: both patches in the frame of their side, and a table in the track frame."""
    with h5py.File(files[0]) as file:
        contacts = [Contact(file[side]["result"]) for side in SIDES]
        figure, axes = style.panels(3, 2, (12.5, 13), height_ratios=(1, 1.1, 0.6))
        draw_patches(figure, axes[0], contacts, [f"{side.capitalize()} wheel" for side in SIDES])
        patch_key(axes[0, 0], contacts, columns=1)
        for axis, contact in zip(axes[1], contacts):
            draw_section(axis, [contact])
        axes[1, 0].invert_xaxis()  # y to the left: the field side is on the left
        write_table(axes[2, 0], "Each wheel, y to the right", SIDES,
                    lines_of("wheel of a wheelset", [file[side]["track"] for side in SIDES]), 0.11)
        write_table(axes[2, 1], "The wheelset", ["value"], lines_of("wheelset", [file["wheelset"]]), 0.11)
        return figure
