"""Scenes that are solved by the library: conformal_contact.h through ctypes."""

import ctypes
import difflib
import json
import os
import re
import threading
from array import array
from numbers import Real
from pathlib import Path

from .errors import NOT_CONVERGED, InputError, fail

_FOLDER = Path(__file__).resolve().parent
_OK = 0
_ARRAYS = {"x": "mm", "s": "mm", "y": "mm", "z": "mm", "delta": "rad", "p_x": "MPa", "p_s": "MPa", "p_n": "MPa", "slip_x": "", "slip_s": "",
           "u_x": "mm", "u_s": "mm", "u_n": "mm", "gap": "mm", "deformed_distance": "mm", "state": "1"}  # as conformal_contact.h has them
_ROWS = 5  # so many of them have one number for each column or row of elements


def _library():
    library = ctypes.CDLL(str(_FOLDER / ("conformal_contact.dll" if os.name == "nt" else "libconformal_contact.so")))
    library.conformal_message.restype = library.conformal_version.restype = ctypes.c_char_p
    return library


_c = _library()
version = _c.conformal_version().decode()


def _bytes(text, what):
    if "\0" in text:
        raise InputError(f"The text of {what} cannot be used (it holds a zero byte) Give it without.")
    try:
        return text.encode()
    except UnicodeEncodeError:
        raise InputError(f"The text of {what} cannot be used (it is no UTF-8: it holds half a character, as the name of a file does that "
                         "is none) Give the file a name in UTF-8.") from None


def _plain(value):
    """Without NumPy: numbers, texts, lists."""
    value = value.tolist() if hasattr(value, "tolist") else value
    return str(value) if isinstance(value, os.PathLike) else value


def _type_error(what, value, advice):
    return TypeError(f"{what} cannot be used (its type is {type(value).__name__}) {advice}")


def _toml(value, name):
    """A value as TOML has it; tables stand in braces."""
    value = _plain(value)
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, Real):
        return repr(value if isinstance(value, int) else float(value))
    if isinstance(value, str):
        return json.dumps(value, ensure_ascii=False).replace("\x7f", "\\u007f")
    if hasattr(value, "items"):
        return "{ " + ", ".join(f"{key} = {one}" for key, one in _entries(value, name, False)) + " }"
    if isinstance(value, (list, tuple)):
        return "[" + ", ".join(_toml(one, name) for one in value) + "]"
    raise _type_error(f"The value of {name}", value, "Give a number, text, True, False, or a list of numbers.")


def _entries(table, name, flat=True):
    for key, value in table.items():
        if not isinstance(key, str):
            raise TypeError(f"The scene cannot be used (one of its keys is of type {type(key).__name__}) Name the keys of a scene, as "
                            "{'position.lateral': 6.6}.")
        path = f"{name}.{key}" if name else key
        if flat and hasattr(value, "items"):
            yield from _entries(value, path)
        else:
            yield (path if flat else key), _toml(value, path) if re.fullmatch(r"[\w.-]+", key) else _refuse_key(path)


def _refuse_key(path):
    raise InputError(f"unknown key '{path}' (a scene has no such key) Name the keys of a scene, as position.lateral.")


def _text_of(table):
    return "".join(f"{path} = {value}\n" for path, value in _entries(table, ""))


def _flat(changes, name=""):
    if changes is None:
        return
    if not hasattr(changes, "items"):
        raise _type_error("The value of changes", changes, "Give a dict, as {'position.lateral': 6.6}.")
    for key, value in changes.items():
        if not isinstance(key, str):
            raise TypeError(f"The changes cannot be used (one of their keys is of type {type(key).__name__}) Name the keys of a scene, as "
                            "{'position.lateral': 6.6}.")
        if hasattr(value, "items"):
            yield from _flat(value, f"{name}{key}.")
        else:
            yield name + key, value


class Result:
    """One solution. What is in `bem_contact solve --json` is had by its path, r["patches/0/Fn"], or as an attribute: r.pmax, r.pmax_error,
    r.patches, r.units, r.warnings, r.found. Fields are lists: r.p_n[row][column] (MPa), r.x (mm) ... None stands for what is not known.
    """

    def __init__(self, record, arrays):
        self._record, self._arrays = record, arrays
        if "units" in record:  # slip has that of creepage: a shift is a length
            record["units"] |= {name: unit or record["units"]["xi"] for name, unit in _ARRAYS.items()}

    def __getitem__(self, path):
        if path in self._arrays:
            return self._lists(path)
        at = self._record
        for part in path.split("/"):
            if isinstance(at, dict) and part in at:
                at = at[part]
            elif isinstance(at, list) and part.isdecimal() and int(part) < len(at):
                at = at[int(part)]
            else:
                like = difflib.get_close_matches(path, list(_paths(self._record)) + list(self._arrays), cutoff=0.5)
                raise KeyError(f"There is no path '{path}' (the result has nothing there) " +
                               (f"Did you mean {' or '.join(like)}?" if like else "See bem_contact solve --json for all of them."))
        return at

    def _lists(self, name):
        values, rows = self._arrays[name]
        numbers = list(map(int, values)) if name == "state" else list(values)
        mx = len(numbers) // rows
        return numbers if rows == 1 else [numbers[row * mx:(row + 1) * mx] for row in range(rows)]

    def __getattr__(self, name):
        if not name.startswith("_"):
            if name == "seconds":
                return self._record["seconds"]["total"]
            if name in ("approach_datum", "track", "why_not_certified", "why_no_errors"):
                return self._record[name] or ""
            if name in self._arrays:
                return self._lists(name)
            for part in (self._record["quantities"], self._record):
                if name in part:
                    return part[name]
        raise AttributeError(f"'bem_contact.Result' object has no attribute '{name}' (save(), plot() and derivatives have the package "
                             "alone that is built from the sources)")

    def __dir__(self):
        return [*super().__dir__(), *self._arrays, *self._record["quantities"], *self._record]

    def __repr__(self):
        return (f"<bem_contact.Result: {self.model}, Fz {self.Fz:.6g} N, {len(self.patches)} patches, "
                f"{'certified' if self.certified else 'NOT certified'}>")


