"""A sweep: where the patches lie, and totals over the key that varies; of wheelsets, what each wheel bears."""

import textwrap

import h5py
import numpy as np
from matplotlib.cm import ScalarMappable
from matplotlib.colors import Normalize

from . import style
from .kinds import require_columns, text
from .refusals import refuse
from .shared import VIEWS

PASSAGE = "position.along"  # the key of a sweep along the track
FILM = 6  # patches that are drawn of a passage
TITLE_WIDTH = 24  # letters of a line above one of its five panels
MARKS = ("o", "s", "D", "^", "v", "x", "+", "*")


def choices(data):
    """What its values count, from 0; None of numbers."""
    return text(data.attrs["choices"]).splitlines() if "choices" in data.attrs else None


def swept_keys(file):
    """Keys with more than one value, and the words of those that are texts."""
    keys = {}
    for name, data in file.items():
        if not isinstance(data, h5py.Dataset) or data.shape == () or data.dtype.kind not in "fiu":
            continue
        if text(data.attrs.get("role", "")) == "swept" and len(np.unique(data[:])) > 1:
            keys[name] = choices(data)
    return keys


def leading(file, keys):
    """The first key, if the others tell cases with the same value of it apart or all are of one kind; else None."""
    rest = [k for k in keys][1:]
    others = {tuple(file[k][i] for k in rest) for i in range(len(file["status"]))}
    return next(iter(keys), None) if not rest or len(others) < len(file["status"]) else None


def groups_of(file, keys, lead):
    """Cases that differ in the leading key alone, and what tells them from the others."""
    groups = {}
    for i in range(len(file["status"])):
        words = [f"{style.words(k)} "
                 + (keys[k][int(file[k][i])].split("/")[-1] if keys[k] else style.valued(file[k][i], text(file[k].attrs["unit"])))
                 for k in keys if lead and k != lead]
        groups.setdefault(", ".join(words), []).append(i)
    return groups


def draw_patches(figure, axis, patches, over):
    """Each patch as a bar as wide as the patch; larger marks carry larger forces, darker ones larger pressures."""
    p = {name: data[:] for name, data in patches.items() if name in (
        "case", "y", "Fn", "pmax", "axis_angle", "semi_axis_a", "semi_axis_b", "delta")}
    half = np.hypot(p["semi_axis_a"] * np.sin(p["axis_angle"]), p["semi_axis_b"] * np.cos(p["axis_angle"])) * np.cos(p["delta"])
    at = over[p["case"].astype(int)]
    axis.errorbar(p["y"], at, xerr=half, fmt="none", ecolor=style.RAIL, elinewidth=3, zorder=2)
    shown = axis.scatter(p["y"], at, s=15 + 120 * p["Fn"] / p["Fn"].max(), c=p["pmax"], cmap=style.PRESSURE, vmin=0,
                         edgecolor=style.INK, zorder=3)
    figure.colorbar(shown, ax=axis, label="largest pressure, MPa")
    axis.set(title="Patches on the rail: bars as wide as they are", xlabel="y, mm")


def beside(file, quantity, role):
    """The column of that role of a quantity, "right_Fy" say; None if there is none."""
    return next((name for name, data in file.items() if isinstance(data, h5py.Dataset)
                 and text(data.attrs.get("role", "")) == role and text(data.attrs.get("of", "")) == quantity), None)


def draw_totals(axis, file, names, over, groups, certified, joined):
    for k, (label, cases) in enumerate(groups.items()):
        cases = np.array(sorted(cases, key=lambda i: over[i]))
        for name in names:
            colour, dash, mark = style.look(name)
            error = beside(file, name, "error")
            if len(groups) > 1:
                mark = MARKS[k % len(MARKS)]
            words = ", ".join(word for word in (name if len(names) > 1 else "", label) if word)
            sure = cases[certified[cases]]
            axis.errorbar(over[sure], file[name][:][sure], yerr=np.nan_to_num(file[error][:][sure]) if error else None,
                          linestyle=dash if joined else "none", color=colour, marker=mark, markersize=4.5, elinewidth=1, capsize=2,
                          label=words)
    axis.set_ylabel(style.titled(names[0] if len(names) == 1 else ", ".join(names), text(file[names[0]].attrs["unit"])))
    if len(groups) * len(names) > 1 and len(groups) * len(names) <= 8:
        axis.legend()


