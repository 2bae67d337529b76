"""How profiles wear: what is gone over y by step, and depth over mileage."""

from pathlib import Path

import numpy as np
from matplotlib.animation import FuncAnimation, PillowWriter

from . import style
from .refusals import refuse

SHOWN = 5  # steps that a picture draws: more lines cannot be told apart
MOST_FRAMES = 60  # of an animation: more make a file of many MB and look the same
DRAWN_DEPTH = 5.0  # mm: as deep as the deepest place is drawn, an eighth of a rail's head
FILMS = (".gif", ".html")
DASHES = (":", "-.", (0, (5, 2)), "--", "-")


def folder_of(name):
    return Path(name) if Path(name).is_dir() else Path(name).parent


def steps_of(folder):
    """Rows of wear.csv: step, revolutions, mileage, depths, areas."""
    return np.loadtxt(folder / "wear.csv", delimiter=",", skiprows=1, ndmin=2)


def profile(folder, body, step, section=""):
    return np.loadtxt(folder / f"{body}_{step:04}{section}.txt")


def gone(folder, body, step, section=""):
    """y of the points and how far they have moved, mm."""
    new = profile(folder, body, 0, section)
    return new[:, 0], np.hypot(*(profile(folder, body, step, section) - new).T)


def stretch_of(folder):
    """Of a rail of sections: place of each, mm, and which body it belongs to."""
    file = folder / "stretch.csv"
    return np.loadtxt(file, delimiter=",", skiprows=1, ndmin=2)[:, :2].T if file.is_file() else None


def deepest(folder, step, sections):
    """The largest depth gone from each section, mm."""
    return np.array([gone(folder, "rail", step, f"_{k + 1:03}")[1].max() for k in range(sections)])


def shown_steps(steps):
    """Those that a picture draws, each with its line."""
    last = int(steps[-1, 0])
    shown = sorted({max(1, round(last * k / SHOWN)) for k in range(1, SHOWN + 1)}) if last else []
    return list(zip(shown, DASHES[-len(shown):], np.linspace(1, 2.4, len(shown))))


def draw_stretch(axis, folder, steps):
    at, body = stretch_of(folder)
    for step, dash, width in shown_steps(steps):
        depth = deepest(folder, step, len(at))
        for k in np.unique(body):
            axis.plot(at[body == k], depth[body == k], marker=".", linestyle=dash, linewidth=width, color=style.BODIES["rail"][0],
                      label=f"{steps[step, 2]:.3g} km" if k == body[0] else None)
    axis.set(title="Worn away from the rail", xlabel="place along the track, mm", ylabel="largest depth, mm", ylim=(0, None))
    axis.legend(title="mileage")
    axis.invert_yaxis()


def draw_steps(axis, folder, body, steps):
    worn = []
    for step, dash, width in shown_steps(steps):
        y, depth = gone(folder, body, step)
        worn += list(y[depth > 1e-6])
        axis.plot(y, depth, linestyle=dash, linewidth=width, color=style.BODIES[body][0], label=f"{steps[step, 2]:.0f} km")
    axis.set(title=f"Worn away from the {body}", xlabel=f"y of the {body}, mm", ylabel="depth, mm")
    if worn:
        axis.set_xlim(min(worn) - 2, max(worn) + 2)
        axis.set_ylim(0, None)
        axis.legend(title="mileage")
    axis.invert_yaxis()


def draw(files):
    folder = folder_of(files[0])
    steps = steps_of(folder)
    figure, ((rail, wheel), (depth, area)) = style.panels(2, 2, (12, 8.4))
    if stretch_of(folder) is None:
        draw_steps(rail, folder, "rail", steps)
    else:
        draw_stretch(rail, folder, steps)
    draw_steps(wheel, folder, "wheel", steps)
    for axis, column, what in ((depth, 3, "largest depth, mm"), (area, 5, "area gone from the section, mm²")):
        for k, body in enumerate(style.BODIES):
            axis.plot(steps[:, 2], steps[:, column + k], **style.line(style.BODIES[body]), label=body)
        axis.set(title=what.split(",")[0].capitalize(), xlabel="mileage, km", ylabel=what, ylim=(0, None))
        axis.legend()
    return figure


def animate(files, output):
    """Both profiles from step to step, the depth drawn larger than it is."""
    folder = folder_of(files[0])
    steps = steps_of(folder)
    if stretch_of(folder) is not None:
        refuse(f"'{folder}' cannot be drawn as a film", "its rail wears along the track, section by section",
               "Draw a picture (-o FILE.png), or sweep the scene of a step and draw that.")
    last, depths = int(steps[-1, 0]), dict(zip(style.BODIES, steps[-1, 3:5]))
    times = DRAWN_DEPTH / max(depths.values()) if any(depths.values()) else 1.0
    new = {body: profile(folder, body, 0) for body in ("wheel", "rail") if depths[body] > 0 or times == 1.0}
    figure, axes = style.panels(len(new), 1, (8, 3.5 * len(new)))
    lines = {}
    for axis, body in zip(axes[:, 0], new):
        axis.plot(*new[body].T, color=style.BOUND, linewidth=1, linestyle="--", label=f"new {body}")
        (lines[body],) = axis.plot([], [], color=style.BODIES[body][0], linewidth=2, label=f"worn {body}")
        z = new[body][:, 1]
        axis.set(xlabel=f"y of the {body}, mm", ylabel="z down, mm", aspect="equal", ylim=(z.max() + 1, z.min() - DRAWN_DEPTH - 1))
        axis.legend()

    def show(step):
        for body, shown in lines.items():
            shown.set_data(*(new[body] + times * (profile(folder, body, step) - new[body])).T)
        figure.suptitle(f"step {step}: {steps[step, 2]:.0f} km, rail {steps[step, 3]:.3f} mm, wheel {steps[step, 4]:.3f} mm deep; "
                        f"depth drawn {times:.3g} times as large")
        return list(lines.values())

    frames = sorted({round(last * k / (MOST_FRAMES - 1)) for k in range(MOST_FRAMES)})
    film = FuncAnimation(figure, show, frames=frames, interval=150)
    if output.suffix == ".html":
        output.write_text(film.to_jshtml())
    else:
        film.save(output, writer=PillowWriter(fps=7), dpi=80)
