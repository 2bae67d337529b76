"""Numbers of answers that two systems have computed: which are compared, and how far apart they may be. It is a module of try_windows."""

import csv
import math
import re

ALLOWED = 1e-9  # relative to scale_of()
# What a rounding moves further: the place of a flat minimum, the end of a search, a difference of two solutions. Two programs for Linux, with
# FFTW and without, are as far apart in all but the places (`conicity`), which follow the sines of the system's C library.
ALLOWED_OF = {  # by a part of the command or of the number's name
    "shakedown": 1e-2,
    "conicity": 1e-4,
    "curves": 1e-6,
    "study": 1e-6,
    "wheelset": 1e-6,
    "/difference/": 1e-6,
    "conformity": 1e-6,
    "free_rolling": 1e-6,
    "discretisation": 1e-7,
    "wear": 1e-7,
    "fatigue": 1e-7,
}
NEAR_ZERO = {"x": 1, "y": 1, "s": 1, "z": 1, "delta": 1, "axis_angle": 1, "stress": 1,  # mm, rad, MPa
             "xi": 1e-3, "eta": 1e-3, "phi": 1e-3, "rigid_creepages": 1e-3}
NOT_COMPARED = ("seconds", "certificate", "error", "work", "iterations", "commit", "wheelset/residual", "lateral_residual",
                "outer_rate")  # rounding or time alone, and steps of a solver
FORCES = ("Fx", "Fy", "Fz", "Fn", "Fs", "Mx", "My", "Mz", "Mn", "Ms", "roll_moment", "torque")  # N, and N mm


def numbers(answer, path=""):
    """{path: number}."""
    if isinstance(answer, (dict, list)):
        out = {}
        for name, value in answer.items() if isinstance(answer, dict) else enumerate(answer):
            out.update(numbers(value, f"{path}/{name}"))
        return out
    usable = isinstance(answer, (int, float)) and not any(part in path for part in NOT_COMPARED)
    return {path: float(answer)} if usable else {}


def columns(file):
    with open(file, newline="", encoding="utf-8") as lines:
        return list(csv.DictReader(line for line in lines if not line.startswith("#")))


def as_numbers(rows):
    out = []
    for row in rows:
        out.append({})
        for name, text in row.items():
            try:
                out[-1][name] = float(text)
            except (TypeError, ValueError):
                pass
    return numbers(out)


def limit_of(name):
    return max((limit for part, limit in ALLOWED_OF.items() if part in name), default=ALLOWED)


def scale_of(name, values):
    """What a difference is measured by: the number, but forces and moments by the largest in the same answer, and what is zero by symmetry in
    some answers by NEAR_ZERO at least."""
    if any(f"/{kind}" in name for kind in FORCES):
        return max(abs(value) for other, value in values.items() if any(f"/{kind}" in other for kind in FORCES) and math.isfinite(value))
    words = {re.sub("_(mm|rad)$", "", word) for word in name.split("/")}
    return max([abs(values[name]), *(NEAR_ZERO[word] for word in words & NEAR_ZERO.keys())])


def apart(one, other, scale):
    return 0 if one == other or (math.isnan(one) and math.isnan(other)) else abs(one - other) / max(scale, 1e-30)
