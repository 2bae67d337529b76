"""What all pictures share. One colour has one meaning, the same as on the pages of `bem_contact report`; line styles and
marks say the same without colours. Numbers have names that people read, not those of the files."""

import math

import matplotlib
import numpy as np
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.colors import LinearSegmentedColormap
from matplotlib.figure import Figure
from matplotlib.text import Text
from matplotlib.ticker import MaxNLocator
from matplotlib.transforms import ScaledTranslation

from .shared import SHARED, WORDS

INK, GRID, FRAME, OUTSIDE = "#1c2733", "#e3e7eb", "#8a97a5", "#f6f7f9"
RAIL, WHEEL = "#5b6f82", "#b4533c"
ADHESION, BOUND = "#d95f02", "#8a949e"
ALONG_X, ALONG_S = "#6a3d9a", "#1b7f79"
DEEPEST_PRESSURE = "#3b7cc4"
PRESSURE = LinearSegmentedColormap.from_list("pressure", ["#eef4fb", DEEPEST_PRESSURE])
STRESS = LinearSegmentedColormap.from_list("stress", ["#ffffff", "#4a4a4a"])
BODIES = {"rail": (RAIL, "-", "o"), "wheel": (WHEEL, "--", "s")}  # colour, line, mark
FORCES = {"Fx": (ALONG_X, "-", "o"), "Fs": (ALONG_S, "--", "s"), "Fy": (ALONG_S, "--", "s"), "Fz": (INK, ":", "D"),
          "Mz": (INK, "-.", "d"), "pmax": (DEEPEST_PRESSURE, "-", "o")}

class Models(dict):
    """Title, short title and line of each model. A model that is not here has its name in scenes."""

    def __missing__(self, name):
        return name, name, "-"

    def those_of(self, found):
        """The models that are found, in this order, and others behind."""
        return [*(m for m in self if m in found), *(m for m in found if m not in self)]

LINES = {"fem": "-", "tangent_plane": "--", "halfspace": ":", "hertz": "-.", "simplified": (0, (5, 1, 1, 1))}
MODELS = Models({name: (words["title"], words["short"], LINES.get(name, "-")) for name, words in SHARED["models"].items()})
BELOW_LABEL = 42  # points
PICTURES = (".png", ".pdf", ".svg")
ACROSS, UP = "x, rolling direction, mm", "s along the rail, mm"

def use():
    matplotlib.rcParams.update({
        "text.parse_math": False,  # names of files may hold $
        "font.family": "DejaVu Sans", "font.size": 10, "text.color": INK, "axes.edgecolor": FRAME, "axes.labelcolor": INK,
        "xtick.color": INK, "ytick.color": INK, "axes.titlelocation": "left", "axes.titleweight": "bold", "axes.titlesize": 11,
        "axes.grid": True, "axes.axisbelow": True, "grid.color": GRID, "grid.linewidth": 0.6, "legend.frameon": True,
        "legend.framealpha": 0.85, "legend.edgecolor": "none", "legend.fontsize": 9, "lines.linewidth": 1.8, "lines.markersize": 5.5,
        "figure.constrained_layout.h_pad": 0.12, "figure.constrained_layout.w_pad": 0.12})

def figure(size):
    """An empty one, inches. No window shows it, and pyplot does not know it."""
    made = Figure(size, layout="constrained")
    FigureCanvasAgg(made)
    return made

def panels(rows, columns, size, **options):
    """A figure and its panels, always as an array [rows][columns]."""
    made = figure(size)
    return made, made.subplots(rows, columns, squeeze=False, **options)

def words(name):
    """ "largest pressure" of "pmax"."""
    return WORDS.get(name, name)

def heading(names):
    """ "Largest pressure" of a panel."""
    text = " and ".join(map(words, names))
    return text[0].upper() + text[1:]

def titled(name, unit):
    """ "largest pressure, MPa"; a number without a unit has its name alone. A panel of an angle has degrees_beside(), too."""
    return words(name) if unit in ("", "1") else f"{words(name)}, {unit}".replace("mm2", "mm²").replace("degC", "°C")

def valued(value, unit):
    """ "70000 N"; an angle also in degrees: "0.0025 rad (0.14°)"."""
    text = f"{value:.6g}" if unit in ("", "1") else f"{value:.6g} {unit}"
    return f"{text} ({math.degrees(value):.3g}°)" if unit == "rad" else text

def degrees_beside(axis, x="", y=""):
    """A second scale above a panel whose x has the unit rad, to the right of one whose y has."""
    both = {"functions": (np.degrees, np.radians)}
    if x == "rad":
        axis.secondary_xaxis("top", **both).set_xlabel("degrees")
    if y == "rad":
        axis.secondary_yaxis("right", **both).set_ylabel("degrees")

def look(name):
    """Colour, line and mark of a number."""
    return FORCES.get(name, (INK, "-", "o"))

def line(style, **more):
    """Options of plot() for a colour, a line and a mark."""
    colour, dash, mark = style
    return {"color": colour, "linestyle": dash, "marker": mark, "markerfacecolor": colour if dash == "-" else "none", **more}

def limit(axis, value, name, vertical=False):
    """A line that says what it means: a goal, a floor, a bound."""
    draw = axis.axvline if vertical else axis.axhline
    draw(value, color=BOUND, linestyle=(0, (2, 2)), linewidth=1.5, zorder=1, label=name)

def legend(axis, **more):
    if axis.get_legend_handles_labels()[1]:
        axis.legend(**more)

def legend_beside(axis, below=False, columns=4, **more):
    """Above the panel or below its label, never on the curves. It may be wider than the panel, but of one column."""
    place = {"loc": "lower left", "bbox_to_anchor": (-0.02, 1.0)}
    if below:
        under = axis.transAxes + ScaledTranslation(0, -BELOW_LABEL / 72, axis.figure.dpi_scale_trans)
        place = {"loc": "upper center", "bbox_to_anchor": (0.5, 0), "bbox_transform": under}
    axis.legend(ncol=columns, borderaxespad=0.2, columnspacing=1.4, **place, **more).set_in_layout(columns == 1)

def drawn(figure):
    """What is written in a picture, but for numbers at ticks: titles, labels, legends, remarks."""
    ticks = {text for axis in figure.axes for one in (axis.xaxis, axis.yaxis) for text in one.get_ticklabels(which="both")}
    return [text.get_text() for text in figure.findobj(Text) if text.get_visible() and text.get_text().strip() and text not in ticks]

def save(figure, output):
    """With all legends, which the layout leaves out so that they do not push panels apart. A .png says in its description what is drawn."""
    figure.draw_without_rendering()
    figure.set_layout_engine("none")
    for axis in figure.axes:
        if axis.get_legend():
            axis.get_legend().set_in_layout(True)
    metadata = {"Description": "\n".join(drawn(figure))} if str(output).lower().endswith(".png") else None
    figure.savefig(output, dpi=110, bbox_inches="tight", metadata=metadata)

def whole_numbers(axis):
    """Of an x or y axis that counts."""
    axis.set_major_locator(MaxNLocator(integer=True))

def down(axis):
    """z points down."""
    axis.set_ylim(*sorted(axis.get_ylim(), reverse=True))
