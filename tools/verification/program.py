"""Calls bem_contact with scenes that are made here, and says exactly which program and which files were used."""

import hashlib
import json
import os
import subprocess
import tempfile
from dataclasses import dataclass
from pathlib import Path

import h5py

ROOT = Path(__file__).resolve().parents[2]


@dataclass
class Result:
    """One solved scene: what --json prints, and the fields of the result file."""

    json: dict
    fields: dict  # of the grid: x, s, delta, gap; of the model: p_n, p_x, p_s, state ...

    def __getitem__(self, name):
        return self.json["quantities"][name] if name in self.json["quantities"] else self.json[name]


class Program:
    """The programs of one build folder. Scenes and tables live in a temporary folder while the object does."""

    def __init__(self, folder=None):
        self.bin = Path(folder or os.environ.get("CONFORMAL_BIN", ROOT / "build" / "bin")).resolve()
        self.path = self.bin / "bem_contact"
        if not self.path.exists():
            raise SystemExit(f"The program '{self.path}' is not there (the project is not built, or elsewhere) "
                             "Build it, or say where it is: CONFORMAL_BIN=build-contact-only/bin")
        self.temporary = tempfile.TemporaryDirectory()
        self.folder = Path(self.temporary.name)
        self.environment = os.environ | {"OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1",
                                         "OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1",
                                         "CONFORMAL_BIN": str(self.bin)}

    def run(self, *command, accept=(0,)):
        done = subprocess.run([str(c) for c in command], capture_output=True, text=True, env=self.environment)
        if done.returncode not in accept:
            raise RuntimeError(f"{' '.join(str(c) for c in command)}\n{done.stderr or done.stdout}")
        return done.stdout

    def solve(self, scene, model="halfspace"):
        """`scene` maps full key names to values; a table of numbers is written as a CSV file beside the scene."""
        file, output = self.scene(scene), self.folder / "result.h5"
        printed = self.run(self.path, "solve", file, "--model", model, "--json", "-o", output)
        with h5py.File(output) as f:
            fields = {name: data[()] for name, data in f.items() if isinstance(data, h5py.Dataset)}
        return Result(json.loads(printed), fields)

    def scene(self, scene):
        file = self.folder / "scene.toml"
        file.write_text("".join(f"{key} = {self.text(key, value)}\n" for key, value in scene.items()))
        return file

    def text(self, key, value):
        if isinstance(value, tuple):  # head of a CSV file, and its rows
            head, rows = value
            (self.folder / f"{key}.csv").write_text(
                head + "\n" + "\n".join(",".join(repr(float(v)) if v % 1 else str(int(v)) for v in r) for r in rows))
            return f'"{key}.csv"'
        return json.dumps(str(value) if isinstance(value, Path) else value)

    def version(self):
        return self.run(self.path, "--version").strip()

    def body_numbers(self, file, dx, ds, mx, ms, centre):
        """Influence numbers of one body as [m][I][i][J][j], expanded by the program. On a wheel x is R_ref theta, as in a
        scene of kind "patch"; `influence expand` counts x at the radius of the middle row, which is undone here."""
        def expand(length):
            output = self.folder / "numbers.h5"
            self.run(self.path, "influence", "expand", file, "--dx", length, "--ds", ds, "--mx", mx, "--my", ms,
                     "--centre", centre, "-o", output)
            with h5py.File(output) as f:
                radius = f.attrs.get("contact_radius", b"1 mm").decode().split()[0]
                return f["influence_numbers"][:], float(radius)

        with h5py.File(file) as f:
            reference = abs(float(f.attrs["reference_radius"]))
        numbers, radius = expand(dx)
        if reference == 0:
            return numbers
        numbers, radius = expand(dx * radius / reference)
        return numbers * reference / radius

    def influence_files(self, bodies, folder):
        """Influence files of bodies in data/bodies, made if they are not there; {} where fem_influence was not built."""
        files = {body: Path(folder) / f"{body}.h5" for body in bodies}
        if not all(f.exists() for f in files.values()):
            if not (self.bin / "fem_influence").exists():
                return {}
            for body, file in files.items():
                if not file.exists():
                    self.run(ROOT / "tools" / "influence", ROOT / "data" / "bodies" / f"{body}.toml", file)
        return files


def digest(file):
    return hashlib.sha256(Path(file).read_bytes()).hexdigest()


def commit():
    """The commit of this source tree, and whether it was changed since."""
    def git(*words):
        return subprocess.run(["git", "-C", ROOT, *words], capture_output=True, text=True).stdout.strip()
    changed = git("status", "--porcelain", "--", "bem_contact", "fem_influence", "meshes", "tools/verification")
    return (git("rev-parse", "HEAD") or "unknown") + (", with local changes" if changed else "")
