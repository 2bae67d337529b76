#!/usr/bin/python3
"""A bogie on straight track and in a curve of 300 m, with tables, the simplified theory and solutions (README.md beside this file).

    PYTHONPATH=build/python tools/examples/bogie_running.py -o FOLDER      # critical and curve: two minutes

critical: the critical speed of a bogie with coned wheels by the derivatives of its table, by motions that grow or die out, and by the
linear theory with Kalker's coefficients. curve: forces and T-gamma of the four wheels (S1002 on 60E1), and the run for `bem_contact
replay`. loop: the same curve with the simplified theory and with solutions, for a short time.
"""

import argparse
import csv
from pathlib import Path
from time import perf_counter

import numpy as np
from scipy.optimize import brentq, root

import bem_contact
from bogie import Bogie, Parameters, SolvedContact, TableContact, coned_parameters
from linear_model import matrix
from wheelset import Wheelset

HERE = Path(__file__).resolve().parent
CONED, S1002 = HERE / "coned_bogie.toml", HERE / "s1002_bogie.toml"


def contact(scene, folder, tolerance):
    """The table of a scene; a file of `folder` is taken again."""
    file = Path(folder) / f"{scene.stem}.h5"
    if not file.exists():
        bem_contact.table(scene, tolerance=tolerance, output=file)
    return TableContact(bem_contact.read_table(file))


def linear_theory(speed, parameters):
    """The matrix with Kalker's coefficients in place of the table; the wheelsets do not turn faster than they roll. [12][12]"""
    p = parameters
    bogie = Bogie(None, speed, p)
    out = bogie.matrix[:12, :12].copy()
    of_wheels = matrix(speed, Wheelset(mass=p.wheelset_mass, yaw_inertia=p.wheelset_yaw, weight=p.weight, lateral_stiffness=0,
                                       yaw_stiffness=0))
    for axle in range(2):
        places = [2 * axle, 2 * axle + 1, 6 + 2 * axle, 7 + 2 * axle]
        out[np.ix_(places[2:], places)] += of_wheels[2:]
        out[6 + 2 * axle, 2 * axle] += p.weight * p.roll / p.wheelset_mass  # `matrix` has the turning normals too
    return out


def least_damped(system):
    """The eigenvalue with the largest real part, 1/s, and its motion."""
    values, motions = np.linalg.eig(system)
    k = int(np.argmax(values.real + 1e-9 * values.imag))
    return values[k], motions[:, k]


def critical_speed(system_at, low=2e4, high=2e5):
    """mm/s, above which small motions grow."""
    return brentq(lambda speed: least_damped(system_at(speed))[0].real, low, high, xtol=1.0)


def at_rest(contact, speed, parameters=Parameters(), curve=np.inf, guess=None):
    """The bogie and its motion that does not change: in the middle of the track, or as it runs through the curve."""
    bogie = Bogie(contact, speed, parameters, curve)
    rates = slice(6, 12)
    free = np.r_[0:6, 12:14]  # the rates are zero there

    def missing(x):
        state = np.zeros(14)
        state[free] = x
        return bogie(0, state)[np.r_[rates, 12:14]]

    def slopes(x):
        state = np.zeros(14)
        state[free] = x
        return bogie.jacobian(0, state)[np.ix_(np.r_[rates, 12:14], free)]

    found = root(missing, np.zeros(8) if guess is None else guess[free], jac=slopes, method="hybr", options={"xtol": 1e-10})
    state = np.zeros(14)
    state[free] = found.x
    return bogie, state


def growth(bogie, rest, amplitude, periods=3):
    """Growth rate of the least damped motion, 1/s: by its size, period by period. `rest`: the state that it is a motion about."""
    value, motion = least_damped(bogie.jacobian(0, rest))
    period = 2 * np.pi / abs(value.imag)
    times = np.arange(periods + 1) * period
    run = bogie.run(rest + amplitude * (motion / motion[0]).real, times[-1], t_eval=np.linspace(0, times[-1], 64 * periods + 1))
    sizes = [np.abs(run.y[0, 64 * k:64 * (k + 1)]).max() for k in range(periods)]
    return np.log(sizes[-1] / sizes[0]) / ((periods - 1) * period)


def report_critical(folder):
    parameters = coned_parameters()
    wheel = contact(CONED, folder, 0.1)
    expected = critical_speed(lambda speed: linear_theory(speed, parameters))

    def system(speed):
        bogie, rest = at_rest(wheel, speed, parameters)
        return bogie.jacobian(0, rest)

    found = critical_speed(system)
    print(f"critical speed: {found / 1000:.2f} m/s by the derivatives of the table, {expected / 1000:.2f} m/s by the linear theory "
          f"({100 * (found / expected - 1):+.2f} %)", flush=True)
    speeds = np.array([0.95, 1.05]) * expected
    rates = [growth(*at_rest(wheel, speed, parameters), 0.02) for speed in speeds]
    motion = float(np.interp(0, rates, speeds))
    print(f"critical speed: {motion / 1000:.2f} m/s by motions of 0.02 mm that die out or grow "
          f"({100 * (motion / expected - 1):+.2f} %)", flush=True)


