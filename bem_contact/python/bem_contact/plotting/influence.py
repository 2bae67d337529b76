"""An influence file: where its strip lies, and how its surface moves, beside a half-space."""

import subprocess
import tempfile
from pathlib import Path

import h5py
import numpy as np

from ..program import program_file
from . import style
from .kinds import text
from .refusals import InputError, refuse

NORMAL = 2  # component
LOADED = (0.1, 0.5, 0.9)  # of the strip: elements under load


def numbers_of(file, width, rows):
    """A_nn of neighbours along x = 0, by row and loaded row: the program expands the file."""
    program = program_file()
    if program is None:
        refuse(f"'{file}' cannot be drawn", "the program bem_contact was not found", "Put it on the PATH, or its folder into CONFORMAL_BIN.")
    with tempfile.TemporaryDirectory() as folder:
        output = Path(folder) / "numbers.h5"
        asked = ["--dx", repr(width), "--ds", repr(width), "--mx", "1", "--my", str(rows)]
        done = subprocess.run([program, "influence", "expand", file, *asked, "-o", output], capture_output=True, text=True, errors="replace")
        if done.returncode != 0:
            raise InputError(done.stderr.strip().removeprefix("error: "))
        with h5py.File(output) as numbers:
            return numbers["influence_numbers"][0, :, NORMAL, :, NORMAL]


def on_half_space(distance, width, shear, poisson):
    """The same mean normal displacement of squares at these distances from the loaded one, mm (Love 1929)."""
    half, inside = width / 2, width * ((np.arange(8) + 0.5) / 8 - 0.5)
    x, y = inside[:, None], np.asarray(distance)[:, None, None] + inside

    def corner(x, y):
        return x * np.arcsinh(y / np.abs(x)) + y * np.arcsinh(x / np.abs(y))

    whole = corner(x + half, y + half) - corner(x - half, y + half) - corner(x + half, y - half) + corner(x - half, y - half)
    return (1 - poisson) / (2 * np.pi * shear) * whole.mean(axis=(1, 2))


def draw(files):
    with h5py.File(files[0]) as file:
        named = {name: text(value) for name, value in file.attrs.items()}
        stations, width = file["stations"][:], float(file.attrs["station_width"])
        shear, poisson, error = (float(file.attrs[name]) for name in ("shear_modulus", "poisson", "estimated_error"))
    rows = len(stations)
    moves = numbers_of(files[0], width, rows)
    s, y, z = stations[:, 0], stations[:, 1], stations[:, 2]
    figure, axes = style.panels(1, 2, (12, 5.2))
    strip, answer = axes[0]
    strip.plot(y, z, "-o", color=style.RAIL if named["invariance"] == "prismatic" else style.WHEEL, markersize=3,
               label=f"{rows} stations, {width:g} mm wide")
    strip.set(xlabel="y, mm", ylabel="z down, mm", aspect="equal", title=f"{named['body']}: the strip of {Path(files[0]).name}")
    strip.invert_yaxis()
    strip.legend()
    for share, dash in zip(LOADED, ("--", "-", "-.")):
        row = round(share * (rows - 1))
        answer.semilogy(s, 1e6 * np.abs(moves[:, row]), dash, color=style.INK, label=f"under pressure at s = {s[row]:.1f} mm")
    middle = round(LOADED[1] * (rows - 1))
    answer.semilogy(s, 1e6 * on_half_space(s - s[middle], width, shear, poisson), ":", color=style.DEEPEST_PRESSURE, label="the middle one on a half-space")
    stated = f"estimated error {100 * error:.2g} %" if error >= 0 else "error not estimated"
    answer.set(xlabel=style.UP if named["invariance"] == "prismatic" else "s along the wheel, mm", ylabel="normal displacement, nm per MPa",
               title=f"Elements of {width:g} x {width:g} mm, {stated}")
    style.legend_beside(answer, below=True, columns=2, fontsize=8.5)
    figure.suptitle("Held: " + named["held"].split(":")[0], x=0.01, ha="left", fontsize=10)
    return figure
