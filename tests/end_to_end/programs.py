"""Calls the programs as a user does: body file -> mesh -> influence functions -> contact."""

import json
import os
import subprocess
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
BIN = Path(os.environ.get("CONFORMAL_BIN", ROOT / "build" / "bin"))
# A body file whose influence functions take a second.
SMALL_BLOCK = """[body]
kind = "block"
size = 40.0
[strip]
from = -2.0
to = 2.0
station_width = 0.5
[harmonic]
degree = 2
border_levels = 1
half_period = 120.0
shortest_dx = 0.5
"""


def influence(body, out):
    """Makes the influence file `out` of a body file, or of data/bodies/<body>.toml."""
    file = body if isinstance(body, Path) else ROOT / "data" / "bodies" / f"{body}.toml"
    subprocess.run([ROOT / "tools" / "influence", file, out],
                   env=os.environ | {"CONFORMAL_BIN": str(BIN)}, check=True)


def solve(scene, *options):
    """The JSON object of one scene; raises where the exit code is not 0."""
    done = subprocess.run([BIN / "bem_contact", "solve", scene, "--json", *options],
                          check=True, stdout=subprocess.PIPE, text=True)
    return json.loads(done.stdout)
