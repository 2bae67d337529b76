"""A table of forces: how far it is from solutions, and its numbers over the two axes that change them most."""

import h5py
import numpy as np

from . import style
from .kinds import number, text

DRAWN = 5  # columns of the table that a picture draws
LINES = 4  # values of the second axis
LEAST_CHANGE = 1e-6  # of a column that is drawn, over its scale: less is rounding, as of a prescribed force


def draw_errors(axis, file, columns, held):
    errors = [100 * file[f"interpolation_error/{c}"][()] / file[f"scale/{c}"][()] for c in columns]
    places = np.arange(len(columns))[::-1]
    axis.barh(places, errors, color=[style.RAIL if c in held else "none" for c in columns], edgecolor=style.RAIL)
    axis.set(yticks=places, xlabel="% of the column's scale", title="Largest interpolation error")
    axis.set_yticklabels(map(style.words, columns), fontsize=min(10, 160 / len(columns)))
    style.limit(axis, 100 * number(file, "tolerance"), f"goal {100 * number(file, 'tolerance'):g} %: filled bars are held to it",
                vertical=True)
    axis.legend(loc="upper center", bbox_to_anchor=(0.5, -0.12))


def at_point(file, name, k):
    """ "vertical force 60000 N": the k-th point of an axis."""
    grid = file[f"axes/{name}"]
    return f"{style.words(name)} {style.valued(grid[int(k)], text(grid.attrs['unit']))}"


def draw_column(axis, file, axes, column):
    """Over the axis along which it changes most, a line for some values of the next one, the others in their middle."""
    values = file[f"values/{column}"][:]
    change = [np.ptp(values, axis=k).mean() for k in range(values.ndim)]
    first, *rest = np.argsort(change)[::-1]
    second = rest[0] if rest else None
    at = [n // 2 for n in values.shape]
    at[first] = slice(None)
    shown = [None] if second is None else sorted({round(k) for k in np.linspace(0, values.shape[second] - 1, LINES)})
    grid = file[f"axes/{axes[first]}"]
    for k, dash, mark in zip(shown, ("-", "--", "-.", ":"), ("o", "s", "D", "^")):
        if second is not None:
            at[second] = k
        label = "" if second is None else at_point(file, axes[second], k)
        colour = style.look(column)[0]
        axis.plot(grid[:], values[tuple(at)], dash, marker=mark, markersize=4, color=colour, linewidth=1.3, label=label)
    others = ", ".join(at_point(file, name, at[k]) for k, name in enumerate(axes) if k not in (first, second))
    unit = text(file[f"values/{column}"].attrs["unit"])
    axis.set(xlabel=style.titled(axes[first], text(grid.attrs["unit"])) + (f"\n(at {others})" if others else ""),
             ylabel=style.titled(column, unit), title=style.heading([column]))
    style.degrees_beside(axis, text(grid.attrs["unit"]))
    style.legend(axis, fontsize=8)


def below(file, axis, node):
    """The numbers of the points that a nested axis has at a point of the axis before it."""
    first = file[f"first/{axis}"]
    return np.arange(int(first[node]), int(first[node + 1]))


def draw_nested(axis, file, axes, column):
    """Over the last axis, a line for some points of the second, the others in the middle of their lines."""
    outer, second, *between, last = axes
    start = len(file[f"axes/{outer}"]) // 2
    nodes = below(file, second, start)
    values, colour = file[f"values/{column}"], style.look(column)[0]
    for k, dash, mark in zip(sorted({round(k) for k in np.linspace(1, len(nodes) - 1, LINES)}), ("-", "--", "-.", ":"), ("o", "s", "D", "^")):
        label, node = f"{second} {file[f'axes/{second}'][nodes[k]]:.4g}", nodes[k]
        for name in between:
            line = below(file, name, node)
            node = line[len(line) // 2]
            label += f", {name} {file[f'axes/{name}'][node]:.4g}"
        line = below(file, last, node)
        axis.plot(file[f"axes/{last}"][line], values[line], dash, marker=mark, markersize=4, color=colour, linewidth=1.3, label=label)
    unit = [text(file[name].attrs["unit"]) for name in (f"axes/{last}", f"values/{column}")]
    axis.set(xlabel=f"{style.titled(last, unit[0])}   (at {at_point(file, outer, start)})", ylabel=style.titled(column, unit[1]), title=column)
    style.legend_beside(axis, below=True, columns=2, fontsize=8)


def draw(files):
    with h5py.File(files[0]) as file:
        axes, columns, held = (text(file.attrs[name]).split() for name in ("axis_names", "column_names", "held"))
        varies = [c for c in columns if np.ptp(file[f"values/{c}"][:]) > LEAST_CHANGE * file[f"scale/{c}"][()]]
        shown = sorted(varies, key=lambda c: c not in held)[:DRAWN]
        rows = 1 + len(shown) // 3
        figure, panels = style.panels(rows, 3, (14, 0.8 + 4.2 * rows))
        draw_errors(panels[0, 0], file, columns, held)
        for axis, column in zip(panels.flat[1:], shown):
            (draw_nested if "first" in file else draw_column)(axis, file, axes, column)
        for axis in panels.flat[1 + len(shown):]:
            axis.axis("off")
        size = (", below it " if "first" in file else ", ").join(f"{style.words(name)} ({len(file[f'axes/{name}'])})" for name in axes)
        figure.suptitle(f"Table over {size}; in brackets how many points, the marks", fontsize=11)
        return figure
