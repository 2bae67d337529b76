"""Rolling radius difference, contact points and equivalent conicity of a wheelset."""

import h5py

from . import style
from .former import bodies_of
from .kinds import require_columns

SIDES = {"right": ("o", 3.2), "left": ("x", 3.6)}


def draw(files):
    with h5py.File(files[0]) as file:
        for group in ("function", "conicity"):
            require_columns(file[group])
        data = {name: values[:] for group in ("function", "conicity") for name, values in file[group].items() if isinstance(values, h5py.Dataset)}
        bodies = [" on ".join(bodies_of(file, side)) for side in SIDES]
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
