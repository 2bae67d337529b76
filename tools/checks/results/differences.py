"""When are two results the same? Each number is compared with a scale that is not near zero.

    forces           the largest force of the result
    moments          this force times the length of the patch (the root of its area)
    pressures        the largest pressure
    lengths          their own size, or the length of the patch for positions
    creepages        the larger of both
    counts, states   must be equal
"""

import math

import numpy as np

WITHIN_CERTIFICATE = 1e-6  # what the certificate allows, and a solver may therefore leave open
COUNTS = {"contact", "adhesion", "slip", "mx", "ms", "patches", "patch_count", "converged", "code", "model"}
FORCES = {"Fx", "Fy", "Fz", "Fs", "Fn", "Fn_2"}
MOMENTS = {"Mz", "Mx", "Ms", "Mn"}
LENGTHS = {"x", "s", "y", "z", "reference_s", "reference_y", "reference_z", "s_from", "s_to", "semi_axis_a", "semi_axis_b",
           "rail_y", "rail_z", "wheel_s", "wheel_y", "wheel_z"}
ANGLES = {"delta", "reference_delta", "wheel_delta", "axis_angle"}
LEAST = {"creepage": 1e-6, "power": 1e-6, "approach": 1e-4}  # 1 or mm; N mm per mm and N; mm


def scales_of(record):
    """What each kind of number is measured by; taken from the stored record."""
    n = record["numbers"]

    def largest(keys, least):
        found = [abs(v) for key, v in n.items() if key.split()[-1] in keys and v is not None]
        return max(found, default=0.0) or least

    force = largest(FORCES, 1.0)
    length = math.sqrt(n.get("area") or 1.0) or 1.0
    return {"force": force, "moment": force * length, "length": length, "pressure": largest({"pmax"}, 1.0),
            "creepage": max(largest({"xi", "eta"}, 0.0), LEAST["creepage"]),
            "power": max(largest({"T_gamma"}, 0.0), LEAST["power"] * force),
            "approach": max(largest({"approach"}, 0.0), LEAST["approach"])}


def scale_of(name, value, scales):
    last = name.split()[-1].removesuffix("_error")  # an error has the scale of what it is the error of
    kind = ("force" if last in FORCES else "moment" if last in MOMENTS else "creepage" if last in ("xi", "eta")
            else "power" if last == "T_gamma" else "pressure" if last == "pmax" else "approach" if last in ("approach", "overlap")
            else "length" if last in LENGTHS else None)
    if kind:
        return scales[kind]
    return 1.0 if last in ANGLES | {"discretisation"} else abs(value) or 1.0


def number_difference(name, old, new, scales):
    """0 where they are the same; infinite where one is missing or a count differs."""
    if old == new:
        return 0.0
    if old is None or new is None or name.split()[-1] in COUNTS or not (math.isfinite(old) and math.isfinite(new)):
        return math.inf
    return abs(new - old) / scale_of(name, old, scales)


def field_scale(name, old, scales):
    last = name.split("/")[-1]
    if last in ("p_n", "p_x", "p_s", "stress", "von_mises", "largest_shear"):
        return scales["pressure"]
    if last.endswith("_error") or name.startswith("patches/"):
        return scale_of(last, float(np.max(np.abs(old), initial=0.0)), scales)
    if last in ("u_x", "u_s", "u_n", "deformed_distance"):
        return max(scales["approach"], float(np.max(np.abs(old), initial=0.0)))
    if name.startswith("history/") and last in FORCES:
        return scales["force"]
    if last in ("slip_x", "slip_s", "creepage_x", "creepage_s"):
        return max(scales["creepage"], float(np.max(np.abs(old), initial=0.0)))
    return float(np.max(np.abs(old), initial=0.0)) or 1.0


def field_difference(name, old, new, scales):
    """The difference, and a word on it."""
    if new is None or old is None or np.shape(old) != np.shape(new):
        return math.inf, "missing or of another shape"
    if name == "state":
        unlike = int(np.count_nonzero(old != new))
        return (math.inf, f"{unlike} of {old.size} elements differ") if unlike else (0.0, "")
    if np.array_equal(old, new, equal_nan=True):
        return 0.0, ""
    if not np.array_equal(np.isfinite(old), np.isfinite(new)):
        return math.inf, "not finite in other places"
    at = np.nanargmax(np.abs(new - old))
    return (float(np.nanmax(np.abs(new - old))) / field_scale(name, old, scales),
            f"{np.ravel(old)[at]:.12g} -> {np.ravel(new)[at]:.12g} where it is largest")


def digits(number):
    return "none" if number is None else f"{number:.13g}"


def compare_records(old, new):
    """[(what, difference, text)] of numbers and fields, and [(what, old, new)] of words."""
    if old["status"] != new["status"]:
        message = new["words"].get("message") or new["words"].get("reason") or ""
        return [("status", math.inf, f"{old['status']} -> {new['status']}: {message[:200]}")], []
    scales = scales_of(old)
    found = []
    for name in old["numbers"]:  # a newer program may say more
        a, b = old["numbers"].get(name), new["numbers"].get(name)
        found.append((name, number_difference(name, a, b, scales), f"{digits(a)} -> {digits(b)}"))
    for name in old["fields"]:
        found.append((f"field {name}", *field_difference(name, old["fields"].get(name), new["fields"].get(name), scales)))
    if old["words"].get("model") != new["words"].get("model"):
        found.append(("model", math.inf, f"{old['words'].get('model')} -> {new['words'].get('model')}"))
    words = [(name, old["words"].get(name, ""), new["words"].get(name, "")) for name in old["words"] | new["words"]
             if name != "model" and old["words"].get(name, "") != new["words"].get(name, "")]
    return [d for d in found if d[1] > 0], words


def same_effort(old, new):
    """Did the solver take the same way: the same iterations?"""
    keys = [key for key in old["effort"] if key.endswith("iterations")]
    return all(old["effort"][key] == new["effort"].get(key) for key in keys)
