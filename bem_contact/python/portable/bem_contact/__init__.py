"""Conformal wheel-rail contact without a compiler: the portable program and its library in one package, for any Python from 3.9 on.

    import bem_contact
    r = bem_contact.solve("scene.toml", {"position.lateral": 6.6})
    r.certified, r.pmax, r["quantities/pmax_error"], r["patches/0/Fn"], r.warnings
    contact = bem_contact.Contact("scene.toml")              # many cases of one scene: each starts from the one before
    pressures = [contact.solve({"position.lateral": y}).pmax for y in (6.4, 6.5, 6.6)]
    c = bem_contact.compare("data/scenes/conformal_small.toml")     # a dict: what `bem_contact compare --json` prints
    columns = bem_contact.sweep("scene.toml")                       # a dict of lists, one number for each case

The package that is built from the sources (bem_contact/python) has more: arrays, tables, pictures, executors. What is here has the same
names there. Errors are InputError (change the scene), ConvergenceError, or RuntimeError.
"""

import csv
import ctypes
import json
import math
import os
import subprocess
import sys
import tempfile
from pathlib import Path

__all__ = ["Contact", "InputError", "ConvergenceError", "Result", "compare", "conicity", "main", "program_file", "report", "run", "solve",
           "sweep", "table", "wear"]

_FOLDER = Path(__file__).resolve().parent
_WINDOWS = os.name == "nt"
_OK, _WRONG_INPUT, _NOT_CONVERGED = 0, 2, 3  # of conformal_contact.h; the program's exit codes are the same


class InputError(ValueError):
    """The scene or a file is wrong."""


class ConvergenceError(RuntimeError):
    """No certified result was found."""


def _fail(code, message):
    raise {_WRONG_INPUT: InputError, _NOT_CONVERGED: ConvergenceError}.get(code, RuntimeError)(message)


def _library():
    library = ctypes.CDLL(str(_FOLDER / ("conformal_contact.dll" if _WINDOWS else "libconformal_contact.so")))
    library.conformal_message.restype = library.conformal_version.restype = ctypes.c_char_p
    return library


_c = _library()
__version__ = _c.conformal_version().decode()


class Result:
    """The numbers of one solution, by their paths in `bem_contact solve --json`; what is in "quantities" is an attribute, too."""

    def __init__(self, contact, code):
        self._contact, self._code = contact, code
        self.warnings = contact._warnings()

    def __getitem__(self, path):
        if self is not self._contact._last:
            raise InputError("This result is gone (its Contact has solved another case) take its numbers before the next solution")
        return self._contact._number(path)

    def __getattr__(self, name):
        if name.startswith("_"):
            raise AttributeError(name)
        try:
            return self["quantities/" + name]
        except InputError as error:
            raise AttributeError(str(error)) from None

    @property
    def certified(self):
        return self["certified"] == 1

    def __repr__(self):
        return f"<bem_contact.Result certified={self.certified} pmax={self.pmax:.6g} MPa>"


class Contact:
    """A scene that is solved again and again. `scene`: the path of a TOML file."""

    def __init__(self, scene):
        self._handle, self._keys, self._last = ctypes.c_void_p(), {}, None
        message = ctypes.create_string_buffer(4000)
        code = _c.conformal_open_file(str(scene).encode(), ctypes.byref(self._handle), message, len(message))
        if code != _OK:
            _fail(code, message.value.decode())

    def __del__(self):
        if self._handle:
            _c.conformal_close(self._handle)
            self._handle = None

    def _check(self, code):
        if code != _OK:
            _fail(code, _c.conformal_message(self._handle).decode())

    def _number(self, path):
        value = ctypes.c_double()
        self._check(_c.conformal_number(self._handle, path.encode(), ctypes.byref(value)))
        return value.value

    def _warnings(self):
        count, text = ctypes.c_int(), ctypes.c_char_p()
        self._check(_c.conformal_warning_count(self._handle, ctypes.byref(count)))
        out = []
        for index in range(count.value):
            self._check(_c.conformal_warning(self._handle, index, ctypes.byref(text)))
            out.append(text.value.decode())
        return out

    def set(self, name, value):
        """Gives a key such as "load.force" another value: a number, a flag, a list of numbers or a text."""
        if name not in self._keys:
            key = ctypes.c_int()
            self._check(_c.conformal_key(self._handle, name.encode(), ctypes.byref(key)))
            self._keys[name] = key.value
        key = self._keys[name]
        if isinstance(value, (str, os.PathLike)):
            code = _c.conformal_set_text(self._handle, key, str(value).encode())
        elif isinstance(value, (int, float)):
            code = _c.conformal_set_number(self._handle, key, ctypes.c_double(value))
        else:
            numbers = [float(one) for one in value]
            code = _c.conformal_set_numbers(self._handle, key, (ctypes.c_double * len(numbers))(*numbers), len(numbers))
        self._check(code)

    def solve(self, changes=None):
        for name, value in (changes or {}).items():
            self.set(name, value)
        self._check(_c.conformal_solve(self._handle))
        self._last = Result(self, _OK)
        return self._last


def solve(scene, changes=None, model=None):
    """Solves one case; `changes`: {key: value}."""
    return Contact(scene).solve({**(changes or {}), **({"solver.model": model} if model else {})})


def program_file():
    """The program that the functions below run."""
    return str(_FOLDER / "bin" / ("bem_contact.exe" if _WINDOWS else "bem_contact"))


def run(*words):
    """Runs `bem_contact WORDS ... --json` and returns what it prints as a dict."""
    return json.loads(_run(*words, "--json"))


def _run(*words):
    done = subprocess.run([program_file(), *map(str, words)], capture_output=True, text=True, encoding="utf-8")
    if done.returncode not in (_OK, _NOT_CONVERGED) or (done.returncode == _NOT_CONVERGED and not done.stdout.strip()):
        _fail(done.returncode, done.stderr.strip())
    return done.stdout


def _output(file):
    return ["-o", file] if file else []


def compare(scene, output=None):
    """Several models at equal forces first. `output`: a result file (HDF5), for report()."""
    return run("compare", scene, *_output(output))


def conicity(*words, output=None):
    """The command's words: conicity("--wheel", "S1002", "--rail", "60E1")."""
    return run("conicity", *words, *_output(output))


def table(scene, output, *words):
    return run("table", scene, "-o", output, *words)


def wear(scene, output, *words):
    """`output`: a folder for the profiles, of one contact a result file."""
    return run("wear", scene, "-o", output, *words)


def report(file, output):
    """The page (HTML) of what another command wrote."""
    _run("report", file, "-o", output)


def sweep(scene, output=None, jobs=0):
    """The cases of the table [sweep] as columns; nan where there is no number, texts as texts."""
    with tempfile.TemporaryDirectory() as folder:
        lines = Path(folder) / "sweep.csv"
        _run("sweep", scene, "-o", output or Path(folder) / "sweep.h5", "--csv", lines, "--jobs", jobs)
        with open(lines, newline="", encoding="utf-8") as file:
            rows = list(csv.reader(line for line in file if not line.startswith("#")))
    return {name: [_value(row[i]) for row in rows[1:]] for i, name in enumerate(rows[0])}


def _value(text):
    try:
        return float(text) if text else math.nan
    except ValueError:
        return text


def main():
    """The command bem_contact."""
    sys.stdout.flush()
    words = [program_file(), *sys.argv[1:]]
    if _WINDOWS:  # which cannot become another program
        return subprocess.run(words).returncode
    os.execv(words[0], words)
