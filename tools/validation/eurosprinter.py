"""The locomotive Eurosprinter 127 001: creep forces on dry track, and the layer that makes ours those measured."""

import json

import numpy as np
from verification.page import number

from .points import Bin, bins, picture, read, result

CENTRES = [.53, .69, .88, 1.09, 1.48, 2.12, 2.91, 4.28, 6.1, 9.3, 12.4, 16.1, 19.8]  # percent
FITTED = slice(0, 4)  # bins to which the layer is fitted: 0.5 to 1.1 percent
CITED = 1.25 / 8200   # mm3/N: example tractcurv.inp of CONTACT (Vollebregt 2014)
YOKOSE = 0.61         # slope measured over Kalker's, 1/5 scale
LOAD = 106700         # N
BAR = 0.08
SCENE = {"kind": "patch", "load.force": LOAD, "motion.friction": 0.33, "grid.dx": 0.4, "grid.ds": 0.8, "grid.mx": 40,
         "grid.ms": 40, "gap.a": 8e-4, "gap.b": 2.814e-4}
FALLING = {"motion.speed": 10000, "motion.falling_friction": 0.14, "motion.half_slip_velocity": 1250}
CURVE = np.geomspace(0.02, 25, 28)  # percent


def ratio(program, creepage, compliance):
    """Fx / Fn at a creepage in percent."""
    layer = {"layer.compliance": compliance} if compliance else {}
    result = program.solve(SCENE | FALLING | {"motion.xi": creepage / 100} | layer)
    if not result["certified"]:
        raise RuntimeError(f"xi = {creepage} % with L = {compliance} is not certified")
    return result["Fx"] / LOAD


def law(creepage):
    """The law of friction where everything slips at this creepage in percent: the most that Fx / Fn can be."""
    most, least = SCENE["motion.friction"], FALLING["motion.falling_friction"]
    return least + (most - least) * 2 ** (-creepage / 100 * FALLING["motion.speed"] / FALLING["motion.half_slip_velocity"])


def slope(program, compliance):
    """Of Fx over xi where nothing slips, over that without a layer."""
    force = lambda L: program.solve(SCENE | {"motion.xi": 1e-8, "motion.friction": 1} | ({"layer.compliance": L} if L else {}))["Fx"]
    return force(compliance) / force(0)


def fitted(program, data, say):
    """What `bem_contact fit` says of L and these bins."""
    points = program.folder / "bins.csv"
    points.write_text("xi,Fx\n" + "".join(f"{b.creepage / 100:.9g},{b.force * LOAD:.9g}\n" for b in data))
    scene = program.scene(SCENE | FALLING | {"layer.compliance": 1e-4})
    found = json.loads(program.run(program.path, "fit", scene, "--measured", points, "--parameters", "layer.compliance",
                                   "--model", "halfspace", "--json"))
    say(f"fitted: L = {found['parameters']['layer.compliance']['value']:.4g} mm3/N")
    return found


def band(program, data, middle):
    """L up to which, and from which on, every one of these bins lies within the scatter of its points."""
    def inside(L):
        return all(abs(ratio(program, b.creepage, L) - b.force) <= b.scatter for b in data)

    ends = []
    for far in (middle / 20, middle * 20):
        good, bad = middle, far
        while max(good / bad, bad / good) > 1.01:
            half = np.sqrt(good * bad)
            good, bad = (half, bad) if inside(half) else (good, half)
        ends.append(good)
    return ends if inside(middle) else None


