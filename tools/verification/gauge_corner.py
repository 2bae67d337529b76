"""S1002 on 60E1 at the gauge corner without friction: the contact of the 3-D analysis of tests/VERIFICATION.md, section 4, by
bem_contact and with exact kinematics (deformed_contact.py)."""

import re

import h5py
import numpy as np

from .deformed_contact import Bodies, DeformedContact, Elements, Surface
from .program import ROOT

LATERAL, FORCE, RADIUS = 6.6, 1e5, 460.0  # mm, N, mm
TAPE = 1360 / 2 + 70  # mm: back to back, and from the flange's back to the tape circle
# The 3-D contact analysis of tests/VERIFICATION.md, section 4.
BRICKS = {"rail held at its web, wheel at its rim": (59827, 0.15127, 2074, 111.0, -30.169),
          "structural motion removed": (61736, 0.13314, 2010, 117.7, -30.352)}
QUANTITIES = ("Fy", "approach", "pmax", "area", "centre of pressure, s")
UNITS = dict(zip(QUANTITIES, ("N", "mm", "MPa", "mm2", "mm")))
# name: (held: rail, wheel; structural; dx, ds, rows, columns, middle of the rows on the rail; arc lengths of
# opposite points of rail and wheel add up to, in the contact; 0.05 mm more changes Fy by 0.013 %)
CASES = {
    "rail held at its foot, wheel at its bore": ("foot", "bore", "included", 0.5, 0.25, 22, 22, -27.75, 2.59),
    "rail held at its web, wheel at its rim": ("web", "rim", "included", 0.75, 0.5, 24, 14, -31.5, 3.295),
    "structural motion removed": ("foot", "bore", "removed", 0.5, 0.325, 32, 20, -31.5, 3.306),
}
# Body files with other remote sections: these lie between one and two times D from the strip, D = 20 mm.
OTHER_REMOTE_SECTIONS = {
    "D = 21 mm": lambda body: body + "\n[harmonic]\nremote_distance = 21\n",
    "strips shorter by 3 mm at each end": lambda body: re.sub(
        r"^(from|to) = (-?\d+)", lambda m: f"{m[1]} = {int(m[2]) + (3 if m[1] == 'from' else -3)}", body, flags=re.M),
}


def table(program, name):
    """Points of a standard profile: arc length, y, z."""
    file = program.folder / f"{name}.csv"
    program.run(program.path, "profile", name, "--step", 0.05, "--csv", file)
    t = np.loadtxt(file, delimiter=",", skiprows=1)
    return t[np.unique(t[:, 0], return_index=True)[1]]


def part(t, low, high):
    return Surface(*t[(t[:, 0] > low) & (t[:, 0] < high), :3].T)


def touching(program):
    """The bodies as bem_contact places them: gauge 1435 mm, 14 mm below the top, the wheel lowered onto the rail."""
    rail, wheel = table(program, "60E1"), table(program, "S1002")
    top, gauge_side = rail[:, 2].min(), rail[rail[:, 1] < 0]
    gauge_side = gauge_side[np.argsort(gauge_side[:, 2])]
    face = min(gauge_side[gauge_side[:, 2] < top + 14, 1].min(), np.interp(top + 14, gauge_side[:, 2], gauge_side[:, 1]))
    origin, across = (1435 / 2 - face, -top), TAPE + LATERAL
    rail, wheel = part(rail, -48, -5), part(wheel, 15, 47)
    s = np.linspace(-47, -6, 400001)
    y = origin[0] + rail.y(s) - across
    opposite = (y > -46.5) & (y < -16)
    lowered = (origin[1] + rail.z(s) - wheel.z_of_y(y))[opposite].min()
    return Bodies(rail, wheel, origin, (across, lowered), RADIUS)


def influence_file(program, folder, kind, held, other=""):
    """Of the harmonic method, made if it is not there. `other`: a key of OTHER_REMOTE_SECTIONS."""
    name = {"rail": "rail_60E1_gauge_corner", "wheel": "wheel_S1002_flange_root"}[kind]
    stem = "_".join(filter(None, (kind, held, *other.split())))
    body, out = folder / f"{stem}.toml", folder / f"{stem}.h5"
    if not out.exists():
        text = (ROOT / "data" / "bodies" / f"{name}.toml").read_text()
        text = text.replace(f'kind = "{kind}"', f'kind = "{kind}"\nheld = "{held}"')
        body.write_text(OTHER_REMOTE_SECTIONS[other](text) if other else text)
        program.run(ROOT / "tools" / "influence", body, out)
    return out


def expanded(program, file, case, centre):
    _, _, structural, dx, ds, rows, columns, *_ = case
    out = program.folder / "numbers.h5"
    program.run(program.path, "influence", "expand", file, "--dx", dx, "--ds", ds, "--mx", 2 * columns, "--my", rows,
                "--centre", centre, "--structural-compliance", structural, "-o", out)
    with h5py.File(out) as f:
        return f["influence_numbers"][:], f["s"][:]


def solved_by_program(program, case, files, contact_motion):
    _, _, structural, dx, ds, *_ = case
    r = program.solve({"rail.profile": "60E1", "wheel.profile": "S1002", "rail.influence": files[0], "wheel.influence": files[1],
                       "rail.structural": structural, "wheel.structural": structural, "position.lateral": LATERAL,
                       "load.force": FORCE, "motion.frictionless": True, "grid.dx": dx, "grid.ds": ds,
                       "solver.contact_motion": contact_motion}, "fem")
    p = r.fields["p_n"].sum(axis=1)
    values = {q: r[q] for q in ("Fy", "approach", "pmax", "area")}
    return values | {"centre of pressure, s": float(p @ r.fields["s"] / p.sum())}


def deformed_contact(bodies, case, rail, wheel):
    """`rail`, `wheel`: influence numbers and arc lengths of the rows of each. Rows of the wheel lie opposite those of the rail
    where the contact is."""
    dx, columns = case[3], case[6]
    (rail_numbers, rail_s), (wheel_numbers, wheel_s) = rail, wheel
    turned = np.ascontiguousarray(wheel_numbers[:, ::-1][:, :, :, ::-1])
    return DeformedContact(bodies, Elements(rail_s, wheel_s[::-1], dx, columns), rail_numbers, turned)


def exact_contact(program, bodies, case, files):
    """With kernels of the harmonic method."""
    middle, opposite = case[7:]
    return deformed_contact(bodies, case, expanded(program, files[0], case, middle),
                            expanded(program, files[1], case, opposite - middle))


def halved(case):
    """The same on rows half as wide."""
    held_and_structure, (dx, ds, rows), rest = case[:3], case[3:6], case[6:]
    return (*held_and_structure, dx, ds / 2, 2 * rows, *rest)
