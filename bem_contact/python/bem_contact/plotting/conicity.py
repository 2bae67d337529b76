"""Rolling radius difference, contact points and equivalent conicity of a wheelset."""

from pathlib import Path

import h5py

from . import style
from .kinds import require_columns, text

MOST_NAMED = 12  # lines of a map whose names fit below it
SIDES = {"right": ("o", 3.2), "left": ("x", 3.6)}


def draw(files):
    with h5py.File(files[0]) as file:
        for group in ("function", "conicity"):
            require_columns(file[group])
        data = {name: values[:] for group in ("function", "conicity") for name, values in file[group].items() if isinstance(values, h5py.Dataset)}
        bodies = [" on ".join(text(file[side].attrs[body]) for body in ("wheel", "rail")) for side in SIDES]
    figure, ((difference, conicity), (wheel, rail)) = style.panels(2, 2, (11, 8.4))
    y = data["lateral"]
    difference.plot(y, data["difference"], color=style.INK)
    difference.set(title="Rolling radius difference", ylabel="right less left, mm")
    conicity.plot(data["amplitude"], data["tan_gamma"], "-o", color=style.INK, markersize=3)
    conicity.set(title="Equivalent conicity (EN 15302)", xlabel="amplitude, mm", ylabel="tan γ", ylim=(0, None))
    style.limit(conicity, 3, "amplitude of the standard, 3 mm", vertical=True)
    conicity.legend()
    for panel, body in ((wheel, "wheel"), (rail, "rail")):
        for side, (mark, size) in SIDES.items():
            panel.plot(y, data[f"{side}_{body}_y"], mark, markersize=size, markeredgewidth=0.8, color=style.BODIES[body][0],
                       markerfacecolor=style.BODIES[body][0] if side == "right" else "none", label=side)
        panel.set(title=f"Contact point on the {body}", ylabel=f"y on the {body}, mm, to the field side")
        panel.legend(markerscale=2)
    for panel in (difference, wheel, rail):
        panel.set_xlabel("lateral displacement to the right, mm")
    figure.suptitle(bodies[0] if bodies[0] == bodies[1] else f"right {bodies[0]}, left {bodies[1]}")
    return figure


def draw_map(files):
    """Over the gauge, a line each pair; at one gauge over the wheels, a mark each rail. Bars: the scatter of the profiles."""
    with h5py.File(files[0]) as file:
        require_columns(file["map"])
        data = {name: values[:] for name, values in file["map"].items() if isinstance(values, h5py.Dataset)}
        wheels, rails = ([Path(name).name for name in text(file[body][()]).split("\n")] for body in ("wheels", "rails"))
        amplitude = float(file["amplitude"][()])
    wheel, rail = data["wheel"].astype(int), data["rail"].astype(int)
    over_gauge = len(set(data["gauge"])) > 1
    figure, axes = style.panels(1, 1, (max(8, 0.5 * len(wheels)) if not over_gauge else 8, 5))
    panel = axes[0, 0]
    pairs = sorted({(w, r) if over_gauge else (0, r) for w, r in zip(wheel, rail)})
    for k, (w, r) in enumerate(pairs):
        its = (rail == r) & ((wheel == w) | (not over_gauge))
        colour, dash, mark = (style.INK, style.RAIL, style.WHEEL)[k % 3], ("-", "--", ":", "-.")[k % 4], "osD^vPX*"[k % 8]
        x = data["gauge"][its] if over_gauge else wheel[its] + 0.15 * (k / max(1, len(pairs) - 1) - 0.5)
        panel.errorbar(x, data["tan_gamma"][its], yerr=data["tan_gamma_spread"][its] if "tan_gamma_spread" in data else None, capsize=3,
                       linestyle=dash if over_gauge else "none", marker=mark, color=colour, markerfacecolor=colour if k % 2 == 0 else "none",
                       label=f"{wheels[w]} on {rails[r]}" if over_gauge else f"on {rails[r]}")
    if not over_gauge:
        panel.set_xticks(range(len(wheels)), wheels, rotation=30 if len(wheels) > 4 else 0, ha="right" if len(wheels) > 4 else "center")
    bars = "; bars: standard deviation by the scatter of the profiles" if "tan_gamma_spread" in data else ""
    panel.set(xlabel="track gauge, mm" if over_gauge else "wheel", ylabel="tan γ", ylim=(0, None))
    figure.suptitle(f"Equivalent conicity for an amplitude of {amplitude:g} mm{bars}", fontsize=11)
    if len(pairs) <= MOST_NAMED:
        style.legend_beside(panel, below=True, columns=3)
    return figure