def draw_wheels(axis, file, quantity, over, groups, certified, joined):
    """A number of the right wheel (solid) and of the left one (dashed), or one of both."""
    colour, _, mark = style.look(quantity)
    sides = {side: beside(file, quantity, side) for side in ("right", "left") if quantity not in file} or {"": quantity}
    for k, (label, cases) in enumerate(groups.items()):
        sure = np.array([i for i in sorted(cases, key=lambda i: over[i]) if certified[i]])
        for side, column in sides.items():
            dash = "--" if side == "left" else "-"
            words = ", ".join(word for word in (side, label) if word)
            axis.plot(over[sure], file[column][:][sure],
                      **style.line((colour, dash, MARKS[k % len(MARKS)] if len(groups) > 1 else mark), markersize=4.5, label=words)
                      | ({} if joined else {"linestyle": "none"}))
    unit = text(file[next(iter(sides.values()))].attrs["unit"])
    axis.set_ylabel(style.titled(quantity, unit))
    style.degrees_beside(axis, y=unit)
    if 1 < len(groups) * len(sides) <= 8:
        axis.legend()


def ellipse_of(p, k, at):
    """The outline of a patch as it is seen from above: x along the track, y across it."""
    turn = np.linspace(0, 2 * np.pi, 37)
    a, b, c, s = p["semi_axis_a"][k] * np.cos(turn), p["semi_axis_b"][k] * np.sin(turn), np.cos(p["axis_angle"][k]), np.sin(p["axis_angle"][k])
    return at + p["x"][k] + a * c - b * s, p["y"][k] + np.cos(p["delta"][k]) * (a * s + b * c)


def draw_from_above(figure, axis, p, places):
    """Each patch as the ellipse that it is, where it lies along the track."""
    largest = p["pmax"].max()
    for k, case in enumerate(p["case"].astype(int)):
        axis.fill(*ellipse_of(p, k, places[case]), facecolor=style.PRESSURE(p["pmax"][k] / largest), edgecolor=style.INK, linewidth=0.5)
    figure.colorbar(ScalarMappable(Normalize(0, largest), style.PRESSURE), ax=axis, label="largest pressure, MPa")
    axis.invert_yaxis()  # y to the right of who looks ahead
    axis.set(title="From above: the patches", ylabel="y, mm")


def draw_from_the_side(axis, file, p, places, certified):
    """How the wheel's centre goes, and where it stands on the rail."""
    sure = np.flatnonzero(certified)
    sure = sure[np.argsort(places[sure])]
    height = file["vertical"][:][sure]
    axis.plot(places[sure], height - height.min(), color=style.WHEEL, marker="o", markersize=3.5, label="wheel's centre, below its highest place")
    axis.scatter(places[p["case"].astype(int)] + p["x"], p["z"], s=8 + 40 * p["Fn"] / p["Fn"].max(), marker="D", color=style.RAIL,
                 label="places of contact, larger with the force", zorder=3)
    axis.invert_yaxis()  # z points down
    axis.set(title="From the side", xlabel="along the track, mm", ylabel="z, mm, down")
    axis.legend()


def draw_film(axes, file, places, certified):
    """Pressures of places along the track, one scale for all."""
    kept = [i for i in np.flatnonzero(certified) if f"cases/{i:06d}/p_n" in file]
    kept = [kept[i] for i in np.unique(np.linspace(0, len(kept) - 1, len(axes)).astype(int))] if kept else []
    fields = [file[f"cases/{i:06d}/p_n"][:] for i in kept]
    for axis, i, field in zip(axes, kept, fields):
        case = file[f"cases/{i:06d}"]
        x, s = case["x"][:], case["s"][:]
        axis.pcolormesh(x, s, field, cmap=style.PRESSURE, vmin=0, vmax=max(f.max() for f in fields), shading="nearest")
        axis.set_aspect("equal", "datalim")
        axis.set(title=f"at {places[i]:g} mm", xlabel="x, mm")
    for axis in axes[len(kept):]:
        axis.set_axis_off()
    if kept:
        axes[0].set_ylabel("s, mm")


