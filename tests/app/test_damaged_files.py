"""A file with a dataset that is too short, empty or gone is refused by every reader, or does not matter to it."""

import os
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import h5py
import numpy as np

PLOT = Path(__file__).resolve().parents[2] / "tools" / "plot"
PATCH = """kind = "patch"
motion = { friction = 0.3, xi = 1e-3 }
solver.model = "halfspace"
gap = { a = 1e-3, b = 2e-3 }
grid = { dx = 0.8, ds = 0.8, mx = 12, ms = 12 }
"""
SCENES = {"sweep": PATCH + "sweep.load.force = [1e3, 2e3]\n",
          "table": PATCH + "table.load.force = [2e3, 3e3]\n",
          "wear": """rail.profile = "60E1"
wheel.profile = "S1002"
solver.model = "halfspace"
load.force = 8e4
motion = { xi = 2e-3, free_rolling = false }
grid = { dx = 2, ds = 1 }
sweep.position.lateral = [0.0]
"""}
DAMAGED = "is damaged (its dataset '{}'"


def cut(file, name, length):
    """A dataset of another length; None: none at all."""
    data, attributes = np.atleast_1d(file[name][()]), dict(file[name].attrs)
    del file[name]
    if length is not None:
        file[name] = np.resize(data.ravel(), length) if length else h5py.Empty("f8")
        file[name].attrs.update(attributes)


class DamagedFiles(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.folder = Path(cls.temporary.name)
        for name, text in SCENES.items():
            (cls.folder / f"{name}.toml").write_text(text)
        for command in (("sweep", "sweep.toml", "-o", "sweep.h5"), ("table", "table.toml", "--tolerance", "1", "-o", "table.h5"),
                        ("table", "--creep-forces", "--tolerance", "0.28", "--elements", "6", "--ratio", "1:1.2", "-o", "creep.h5"),
                        ("wear", "wear.toml", "-o", "worn", "--depth", "0.02")):
            done = cls.program(*command)
            assert done.returncode == 0, done.stderr

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    @classmethod
    def program(cls, *arguments, program=None):
        return subprocess.run([*(program or [os.environ["BEM_CONTACT"]]), *arguments], cwd=cls.folder, stdout=subprocess.PIPE,
                              stderr=subprocess.PIPE, text=True)

    def check(self, file, command, must, datasets=None, program=None):
        """Damages one dataset after the other. `must`: those that the command cannot do without."""
        whole = self.folder / "whole"
        shutil.copy(self.folder / file, whole)
        with h5py.File(whole) as opened:
            found = []
            opened.visititems(lambda name, item: found.append(name) if isinstance(item, h5py.Dataset) and item.dtype.kind == "f" else None)
            sizes = {name: opened[name].size for name in datasets or found if not name.startswith("cases/")}
        self.assertGreater(len(sizes), 3)
        for name, size in sizes.items():
            for length in (size - 1, None):
                with self.subTest(command=command[0], dataset=name, length=length):
                    shutil.copy(whole, self.folder / file)
                    with h5py.File(self.folder / file, "r+") as opened:
                        cut(opened, name, length)
                    done = self.program(*command, program=program)
                    self.assertIn(done.returncode, (0, 2), done.stderr)
                    if must(name):
                        self.assertEqual(done.returncode, 2, done.stdout)
                        self.assertIn(file, done.stderr)
                        self.assertIn(f"'{name}'", done.stderr)
        shutil.copy(whole, self.folder / file)

    def test_sweep(self):
        self.check("sweep.h5", ("sweep", "sweep.toml", "-o", "sweep.h5", "--csv", "s.csv"),
                   lambda name: name != "patches/case",  # as long as it is, the others must be
                   ["status", "seconds", "cpu_seconds", "Fx", "warning_count", "model", "patches/case", "patches/patch", "patches/Fn"])

    def test_numbers_that_stand_for_words(self):
        """A status or a model that there is none of."""
        shutil.copy(self.folder / "sweep.h5", self.folder / "whole")
        for name, value in (("status", 5), ("status", np.nan), ("model", 4), ("model", -1), ("patches/case", 2)):
            with self.subTest(name=name, value=value):
                with h5py.File(self.folder / "sweep.h5", "r+") as opened:
                    opened[name][0] = value
                done = self.program("sweep", "sweep.toml", "-o", "sweep.h5", "--csv", "s.csv")
                self.assertEqual(done.returncode, 2, done.stdout)
                self.assertIn(DAMAGED.format(name), done.stderr)
            shutil.copy(self.folder / "whole", self.folder / "sweep.h5")

    def test_tables(self):
        for file, at in (("table.h5", "2500"), ("creep.h5", "1,1,82000,1000,0.001,0,0")):
            # a shorter axis is a table of which the values are too many; C11 says what kind of table it is
            self.check(file, ("table", file, f"--at={at}"),
                       lambda name: name.split("/")[0] in ("values", "scale", "interpolation_error", "element_error", "creep_scale")
                       and name != "creep_scale/C11")

    def test_wear_goes_on(self):
        self.check("worn/wear.h5", ("wear", "wear.toml", "-o", "worn", "--depth", "0.02"),
                   lambda name: name not in ("step", "rail/depth", "wheel/depth"))  # as long as these, others must be

    def test_reports(self):
        self.check("worn/wear.h5", ("report", "worn/wear.h5", "-o", "page.html"), lambda name: False,
                   ["step", "mileage", "rail/depth", "rail/profile"])

    def test_info(self):
        """One number that is none was read beyond its end."""
        self.check("table.h5", ("info", "table.h5"), lambda name: False)

    def test_plots(self):
        self.check("sweep.h5", ("sweep.h5", "-o", "s.png"), lambda name: False, ["status", "load.force", "Fx", "patches/y"],
                   program=[sys.executable, PLOT])


if __name__ == "__main__":
    unittest.main()
