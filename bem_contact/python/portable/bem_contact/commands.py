"""What the program computes, as functions: each runs a command and returns what it prints with --json."""

import csv
import json
import logging
import math
import os
import subprocess
import tempfile
from pathlib import Path

from .errors import NOT_CONVERGED, Error, InputError, fail

_FOLDER = Path(__file__).resolve().parent
_log = logging.getLogger("bem_contact")


def program_file():
    """The program that the functions below run."""
    return str(_FOLDER / "bin" / ("bem_contact.exe" if os.name == "nt" else "bem_contact"))


def run(*words):
    """Runs `bem_contact WORDS ... --json` and returns what it prints as a dict."""
    code, out = _run([*words, "--json"])
    try:
        return json.loads(out)
    except ValueError:
        raise Error(f"bem_contact {words[0] if words else ''} printed no JSON (it ended with code {code}) Call it from a shell.") from None


def _run(words):
    """Exit code and output; warnings go to the logger bem_contact. Raises what the program says where it printed nothing."""
    with tempfile.TemporaryDirectory() as folder:
        told = Path(folder, "messages")  # base/message_file.hpp: a line is a kind, a tab and a text
        done = subprocess.run([program_file(), *map(str, words)], stdin=subprocess.DEVNULL, capture_output=True, encoding="utf-8",
                              errors="replace", env={**os.environ, "BEM_CONTACT_MESSAGES": str(told)})
        lines = told.read_text(encoding="utf-8", errors="replace").splitlines() if told.exists() else []
    messages = [line.split("\t", 1) for line in lines if "\t" in line]
    for kind, text in messages:
        if kind == "warning":
            _log.warning("%s", text)
    errors = [text for kind, text in messages if kind == "error"]
    if done.returncode != 0 and (done.returncode != NOT_CONVERGED or errors):
        fail(done.returncode, errors[-1] if errors else
             f"The program ended with code {done.returncode} ({done.stderr.strip() or 'it said nothing'}) Call it from a shell.")
    return done.returncode, done.stdout


def _words(positionals, options):
    """jobs=2 is --jobs=2, roll=True --roll, models=["halfspace", "fem"] the option twice; None and False are left out."""
    words = []
    for one in positionals:
        if hasattr(one, "items") or (isinstance(one, str) and "\n" in one) or not isinstance(one, (str, os.PathLike)):
            raise TypeError(f"The scene cannot be used (its type is {type(one).__name__}, and the program takes files) Give the path of a file; "
                            "solve() and Sequence take texts and dicts, too.")
        words.append(os.path.join(".", one) if os.fspath(one).startswith("-") else os.fspath(one))
    for name, value in options.items():
        option = "--" + name.replace("_", "-")
        if value is True:
            words.append(option)
        elif value is not None and value is not False:
            several = value if isinstance(value, (list, tuple)) else [value]
            words += [f"{option}={os.fspath(one) if isinstance(one, os.PathLike) else one}" for one in several]
    return words


def compare(scene, models=None, *, output=None, **options):
    """Several models at equal forces first. `output`: a result file (HDF5), for report()."""
    return run("compare", *_words([scene], {"models": models, "output": output, **options}))


def conicity(scene=None, *, output=None, **options):
    """Without a scene by options: conicity(wheel="S1002", rail="60E1", rail_inclination=0.025)."""
    return run("conicity", *_words([] if scene is None else [scene], {"output": output, **options}))


def table(scene=None, *, output, **options):
    """Forces to look up; `output`: the table (HDF5). table(creep_forces=True, output="creep.h5")."""
    return run("table", *_words([] if scene is None else [scene], {"output": output, **options}))


def wear(scene, depth=None, *, output=None, **options):
    """`output`: a folder for the profiles, which a scene with [sweep] needs; of one contact a result file."""
    return run("wear", *_words([scene], {"depth": depth, "output": output, **options}))


def report(file, output):
    """One page (HTML) of what another command wrote."""
    _run(["report", *_words([file], {"output": output})])


def explore(scene=None, **options):
    """A page in the browser that solves as one moves it, until Ctrl-C. explore("scene.toml", port=8000, no_browser=True)."""
    code = subprocess.call([program_file(), "explore", *_words([] if scene is None else [scene], options)])
    if code != 0:
        fail(code, f"explore ended with code {code} (see what it said above) Correct it.")


def sweep(scene, *, model=None, output=None, jobs=0, **options):
    """The cases of the table [sweep] as columns, lists; nan where there is no number. "patches": columns with a line for each patch.

    `output`: the file of all cases (HDF5), for report(); called again after a stop, what its parts have is not solved again.
    """
    with tempfile.TemporaryDirectory() as folder:
        lines = Path(folder, "sweep.csv")
        words = _words([scene], {"output": output or Path(folder, "sweep.h5"), "csv": lines, "model": model, "jobs": jobs, **options})
        _run(["sweep", *words])
        return {**_columns(lines), "patches": _columns(lines.with_name("sweep_patches.csv"))}


def _columns(file):
    with open(file, newline="", encoding="utf-8") as lines:
        rows = list(csv.reader(lines))
    return {name: _column([row[i] for row in rows[1:]]) for i, name in enumerate(rows[0])}


def _column(cells):
    try:
        return [float(cell) if cell else math.nan for cell in cells]
    except ValueError:
        return cells
