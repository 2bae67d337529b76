"""Two contacts of one wheel and one rail: where they begin and end as the wheelset moves sideways.

`two_point_position` finds the lateral displacement y* at which the undeformed bodies touch in two points. `read` reads a
sweep over the lateral displacement. The two readings of "two contacts" part the contact at an inclination between those of
the two touches. For a second contact on the flange (70 degrees) that is FLANGE.
- `both_loaded`: each side carries 1 % of the normal force or more;
- `both_touched`: each side has at least one element in contact, however little it carries.
"""

import re
import subprocess
import sys

import h5py
import numpy as np

VALLEY = 0.05  # of pmax: two maxima that a shallower valley parts are one
FLANGE = 50  # degrees: between the touch on the gauge corner (17 to 41) and that on the flange (70)
FLANGE_SEARCH = (6.3, 7.5)  # mm: where the standard pairs run up to the flange in a gauge of 1435 mm
SHARE = 0.01  # of the normal force: less is not carried


def run(program, *arguments):
    done = subprocess.run([program, *map(str, arguments)], stdout=subprocess.PIPE, text=True)
    if done.returncode not in (0, 3):
        sys.exit(done.returncode)
    return done.stdout


def first_touch(program, scene, folder, lateral):
    """Arc length on the rail, mm, and inclination there, degrees, where the undeformed bodies touch first."""
    file = folder / "look.toml"
    file.write_text(scene + f"position.lateral = {lateral}\n")
    text = run(program, "check", file)
    file.unlink()
    found = re.search(r"touch point: rail s = (\S+) mm.*?inclination (\S+) degrees", text)
    return float(found[1]), float(found[2])


def two_point_position(program, scene, folder, search=FLANGE_SEARCH):
    """y*, where the first touch jumps, and the inclinations of both touches. `search` has one such jump in it."""
    low, high = search
    inner, outer = (first_touch(program, scene, folder, y)[0] for y in search)
    while high - low > 1e-4:
        middle = 0.5 * (low + high)
        s = first_touch(program, scene, folder, middle)[0]
        if abs(s - inner) < abs(s - outer):
            low = middle
        else:
            high = middle
    return 0.5 * (low + high), [first_touch(program, scene, folder, y)[1] for y in (low, high)]


def maxima(pressure):
    """How many maxima of the rows' largest pressures are parted by a valley."""
    rows = pressure.max(axis=1)
    depth, count, top, bottom = VALLEY * rows.max(), 0, 0.0, 0.0
    climbing = True
    for p in np.append(rows, 0.0):
        if climbing:
            top = max(top, p)
            if p < top - depth:
                count, climbing, bottom = count + 1, False, p
        else:
            bottom = min(bottom, p)
            if p > bottom + depth:
                climbing, top = True, p
    return count


def read(file, model, border=FLANGE):
    """The cases of a sweep; `border` (degrees) parts the two contacts."""
    cases = []
    with h5py.File(file) as f:
        for i, lateral in enumerate(f["position.lateral"][:]):
            name = f"cases/{i:06}"
            case = {"lateral": lateral, "status": int(f["status"][i]), "reason": "", "cpu": f["cpu_seconds"][i]}
            if name in f:
                case["reason"] = np.bytes_(f[name].attrs.get("reason", b"")).decode()
            if case["status"] in (1, 2) and f"{name}/p_n" in f:
                g = f[name]
                pressure, delta = g["p_n"][:], g["delta"][:]
                dx, ds = (g["quantities"][size][()] for size in ("dx", "ds"))
                flange = delta < -np.radians(border)
                case |= {"x": g["x"][:], "s": g["s"][:], "state": g["state"][:], "dx": dx, "ds": ds,
                         "tread": pressure[~flange].sum() * dx * ds, "flange": pressure[flange].sum() * dx * ds,
                         "patches": int(f["patch_count"][i]), "maxima": maxima(pressure),
                         "pmax": pressure.max(), "Fx": f["Fx"][i], "Fy": f["Fy"][i]}
            cases.append(case)
    return cases


def two_maxima(case):
    return max(case["patches"], case["maxima"]) > 1


def two_patches(case):
    return case["patches"] > 1


def both_loaded(case):
    return min(case["tread"], case["flange"]) > SHARE * (case["tread"] + case["flange"])


def both_touched(case):
    return min(case["tread"], case["flange"]) > 0


def band(cases, test):
    both = [c["lateral"] for c in cases if "patches" in c and test(c)]
    return (min(both), max(both)) if both else None


def say(found, y_star):
    return f"from y* {found[0] - y_star:+.2f} to y* {found[1] - y_star:+.2f} mm" if found else "nowhere"
