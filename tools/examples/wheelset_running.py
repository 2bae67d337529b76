#!/usr/bin/python3
"""One free wheelset on straight track; every wheel-rail force is a solution of bem_contact (README.md beside this file).

    PYTHONPATH=build/python tools/examples/wheelset_running.py              # klingel, critical and cost: a minute
    PYTHONPATH=build/python tools/examples/wheelset_running.py limit-cycle -o wheelset.png

klingel: a coned wheelset without springs follows a wave of Klingel's length. critical: with springs, small motions grow
above the critical speed of the linear theory. limit-cycle: S1002 on 60E1, below and above. cost: microseconds a step.
"""

import argparse
import sys
from pathlib import Path
from time import perf_counter

import numpy as np
from scipy.integrate import solve_ivp
from scipy.optimize import curve_fit

from linear_model import ConedPair, critical_speed, least_damped, matrix
from wheelset import Track, Wheelset

HERE = Path(__file__).resolve().parent
CONED, S1002 = HERE / "coned_wheelset.toml", HERE / "s1002_wheelset.toml"
SMALLEST = np.array([1e-4, 1e-7, 1e-3, 1e-5, 1e-4])  # mm, rad, mm/s, rad/s, rad/s: what the integrator may be off by


def run(track, start, duration):
    """The motion of the coned wheelset from (y, psi, y', psi') on; the linear theory's matrix guides the integrator."""
    wheelset, speed = track.wheelset, track.speed
    jacobian = np.zeros((5, 5))
    jacobian[:4, :4] = matrix(speed, wheelset)
    jacobian[4, 4] = jacobian[3, 3] * wheelset.yaw_inertia / wheelset.pitch_inertia * (wheelset.radius / 742.5) ** 2
    return solve_ivp(track, [0, duration], [*start, track.pitch_rate], method="LSODA", rtol=1e-5, atol=SMALLEST,
                     jac=lambda time, state: jacobian)


def growth(motion, guess):
    """Growth rate and angular frequency of y, 1/s, from half a period on: before, other motions die out."""
    def wave(time, cosine, sine, rate, frequency):
        return np.exp(rate * time) * (cosine * np.cos(frequency * time) + sine * np.sin(frequency * time))

    later = motion.t > np.pi / guess.imag
    fitted, _ = curve_fit(wave, motion.t[later], motion.y[0, later], [motion.y[0, 0], 0, guess.real, guess.imag])
    return fitted[2], fitted[3]


def klingel(speed=1e4, amplitude=0.5):
    """Wavelengths in mm: of the motion, and Klingel's."""
    wheelset = Wheelset(lateral_stiffness=0, yaw_stiffness=0)
    guess, start = least_damped(speed, wheelset)
    motion = run(Track(CONED, speed, wheelset), amplitude * start.real, 1.25 * 2 * np.pi / guess.imag)
    return 2 * np.pi * speed / growth(motion, guess)[1], ConedPair().klingel(wheelset)


def critical(amplitude=1.0, share=0.05):
    """Critical speeds in mm/s: where the growth of the motion vanishes between two speeds, and that of the linear theory."""
    expected = critical_speed()
    speeds, rates = np.array([1 - share, 1 + share]) * expected, []
    for speed in speeds:
        guess, start = least_damped(speed)
        motion = run(Track(CONED, speed), amplitude * start.real, 2 * 2 * np.pi / guess.imag)
        rates.append(growth(motion, guess)[0])
    return float(np.interp(0, rates, speeds)), expected


def limit_cycle(speed, duration, amplitude=4.0):
    """S1002 on 60E1: motion and the largest lateral force of a wheel on its rail at each time, N."""
    track = Track(S1002, speed, reach=6.0)
    motion = solve_ivp(track, [0, duration], [amplitude, 0, 0, 0, track.pitch_rate], method="RK23", rtol=1e-4,
                       atol=10 * SMALLEST)
    forces = []
    for state in motion.y.T:
        forces.append(max(abs(f.force[1]) for f in track.equilibrium(state)))
    return motion, np.array(forces)


def cost(duration=0.1):
    """Microseconds a solution and a time step: each solution from the one before, and each anew with all files read."""
    speed, lines = 6e4, []
    _, start = least_damped(speed)
    for warm in (True, False):
        track = Track(CONED, speed, warm=warm)
        for wheel in track.wheels:
            wheel.calls, wheel.seconds = 0, 0.0
        begin = perf_counter()
        motion = run(track, start.real, duration)
        each_step = (perf_counter() - begin) / (len(motion.t) - 1)
        calls, seconds = sum(w.calls for w in track.wheels), sum(w.seconds for w in track.wheels)
        lines.append((1e6 * seconds / calls, 1e6 * each_step, calls / (len(motion.t) - 1)))
    return lines


def report_klingel():
    found, expected = klingel()
    print(f"Klingel: the wave is {found / 1000:.2f} m long, {expected / 1000:.2f} m by the formula "
          f"({100 * (found / expected - 1):+.2f} %)", flush=True)


def report_critical():
    found, expected = critical()
    print(f"critical speed: {found / 1000:.2f} m/s, {expected / 1000:.2f} m/s by the linear theory "
          f"({100 * (found / expected - 1):+.2f} %)", flush=True)


def report_cost():
    for (solution, step, solutions), how in zip(cost(), ("each from the one before", "each anew, files read again")):
        print(f"cost, {how}: {solution:.0f} microseconds a solution, {step:.0f} a time step "
              f"({solutions:.1f} solutions)", flush=True)


def report_limit_cycle(picture):
    runs = []
    for speed, duration in ((25e3, 1.2), (40e3, 1.6)):
        motion, forces = limit_cycle(speed, duration)
        last = motion.t > 0.7 * duration
        print(f"S1002 on 60E1 at {speed / 1000:.0f} m/s: from 4 mm to {abs(motion.y[0, last]).max():.2f} mm, lateral force "
              f"up to {forces[last].max() / 1000:.1f} kN", flush=True)
        runs.append((speed, motion, forces))
    if picture:
        draw(runs, picture)


def draw(runs, picture):
    from bem_contact.plotting import style
    style.use()
    figure, ((lateral,), (force,)) = style.panels(2, 1, (9, 6.4), sharex=True)
    for (speed, motion, forces), dash in zip(runs, ("-", "--")):
        name = f"{speed / 1000:.0f} m/s"
        lateral.plot(motion.t, motion.y[0], dash, color=style.INK, label=name)
        force.plot(motion.t, forces / 1000, dash, color=style.FORCES["Fy"][0], label=name)
    lateral.set(ylabel="lateral displacement, mm", title="The wheelset")
    force.set(ylabel="|Fy| of a wheel, kN", xlabel="time, s", title="Largest lateral force of a wheel")
    for axis in (lateral, force):
        axis.legend(loc="upper left")
    style.save(figure, picture)


def main():
    reports = {"klingel": report_klingel, "critical": report_critical, "cost": report_cost, "limit-cycle": None}
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("parts", nargs="*", metavar="PART", help=", ".join(reports))
    parser.add_argument("-o", "--picture", help="of the limit cycle, such as wheelset.png")
    asked = parser.parse_args()
    for part in asked.parts or ["klingel", "critical", "cost"]:
        if part not in reports:
            parser.error(f"there is no part '{part}' (there are {', '.join(reports)})")
        report_limit_cycle(asked.picture) if part == "limit-cycle" else reports[part]()


if __name__ == "__main__":
    main()