def draw_passage(file, certified, left_out):
    """A wheel that goes along the track: from above, from the side, a film of its patches, and what it does."""
    places = file[PASSAGE][:]
    p = {name: data[:] for name, data in file["patches"].items()}
    shown = [names for names in figures_of(file, "sweep along the track", PASSAGE, certified) if names != ["vertical"]]  # from the side
    figure = style.figure((19, 14))
    grid = figure.add_gridspec(4, 1)
    above, side = figure.add_subplot(grid[0]), figure.add_subplot(grid[1])
    side.sharex(above)
    draw_from_above(figure, above, p, places)
    draw_from_the_side(side, file, p, places, certified)
    film = grid[2].subgridspec(1, FILM)
    draw_film([figure.add_subplot(film[k]) for k in range(FILM)], file, places, certified)
    row = grid[3].subgridspec(1, max(len(shown), 1))
    for k, names in enumerate(shown):
        axis = figure.add_subplot(row[k])
        draw_totals(axis, file, names, places, {"": list(range(len(places)))}, certified, True)
        axis.set(title=textwrap.fill(style.heading(names), TITLE_WIDTH), xlabel="along the track, mm")
    figure.suptitle(f"Passage: {len(certified)} places, bars: errors by the size of the elements{left_out}", fontsize=11)
    return figure


def figures_of(file, view, lead, certified):
    """The figures of a view: lists of the names that it draws in one panel, of which the file knows each."""
    def is_known(name):
        columns = [name] if name in file else [column for side in ("right", "left") if (column := beside(file, name, side))]
        return any(np.isfinite(file[column][:][certified]).any() for column in columns)

    return [names for names in VIEWS[view]["figures"] if lead != f"position.{names[0]}" and all(map(is_known, names))]


def draw(files):
    with h5py.File(files[0]) as file:
        require_columns(file)
        if "patches" in file:
            require_columns(file["patches"])
        outcomes = choices(file["status"]) or []
        if "certified" not in outcomes:
            refuse(f"'{files[0]}' cannot be drawn", "its status says no outcomes (attribute choices)", "Copy the file again from where it was whole.")
        certified = file["status"][:] == outcomes.index("certified")
        if not certified.any():
            refuse(f"'{files[0]}' cannot be drawn", "no case of the sweep is certified", "See the column status of its --csv.")
        keys = swept_keys(file)
        lead = leading(file, keys)
        over = file[lead][:] if lead else np.arange(len(certified))
        unit = text(file[lead].attrs["unit"]) if lead else ""
        if lead and keys[lead]:
            over, unit = np.arange(len(certified)), ""
        name = style.titled(lead, unit) if lead and not keys[lead] else "case"
        groups = groups_of(file, keys, lead)
        left_out = "" if certified.all() else f"; {(~certified).sum()} without a certificate are left out"
        if list(keys) == [PASSAGE] and "vertical" in file and "patches" in file and np.isfinite(file["patches/y"][:]).any():
            return draw_passage(file, certified, left_out)
        wheelsets = any(text(data.attrs.get("role", "")) == "right" for data in file.values())
        shown = figures_of(file, "sweep of wheelsets" if wheelsets else "sweep along the track" if lead == PASSAGE else "sweep", lead, certified)
        columns = -(-(len(shown) + (not wheelsets)) // 2)
        figure, axes = style.panels(2, columns, (12.5 if columns < 3 else 5.7 * columns, 8.8))
        places = list(axes.flat)
        joined = lead is not None
        if not wheelsets:
            first = places.pop(0)
            if "patches" in file and np.isfinite(file["patches/y"][:]).any():
                draw_patches(figure, first, file["patches"], over)
                first.set_ylabel(name)
            else:
                draw_totals(first, file, ["approach"], over, groups, certified, joined)
                first.set(title="Approach", xlabel=name)
        for axis, names in zip(places, shown):
            if wheelsets:
                draw_wheels(axis, file, names[0], over, groups, certified, joined)
            else:
                draw_totals(axis, file, names, over, groups, certified, joined)
            axis.set(title=style.heading(names), xlabel=name)
            if names == ["vertical"]:
                axis.invert_yaxis()  # z points down
        for axis in places[len(shown):]:
            axis.axis("off")
        if not wheelsets and (not lead or keys[lead]):
            style.whole_numbers(first.yaxis)
            for axis in places:
                style.whole_numbers(axis.xaxis)
        of = f"{len(certified)} wheelsets, right wheels solid, left ones dashed" if wheelsets else (
            f"{len(certified)} cases, bars: errors by the size of the elements")
        figure.suptitle(f"Sweep: {of}{left_out}", fontsize=11)
        return figure