def _paths(record, before=""):
    for key, value in record.items() if isinstance(record, dict) else enumerate(record):
        yield f"{before}{key}"
        if isinstance(value, (dict, list)):
            yield from _paths(value, f"{before}{key}/")


class Sequence:
    """Many cases of one scene: each starts from the one before. `scene`: the path of a file, the text of one, or a dict; relative paths
    start in `folder`, else in the file's folder, else in the working directory."""

    def __init__(self, scene, *, folder=None):
        self._handle, self._keys, self._busy, self._given = ctypes.c_void_p(), {}, threading.Lock(), (scene, folder)
        message = ctypes.create_string_buffer(4000)
        rest = (ctypes.byref(self._handle), message, len(message))
        if not hasattr(scene, "items") and not isinstance(scene, (str, os.PathLike)):
            raise _type_error("The scene", scene, "Give the path of a scene file, its text, or a dict.")
        if hasattr(scene, "items") or (isinstance(scene, str) and "\n" in scene):
            text = _text_of(scene) if hasattr(scene, "items") else scene
            code = _c.conformal_open_text(_bytes(text, "scene"), _bytes(os.fspath(folder or "."), "folder"), *rest)
        elif folder is None:
            code = _c.conformal_open_file(_bytes(os.fspath(scene), "scene"), *rest)
        else:
            code = _c.conformal_open_text(_scene_file_text(scene), _bytes(os.fspath(folder or "."), "folder"), *rest)
        if code != _OK:
            fail(code, message.value.decode())

    def __reduce__(self):  # a copy in another process starts cold
        return _again, self._given

    def __del__(self):
        if getattr(self, "_handle", None):
            _c.conformal_close(self._handle)
            self._handle = None

    def _check(self, code):
        if code != _OK:
            fail(code, _c.conformal_message(self._handle).decode())

    def _set(self, name, value):
        if name not in self._keys:
            key = ctypes.c_int()
            self._check(_c.conformal_key(self._handle, _bytes(name, "a key"), ctypes.byref(key)))
            self._keys[name] = key
        value, to = _plain(value), (self._handle, self._keys[name])
        if isinstance(value, (list, tuple)) and value and all(isinstance(one, str) for one in value):
            value = ", ".join(value)
        if isinstance(value, bool):
            code = _c.conformal_set_flag(*to, value)
        elif isinstance(value, str):
            code = _c.conformal_set_text(*to, _bytes(value, name))
        elif isinstance(value, Real):
            code = _c.conformal_set_number(*to, ctypes.c_double(value))
        elif isinstance(value, (list, tuple)) and all(isinstance(one, Real) and not isinstance(one, bool) for one in value):
            code = _c.conformal_set_numbers(*to, (ctypes.c_double * len(value))(*value), len(value))
        else:
            raise _type_error(f"The value of {name}", value, "Give a number, text, True, False, or a list of numbers.")
        self._check(code)

    def solve(self, changes=None, model=None, strict=False):
        """Solves the scene with these changes, {key: value}, of this case alone. `strict`: warnings are errors."""
        with self._busy:
            self._check(_c.conformal_reset(self._handle))
            for name, value in [*_flat(changes), *([("solver.model", model)] if model else [])]:
                self._set(name, value)
            code = _c.conformal_solve(self._handle)
            said = _c.conformal_message(self._handle).decode()
            text = ctypes.c_char_p()
            if code == NOT_CONVERGED and _c.conformal_json(self._handle, ctypes.byref(text)) != _OK:
                fail(code, said)
            if code not in (_OK, NOT_CONVERGED):
                fail(code, said)
            self._check(_c.conformal_json(self._handle, ctypes.byref(text)))
            result = Result(json.loads(text.value.decode()), self._arrays())
        if strict and result.warnings:
            raise InputError("; ".join(result.warnings) +
                             " (warnings are taken as errors here) Mend what they say, or do not ask for strictness.")
        return result

    def _arrays(self):
        """{name: (numbers, in how many rows)}"""
        mx, ms = ctypes.c_int(), ctypes.c_int()
        self._check(_c.conformal_grid(self._handle, ctypes.byref(mx), ctypes.byref(ms)))
        out = {}
        for index, name in enumerate(_ARRAYS):
            count = mx.value if index == 0 else ms.value if index < _ROWS else mx.value * ms.value
            values = (ctypes.c_double * count)()
            self._check(_c.conformal_array(self._handle, index, values, count))
            out[name] = array("d", bytes(values)), 1 if index < _ROWS else ms.value
        return out


def _again(scene, folder):
    return Sequence(scene, folder=folder)


def _scene_file_text(scene):
    try:
        return Path(scene).read_bytes()
    except OSError as error:
        raise InputError(f"scene file '{scene}' cannot be read ({error.strerror}) Check the path.") from None


def solve(scene, changes=None, model=None, strict=False, *, folder=None):
    """Solves one case; `scene` and `folder` as Sequence takes them, `changes`: {key: value}. Lack of convergence is in the result."""
    return Sequence(scene, folder=folder).solve(changes, model, strict)