def chapter(page, program, folder, pictures, say, results=None):
    xi, measured = read(folder / "eurosprinter_digitised.csv", ["xi_percent", "Fx_over_Fn"])
    data = bins(xi, measured, CENTRES)
    say("Eurosprinter")
    fit = fitted(program, data[FITTED], say)
    found, low, high = (fit["parameters"]["layer.compliance"][name] for name in ("value", "low", "high"))
    columns = {L: [ratio(program, b.creepage, L) for b in data] for L in (0, found, CITED)}
    moved = [b for b, clean, with_layer in zip(data, columns[0], columns[found]) if abs(with_layer / clean - 1) > 0.01]
    ends = band(program, moved, found)
    slopes = {L: slope(program, L) for L in (found, CITED)}
    yokose = program.solve(SCENE | {"motion.xi": 1e-4, "layer.slope": YOKOSE})
    by_yokose = yokose["layer_compliance"]
    yokose_rows = [ratio(program, b.creepage, by_yokose) for b in data]

    page.heading("1 Creep forces of a locomotive: Eurosprinter 127 001")
    page.text(f"""Engel, Beck and Alders (1998) measured the traction of the Siemens locomotive 127 001 on dry track; Polach (2005)
        made it a usual test of creep force theories. Here are {len(xi)} points, read off a published picture by pixels (0.01 % of creepage,
        above 5 % 0.05 %, and 0.001 of Fx / Fn).""")
    page.items("**Stated**: 106.7 kN on the wheel, radius 625 mm, 10 m/s.",
               "**Assumed** (by Polach, Vollebregt and here): one ellipse with a/b = 0.5, steel with G = 82000 MPa and nu = 0.28, no "
               "lateral creepage and no spin, one state of the rail for all points.",
               "**Fitted by others, to these points**: the law of friction, mu = 0.14 + 0.19 exp2(-w / 1250 mm/s); Vollebregt (2014) fitted it "
               "together with a layer such as ours. So agreement above 3 % of creepage says little of the theory.",
               f"**Fitted here**: one number, the compliance L of the layer (`layer.compliance`), by least squares to the four bins from 0.5 to "
               f"1.1 % ([`bem_contact fit`](../data/tutorial/fit.md)). The other {len(data) - 4} bins judge it.")
    page.text(f"""Found: **L = {number(found, 3)} mm3/N**, in 95 of 100 cases between {number(low, 2)} and {number(high, 2)} by a bootstrap of the
        four bins. With it Fx grows at zero creepage {slopes[found]:.2f} times as fast as without: that is this locomotive in service. On clean rigs
        the slope is 0.9 to 1 of Kalker's (V-Track: Jayasree Krishnan, Yang, Li 2025). The points begin at {xi.min():.2f} % and do not measure that slope. {band_text(ends, len(moved))} CONTACT's example of this measurement has
        L = {number(CITED, 3)} mm3/N (slope {slopes[CITED]:.2f}).""")
    page.picture("validation_eurosprinter.png", "Fx over Fn, measured and computed, over the creepage")
    page.text(f"""Fx / Fn by bins. Edges are the geometric means of {', '.join(number(c) for c in CENTRES)} %; creepage and force are the means of
        the points; the scatter is their standard deviation. The bar is the larger of {100 * BAR:g} % and the scatter.""")
    rows, missed, why = [], [], []
    for k, b in enumerate(data):
        clean, layer, cited = (columns[L][k] for L in (0, found, CITED))
        holds = abs(layer - b.force) <= max(BAR * b.force, b.scatter)
        if not holds:
            missed.append(f"Eurosprinter at {b.creepage:.2f} %: {difference(layer, b)}")
            why.append(f"at {b.creepage:.2f} % it allows {law(b.creepage):.3f}, whatever the theory, and the mean of the {b.count} points is "
                       f"{b.force:.3f} +- {b.scatter / np.sqrt(b.count):.3f}")
        rows.append([f"{b.creepage:.2f}", b.count, f"{b.force:.3f}", f"{b.scatter:.3f}", f"{clean:.3f}", f"{difference(clean, b)}",
                     f"{layer:.3f}", f"{difference(layer, b)}", "fitted" if k < FITTED.stop else "judged",
                     "holds" if holds else "**misses**", f"{cited:.3f}", f"{yokose_rows[k]:.3f}"])
    page.table(["xi, %", "points", "measured", "scatter", "no layer", "", "L fitted", "", "", "bar", "L of CONTACT's example",
                f"slope {YOKOSE}"], rows)
    page.text(f"""Without a layer the half-space, certified and with a stated error of 0.1 %, is {difference(columns[0][0], data[0])} off the
        points at {data[0].creepage:.2f} % and {difference(columns[0][3], data[3])} at {data[3].creepage:.2f} %.""")
    if missed:
        page.text(f"""Outside its bar: {'; '.join(missed)}. There everything slips and the layer moves nothing: it is the law of friction that is
            too low ({'; '.join(why)}).""")
    page.text(f"""**Yokose's ratio.** On a rig of scale 1/5 Yokose (1973) measured {YOKOSE} of the slope of Kalker's theory. `layer.slope = {YOKOSE}`
        gives on this contact L = {number(by_yokose, 3)} mm3/N; the last column is what follows. It is stiffer than what the locomotive's points ask
        for.""")
    curves = {L: [ratio(program, x, L) for x in CURVE] for L in (0, by_yokose, found)}
    if results:
        result(program, SCENE | FALLING | {"layer.compliance": found}, data, LOAD, "0:0.2:81", results / "validation_eurosprinter.h5")

    def draw(axis):
        axis.plot(xi, measured, "o", color="#8a97a5", markersize=3.5, alpha=0.7, label="measured (Engel, Beck, Alders 1998)")
        axis.errorbar([b.creepage for b in data], [b.force for b in data], [b.scatter for b in data], fmt="s", color="#1c2733",
                      capsize=3, markersize=5, label="mean and scatter of a bin")
        for (L, forces), line, colour, name in zip(curves.items(), (":", "--", "-"), ("#b4533c", "#1b7f79", "#6a3d9a"),
                                                   ("half-space", f"slope {YOKOSE} (Yokose)", f"L = {found:.3g} mm³/N (fitted)")):
            axis.plot(CURVE, forces, line, color=colour, linewidth=1.8, label=name)
        axis.set_ylim(0, 0.36)

    picture(pictures / "validation_eurosprinter.png", "Eurosprinter 127 001", "longitudinal creepage, %", "Fx / Fn", draw, log=True)
    return missed


def difference(ours, measured):
    return f"{100 * (ours / measured.force - 1):+.1f} %"


def band_text(ends, count):
    if not ends:
        return f"No L keeps all {count} bins that the layer moves by more than 1 % within their scatter."
    return (f"Each L from {number(ends[0], 2)} to {number(ends[1], 2)} mm3/N keeps all {count} bins that the layer moves by more than 1 % within "
            "their scatter.")
