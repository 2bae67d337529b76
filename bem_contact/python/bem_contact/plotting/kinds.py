"""What is FILE? Results by their attribute "format", tables by their first line, a folder by what lies in it."""

import functools
import math
import os
import subprocess
import tomllib
from pathlib import Path

import h5py

from ..program import program_file
from .refusals import InputError, refuse

FORMATS = ("result", "comparison", "sweep", "creep curves", "conicity map", "conicity", "wheelset", "table", "wear", "fatigue", "fit", "stresses")
MOST_DEFLATED = 1032  # bytes of one: deflate stores 258 bytes in 2 bits
CHECKSUM = 4  # bytes of Fletcher's behind each chunk
HEADS = {"FI_surf": "fatigue", "body,t,line,section,u": "sections table", "s_mm,y_mm,z_mm,inclination_rad": "profile table"}


def text(value):
    return value.decode() if isinstance(value, bytes) else str(value)


def number(group, name):
    """The number of that name in a group of a file."""
    return float(group[name][()])


def require_output(output, inputs):
    """Refuses an output that is one of the files that are read, by whatever name."""
    for name in inputs:
        if os.path.realpath(output) == os.path.realpath(name) or (
                os.path.exists(output) and os.path.exists(name) and os.path.samefile(output, name)):
            refuse(f"The output '{output}' would overwrite '{name}'", "it is read here", "Give the output another name.")


def from_file(file, action):
    """What `action` makes of a file; one that is not what it says is refused."""
    try:
        return action()
    except InputError:
        raise
    except KeyError as error:
        refuse(f"'{file}' cannot be used", f"it lacks something: {error}", "Make it again with this version of bem_contact.")
    except (ArithmeticError, AttributeError, IndexError, OSError, RuntimeError, StopIteration, TypeError, ValueError) as error:
        why = str(error) or "it holds none of what it should"
        refuse(f"'{file}' cannot be used", f"it is damaged, or its datasets do not fit each other: {why}",
               "Copy it again from where it was whole, or make it again.")


def to_file(output, action):
    """Does what writes a file; a name that cannot be written to is refused."""
    try:
        return action()
    except (OSError, UnicodeEncodeError) as error:
        refuse(f"'{output}' cannot be written", getattr(error, "strerror", None) or str(error), "Give another file.")


def require_columns(group):
    """Refuses a file of which this group's columns are not equally long."""
    lengths = {data.name: len(data) for data in group.values() if isinstance(data, h5py.Dataset) and data.ndim == 1}
    usual = max(lengths.values(), key=list(lengths.values()).count, default=0)
    for name, length in lengths.items():
        if length != usual:
            refuse(f"The file '{group.file.filename}' is damaged",
                   f"its dataset '{name.lstrip('/')}' has {length} numbers, not {usual} as those beside it",
                   "Copy it again from where it was whole, or make it again.")


def fault_of(data):
    """Why HDF5 may not read a dataset, as bem_contact has it (h5/dataset.cpp); "": it may."""
    if data.external or data.is_virtual:
        return "lies in another file"
    stored, packed = data.id.get_storage_size(), data.compression is not None
    if data.shape is not None and data.nbytes > stored * (MOST_DEFLATED if packed else 1):
        return f"has {data.nbytes} bytes, of which {stored} are stored"
    if data.chunks and data.size:
        whole = 0 if packed else math.prod(data.chunks) * data.dtype.itemsize
        sizes = [data.id.get_chunk_info(i).size - CHECKSUM * data.fletcher32 for i in range(data.id.get_num_chunks())]
        if any(size < 0 if packed else size != whole for size in sizes):
            return "has a chunk that is not as long as it must be"
    return ""


def require_own_numbers(group, seen=frozenset()):
    """Refuses a file with datasets that lie elsewhere or are not whole. The fields of a sweep's cases are not looked at."""
    address = h5py.h5o.get_info(group.id).addr  # a group may lie in itself
    for name in group if address not in seen else ():
        link = group.get(name, getlink=True)
        whole_name = f"{group.name}/{name}".lstrip("/")
        why = "" if isinstance(link, h5py.HardLink) else "is a link to another place"
        if not why and whole_name != "cases":
            item = group[name]
            if isinstance(item, h5py.Group):
                require_own_numbers(item, seen | {address})
            elif isinstance(item, h5py.Dataset):
                why = fault_of(item)
        if why:
            refuse(f"The file '{group.file.filename}' is damaged", f"its dataset '{whole_name}' {why}",
                   "Copy it again from where it was whole, or make it again.")


def of_hdf5(file):
    with h5py.File(file) as opened:
        require_own_numbers(opened)
        if {"stations", "kernel"} <= set(opened) or {"stations", "table"} <= set(opened):
            return "influence file"
        name = text(opened.attrs.get("format", "")).removeprefix("bem_contact ")
    for kind in FORMATS:
        if name.startswith(kind):
            return kind
    if not name:
        refuse(f"'{file}' cannot be drawn", "it is neither a file of results nor an influence file", "bem_contact info says what is in it.")
    refuse(f"'{file}' cannot be drawn", f"its format is '{name}'",
           "Name a file that bem_contact solve, compare, sweep, creep-curves, conicity, fit, wheelset, table, wear, fatigue or stresses wrote.")


@functools.cache
def is_standard(name):
    """Whether the program knows a standard profile of this name, as people say it."""
    program = program_file()
    return program is not None and subprocess.run([program, "profile", "--list", "--", name], capture_output=True).returncode == 0


def has_sections(path):
    """Whether it is a scene whose rail or wheel is given by sections."""
    scene = tomllib.loads(path.read_text(encoding="utf-8", errors="replace"))
    sides = [scene.get(name) for name in ("rail", "wheel") if isinstance(scene.get(name), dict)]
    return any("sections" in side or str(side.get("profile", "")).lower().endswith((".slcs", ".slcw")) for side in sides)


def kind_of(name):
    """The kind of a file, a folder or a standard profile."""
    path = Path(name)
    if path.is_dir():
        if (path / "wear.csv").is_file():
            return "wear"
        refuse(f"'{name}' cannot be drawn", "the folder has no wear.csv", "Name a folder of bem_contact wear, or a file.")
    if not path.exists():
        if is_standard(name):
            return "profile"
        if "#" not in name or not Path(name.rsplit("#", 1)[0]).is_file():
            refuse(f"'{name}' cannot be drawn", "there is no such file", "Name one, or a standard that bem_contact profile --list prints.")
        return "profile"
    if h5py.is_hdf5(path):
        return of_hdf5(path)
    if path.suffix.lower() in (".slcs", ".slcw") or path.suffix == ".toml" and has_sections(path):
        return "sections"
    if path.suffix == ".toml" and "body" not in tomllib.loads(path.read_text(encoding="utf-8", errors="replace")):
        refuse(f"'{name}' cannot be drawn", "it is a scene", f"Solve it first: bem_contact solve {name} -o {path.stem}.h5")
    if path.suffix in (".msh", ".toml"):
        return "mesh"
    with open(path, encoding="utf-8", errors="replace") as opened:
        head = next((line for line in opened if not line.startswith("#")), "")
    kind = next((kind for word, kind in HEADS.items() if word in head), "profile")
    if kind == "profile" and path.suffix == ".csv" and head.count(",") > 1 and head[:1].isalpha():
        refuse(f"'{name}' cannot be drawn", "it is a table, and neither of wear, of fatigue nor of a profile",
               f"Draw the HDF5 file that was written with it, as {path.with_suffix('.h5')}.")
    return kind
