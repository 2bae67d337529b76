"""Measured points: read, put into bins, drawn."""

from dataclasses import dataclass

import matplotlib
import numpy as np

matplotlib.use("Agg")
import matplotlib.pyplot as plt

INK, GRID = "#1c2733", "#e3e7eb"


def read(file, columns):
    """The columns of a CSV file whose comments begin with '#'."""
    lines = [line for line in file.read_text().splitlines() if line.strip() and not line.startswith("#")]
    head = [name.strip() for name in lines[0].split(",")]
    if head != columns:
        raise SystemExit(f"The file '{file}' has other columns (they are {', '.join(head)}) Give {', '.join(columns)}.")
    return np.array([[float(v) for v in line.split(",")] for line in lines[1:]]).T


@dataclass
class Bin:
    """Points of about one creepage."""

    creepage: float  # mean, percent
    force: float     # mean
    scatter: float   # standard deviation of the points
    count: int


def bins(creepage, force, centres):
    """Edges at the geometric means of the centres; the first and the last bin are open."""
    edges = [0, *np.sqrt(np.array(centres[1:]) * centres[:-1]), np.inf]
    inside = [(creepage >= a) & (creepage < b) for a, b in zip(edges, edges[1:])]
    return [Bin(creepage[i].mean(), force[i].mean(), force[i].std(ddof=1), i.sum()) for i in inside]


def result(program, scene, data, scale, values, file):
    """The result file of creep curves with these bins beside them; `scale`: the force of 1. `values`: FROM:TO:COUNT of the curve."""
    points = program.folder / "points.csv"
    points.write_text("xi,Fx,scatter\n" + "".join(f"{b.creepage / 100!r},{b.force * scale!r},{b.scatter * scale!r}\n" for b in data))
    program.run(program.path, "creep-curves", program.scene(scene), f"--xi={values}", "--measured", points, "-o", file)


def picture(file, title, x, y, draw, log=False):
    figure, axis = plt.subplots(figsize=(7.5, 4.4), layout="constrained")
    draw(axis)
    axis.set(title=title, xlabel=x, ylabel=y)
    axis.set_xscale("log" if log else "linear")
    axis.grid(color=GRID)
    axis.legend(frameon=False, labelcolor=INK, fontsize=9)
    figure.savefig(file, dpi=100, metadata={"Software": None})
    plt.close(figure)
