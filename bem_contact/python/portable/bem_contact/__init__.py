"""Conformal wheel-rail contact without a compiler: the portable program and its library in one package, for any Python from 3.9 on.

    import bem_contact
    r = bem_contact.solve("scene.toml", {"position.lateral": 6.6})
    r.certified, r.pmax, r.pmax_error, r["patches/0/Fn"], r.warnings
    sequence = bem_contact.Sequence("scene.toml")            # many cases of one scene: each starts from the one before
    pressures = [sequence.solve({"position.lateral": y}).pmax for y in (6.4, 6.5, 6.6)]
    c = bem_contact.compare("scene.toml", ["halfspace", "fem"])     # a dict: what `bem_contact compare --json` prints
    columns = bem_contact.sweep("scene.toml")                       # a dict of lists, one number for each case

    solve, Sequence                          a scene is the path of a file, the text of one, or a dict
    compare, sweep, table, conicity, wear    a scene is a file; options of the command by name: wear(scene, law="archard")
    report, explore                          pages
    run("fatigue", "scene.toml")             any other command that has --json
    python -m bem_contact WORDS ...          the program

The package that is built from the sources (bem_contact/python) has functions of these names, and more: NumPy arrays where here are lists and
what --json prints, changes= and dicts for all commands, derivatives, pictures, executors. Errors are the same: `Error`, of it `InputError` (a
ValueError, too) and `ConvergenceError` (a RuntimeError, too).
"""

import os
import subprocess
import sys

from .commands import compare, conicity, explore, program_file, report, run, sweep, table, wear
from .errors import ConvergenceError, Error, InputError
from .scenes import Result, Sequence, solve
from .scenes import version as __version__

__all__ = ["ConvergenceError", "Error", "InputError", "Result", "Sequence", "compare", "conicity", "explore", "main", "program_file", "report",
           "run", "solve", "sweep", "table", "wear"]


def main():
    """The command bem_contact."""
    sys.stdout.flush()
    words = [program_file(), *sys.argv[1:]]
    if os.name == "nt":  # which cannot become another program
        return subprocess.run(words).returncode
    os.execv(words[0], words)
