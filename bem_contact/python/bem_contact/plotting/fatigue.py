"""Patches in the shakedown diagram; fatigue index and damage over the arc length of the rail, or along the track."""

import h5py
import numpy as np

from . import shakedown, style
from .kinds import require_columns, text

MU = np.linspace(0.002, 0.6, 120)
LARGEST_DAMAGE = 1e-5  # of the usual damage function, for an axis where there is none


def draw_diagram(axis, t):
    """Each patch by p0/k and the friction that it uses, and up to where the steel shakes down."""
    mu, load, surface = t["mu_used"], t["p0_over_k"], t["FI_surf"] > 0
    below = ~surface & (load > t["p0_over_k_limit"])
    top, limits = max(6.0, 1.15 * load.max()), [shakedown.shakedown_limit(m) for m in MU]
    axis.fill_between(MU, np.minimum(limits, top), top, color=style.BOUND, alpha=0.15, linewidth=0)
    axis.plot(MU, 1 / MU, color=style.BOUND, linestyle=(0, (2, 2)), label="shakedown limit of the surface, p0/k = 1/μ")
    under = np.array(limits) < 0.999 / MU
    axis.plot(MU[under], np.array(limits)[under], color=style.INK, linestyle="-.", label="shakedown limit below the surface, of a long contact")
    axis.plot(MU, [shakedown.elastic_limit(m) for m in MU], color=style.INK, linestyle=":", linewidth=1.2,
              label="elastic limit of a long contact: below it nothing flows")
    for shown, mark, name in ((~surface & ~below, "o", "within both limits"), (below, "s", "beyond the limit below the surface"),
                              (surface, "^", "beyond the limit of the surface")):
        if shown.any():
            axis.plot(mu[shown], load[shown], mark, color=style.RAIL, markeredgecolor=style.INK, label=f"patch {name}")
    axis.set(title="Shakedown diagram", xlabel="μ used: shear force over normal force", ylabel="p0 / k", xlim=(0, 0.6), ylim=(0, top))
    style.legend_beside(axis, below=True, columns=1)


def columns_of(file):
    """Of the CSV file, with units in the names, or of the HDF5 file: by the names of the former."""
    if not h5py.is_hdf5(file):
        return np.genfromtxt(file, delimiter=",", names=True, ndmin=1)
    with h5py.File(file) as h5:
        require_columns(h5["patches"])
        return {name if (unit := text(data.attrs["unit"])) == "1" else f"{name}_{unit}": data[:] for name, data in h5["patches"].items()}


def draw(files):
    t = columns_of(files[0])
    names = t.dtype.names if isinstance(t, np.ndarray) else t
    if "along_mm" in names and np.ptp(t["along_mm"]) > 0:  # a passage
        x, label = t["along_mm"], "place along the track, mm"
    else:
        x, label = t["s_mm"], style.UP
    figure, ((diagram, index), (stress, damage)) = style.panels(2, 2, (12, 9.2))
    draw_diagram(diagram, t)

    index.plot(x, t["FI_surf"], "o", color=style.RAIL, markeredgecolor=style.INK, label="whole patch")
    index.plot(x, t["FI_worst_element"], "v", color="none", markeredgecolor=style.INK, label="worst element")
    style.limit(index, 0, "limit: above it the surface fatigues")
    index.set(title="Index of surface fatigue", ylabel="surface fatigue index FI_surf", xlabel=label)
    style.legend_beside(index, below=True, columns=1)

    stress.vlines(x, 0, t["von_mises_depth_mm"], color=style.GRID, linewidth=1)
    image = stress.scatter(x, t["von_mises_depth_mm"], c=t["von_mises_MPa"], cmap=style.STRESS, edgecolor=style.INK, vmin=0, zorder=3)
    figure.colorbar(image, ax=stress, label="von Mises stress, MPa")
    stress.set(title="Largest stress below the surface", xlabel=label, ylabel="depth, mm", ylim=(0, None))
    stress.invert_yaxis()

    damage.vlines(x, 0, t["damage"], color=style.RAIL, linewidth=1.5)
    damage.plot(x, t["damage"], "o", color=style.RAIL, markeredgecolor=style.INK)
    damage.set(title="Damage of one passage (T-gamma)", xlabel=label, ylabel="damage")
    if not t["damage"].any():
        damage.set_ylim(-0.05 * LARGEST_DAMAGE, LARGEST_DAMAGE)
    return figure