def through_the_curve(wheel, radius=3e5, speed=20e3, seconds=4.0, transition=1.5):
    """From straight track into the curve, whose curvature grows evenly for `transition` seconds. Times and states, [n][14]."""
    bogie = Bogie(wheel, speed)
    times, states, state = [0.0], [np.zeros(14)], np.zeros(14)
    steps = 30
    for k in range(steps + 1):  # the curvature in steps: each is small
        share = min(1.0, (k + 1) / steps)
        bogie = Bogie(wheel, speed, curve=radius / share)
        duration = transition / steps if k < steps else seconds - transition
        run = bogie.run(state, duration, rtol=1e-5, atol=1e-6, max_step=0.02)
        times += list(times[-1] + run.t[1:])
        states += list(run.y.T[1:])
        state = run.y[:, -1]
    return bogie, np.array(times), np.array(states)


def of_wheels(bogie, state):
    """Fx, Fy (N) and T-gamma (N) of each wheel, with their stated errors in the table."""
    table, out = bogie.contact.table, {}
    for name, inputs in zip(bogie.names, bogie.inputs(state)):
        found = table.force(list(inputs), ["Fx", "Fy", "T_gamma"])
        side = 1 if name.endswith("R") else -1
        v, e = found["values"], found["errors"]
        out[name] = {"Fx": v["Fx"], "Fy": side * v["Fy"], "T_gamma": v["T_gamma"], "inputs": inputs,
                     "errors": [e[c] for c in ("Fx", "Fy", "T_gamma")]}
    return out


def write_run(file, bogie, times, states):
    """The run as `bem_contact replay` reads it."""
    with open(file, "w", newline="") as out:
        writer = csv.writer(out)
        writer.writerow(["t", *(f"{what}_{name}" for name in bogie.names for what in ("y", "psi", "xi", "Fx", "Fy"))])
        for time, state in zip(times, states):
            row = [f"{time:.6f}"]
            for name, wheel in of_wheels(bogie, state).items():
                side = 1 if name.endswith("R") else -1
                y, yaw, xi = wheel["inputs"]
                row += [f"{number:.9g}" for number in (side * y, side * yaw, xi, wheel["Fx"], wheel["Fy"])]
            writer.writerow(row)


REPLAY = """
[replay.columns] # key of the scene = column of the run
time = "t"
position.lateral = "y_{wheel}"
position.yaw = "psi_{wheel}"
motion.xi = "xi_{wheel}"

[replay.compare] # quantity of a result = the run's own
Fx = "Fx_{wheel}"
Fy = "Fy_{wheel}"

[replay.wheels] # what {wheel} is, and on which side
1R = "right"
1L = "left"
2R = "right"
2L = "left"
"""


def report_curve(folder):
    wheel = contact(S1002, folder, 0.05)
    begin = perf_counter()
    bogie, times, states = through_the_curve(wheel)
    print(f"curve of 300 m at 20 m/s: {times[-1]:.1f} s in {perf_counter() - begin:.1f} s, {wheel.calls} look-ups", flush=True)
    for name, found in of_wheels(bogie, states[-1]).items():
        fx, fy, power = found["errors"]
        print(f"  {name}: Fx {found['Fx'] / 1000:6.2f} +- {fx / 1000:.2f} kN, Fy {found['Fy'] / 1000:6.2f} +- {fy / 1000:.2f} kN, "
              f"T-gamma {found['T_gamma']:5.0f} +- {power:.0f} N", flush=True)
    write_run(Path(folder) / "run.csv", bogie, times, states)
    scene = S1002.read_text().split("[table]")[0]
    (Path(folder) / "replay.toml").write_text(scene + REPLAY)
    print(f"now: bem_contact replay {folder}/run.csv {folder}/replay.toml --wheel 1L -o {folder}/replay.h5", flush=True)


def report_loop(folder, seconds=0.05):
    """Each contact from the same state on: the middle of the transition, where the flange comes to the rail."""
    wheel = contact(S1002, folder, 0.05)
    _, times, states = through_the_curve(wheel, seconds=1.6)
    k = int(np.searchsorted(times, 0.75))
    guide, last = Bogie(wheel, 20e3, curve=6e5), {}
    for name, model in (("table", wheel), ("simplified theory", SolvedContact(S1002, "simplified")),
                        ("solutions", SolvedContact(S1002))):
        model.calls, begin = 0, perf_counter()
        run = Bogie(model, 20e3, curve=6e5).run(states[k], seconds, jacobian=guide.jacobian, rtol=1e-4, atol=1e-5)
        last[name] = run.y[:, -1]
        print(f"{name}: {model.calls} calls, {1e6 * (perf_counter() - begin) / max(model.calls, 1):.0f} microseconds each; the first "
              f"wheelset is at {run.y[0, -1]:.3f} mm, {1e3 * run.y[1, -1]:.3f} mrad", flush=True)
    return last


def main():
    reports = {"critical": report_critical, "curve": report_curve, "loop": report_loop}
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("parts", nargs="*", metavar="PART", help=", ".join(reports))
    parser.add_argument("-o", "--folder", default=".", help="for tables and runs")
    asked = parser.parse_args()
    Path(asked.folder).mkdir(parents=True, exist_ok=True)
    for part in asked.parts or ["critical", "curve"]:
        if part not in reports:
            parser.error(f"there is no part '{part}' (there are {', '.join(reports)})")
        reports[part](asked.folder)


if __name__ == "__main__":
    main()
