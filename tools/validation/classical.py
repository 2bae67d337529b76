"""Classical measurements whose numbers are in libraries: scenes are ready, points are wanted."""

import tomllib

import numpy as np
from verification.program import ROOT

from .points import read

WANTED = [
    ("johnson_1958", "Johnson (1958), J. Applied Mechanics 25: the effect of a tangential contact force, and of spin, upon the rolling motion of a sphere",
     "steel balls between planes: creepage over tangential force; lateral creepage by spin"),
    ("vermeulen_johnson_1964", "Vermeulen and Johnson (1964), J. Applied Mechanics 31", "ellipses of several a/b: creepage over tangential force"),
    ("halling_1964", "Halling (1964), on microslip by conformity. J. Mechanical Engineering Science 6",
     "a ball in a groove of nearly its radius: slip by conformity"),
    ("poole", "Poole, tests on rolling discs", "rolling discs: traction over creepage"),
    ("v_track_2025", "Jayasree Krishnan, Yang, Li (2025), rig V-Track", "clean dry steel at a fifth of full size: creep force over creepage"),
]

def chapter(page, program, folder, say):
    page.heading("3 What is wanted")
    page.text("""The numbers of these measurements are in libraries and papers, and not here. Each has a scene in
        `tools/validation/wanted` with the unit ellipse of its test. Add a CSV file of that name to the folder of measured points, with the columns
        `creepage, force`, and this page compares them. Creepage is
        multiplied by the slope of linear theory, G a b C11, over mu Fn; force is Fx over mu Fn. Both are free of the size of the test.""")
    rows = []
    for name, source, what in WANTED:
        say(name)
        scene = flat(tomllib.loads((ROOT / "tools" / "validation" / "wanted" / f"{name}.toml").read_text()))
        rows.append([source, what, f"`{name}.toml`", compared(program, scene, folder / f"{name}.csv")])
    page.table(["measurement", "what", "scene", "difference, mean and largest"], rows)

def flat(table, path=""):
    """{"load.force": 1.0} of nested tables."""
    out = {}
    for key, value in table.items():
        out |= flat(value, f"{path}{key}.") if isinstance(value, dict) else {path + key: value}
    return out

def compared(program, scene, file):
    if not file.exists():
        return "points wanted"
    creepage, force = read(file, ["creepage", "force"])
    load = scene["load.force"] * scene["motion.friction"]
    slope = program.solve(scene | {"motion.xi": 1e-9, "motion.friction": 1.0})["Fx"] / 1e-9
    ours = np.array([program.solve(scene | {"motion.xi": c * load / slope})["Fx"] / load for c in creepage])
    return f"{np.mean(ours - force):+.3f}, {np.abs(ours - force).max():.3f}"
