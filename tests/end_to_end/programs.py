"""Calls the programs as a user does: body file -> mesh -> influence functions -> contact."""

import json
import os
import subprocess
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
BIN = Path(os.environ.get("CONFORMAL_BIN", ROOT / "build" / "bin"))


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
