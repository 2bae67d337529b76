"""The roller rig of Virginia Tech: the shape of a creep curve, because its load is not stated."""

import numpy as np

from .points import picture, read

SCENE = {"kind": "patch", "load.force": 9600, "motion.friction": 0.5, "grid.dx": 0.12, "grid.ds": 0.12, "grid.mx": 48,
         "grid.ms": 48, "gap.a": 2e-3, "gap.b": 2e-3}


def curve(program, creepages, compliance):
    layer = {"layer.compliance": compliance} if compliance else {}
    return np.array([program.solve(SCENE | {"motion.xi": x} | layer)["Fx"] for x in creepages])


def shape(creepage, force):
    """Force over the largest, over the creepage over that at half of the largest force."""
    rising = np.maximum.accumulate(force)
    return creepage / np.interp(0.5 * force.max(), rising, creepage), force / force.max()


def chapter(page, program, folder, pictures, say):
    say("roller rig")
    xi, fit, lowest, highest = read(folder / "vtfra_creep_digitised.csv", ["creepage_percent", "fit_N", "lowest_N", "highest_N"])
    x, y = shape(xi, fit)
    measured = x[:, None] * np.ones((1, 2)), np.array([lowest, highest]).T / fit.max()
    creepages = np.geomspace(2e-4, 0.2, 26)
    curves = {name: shape(creepages, curve(program, creepages, L))
              for name, L in (("half-space", 0), ("half-space and a soft layer", 2e-4))}
    page.heading("2 A roller rig: the shape of a creep curve")
    page.text("""One dry sweep of the roller rig of Virginia Tech (spline through some 4,200 points, and the lowest and highest point near
        it, read off a picture by pixels, 16 N). **Neither load nor profiles are stated**, so only the shape can be compared: the force over
        the largest one, over the creepage relative to that of half of the largest force. Nothing is fitted. Ours are a circular contact
        with Coulomb's law.""")
    page.picture("validation_roller_rig.png", "Shape of the creep curve, measured and computed")
    at = lambda name: np.interp(2, *curves[name])
    page.text(f"""At twice the creepage of half the force {np.interp(2, x, y):.2f} of the largest force was measured; the half-space has
        {at("half-space"):.2f}, with a soft layer {at("half-space and a soft layer"):.2f}. The bend before saturation is as round as with a soft
        layer, and rounder than the half-space's alone. Both lie within the points' own width, so that this curve proves neither.""")

    def draw(axis):
        axis.fill_between(x, measured[1][:, 0], measured[1][:, 1], color="#8a97a5", alpha=0.25, label="lowest to highest point")
        axis.plot(x, y, "s", color="#1c2733", markersize=4, label="spline through the points")
        for (name, (a, b)), line, colour in zip(curves.items(), (":", "-"), ("#b4533c", "#6a3d9a")):
            axis.plot(a, b, line, color=colour, linewidth=1.8, label=name)
        axis.set(xlim=(0, 7), ylim=(0, 1.25))

    picture(pictures / "validation_roller_rig.png", "VT-FRA roller rig, one dry sweep", "creepage over that of half the largest force",
            "Fx over the largest", draw)
