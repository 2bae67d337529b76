"""Writes an influence file in the flat form that h5/flat_files.cpp reads where there is no HDF5.

    flat_influence.py INFLUENCE.h5 FLAT

Behind a seal of the same form as before: for each attribute and dataset its name, its kind and what it holds, little-endian.
"""

import hashlib
import struct
import sys
from pathlib import Path

import h5py
import numpy as np

SEAL = 512  # bytes, as influence/file_seal.hpp


def text(value):
    data = value.encode() if isinstance(value, str) else bytes(value)
    return struct.pack("<Q", len(data)) + data


def entries(file):
    for name, value in sorted(file.attrs.items()):
        if isinstance(value, (str, bytes)):
            yield text(name) + b"t" + text(value)
        elif np.issubdtype(np.asarray(value).dtype, np.integer):
            yield text(name) + b"i" + struct.pack("<Q", int(value))
        else:
            yield text(name) + b"d" + struct.pack("<d", float(value))
    for name, data in sorted(file.items()):
        yield text(name) + b"a" + struct.pack(f"<{1 + data.ndim}Q", data.ndim, *data.shape) + data[()].astype("<f8").tobytes()


source, output = map(Path, sys.argv[1:])
title, version = source.read_bytes()[:SEAL].decode().split("\n")[:2]
with h5py.File(source) as file:
    body = b"".join(entries(file))
seal = f"{title}\n{version}\nbytes {SEAL + len(body)}\nsha256 {hashlib.sha256(body).hexdigest()}\n"
output.write_bytes(seal.encode().ljust(SEAL, b"\0") + body)
