"""A file system without locks, as NFS without its lock service: flock says ENOLCK. Whatever is whole is read and written there."""

import os
import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path

PROGRAM = os.environ["BEM_CONTACT"]
DATA = Path(__file__).resolve().parents[2] / "data"
WITHOUT = """#include <errno.h>
int flock(int file, int operation) { (void)file; (void)operation; errno = ENOLCK; return -1; }
"""
PATCH = """kind = "patch"
motion = { friction = 0.3, xi = 1e-3 }
grid = { dx = 0.8, ds = 0.8, mx = 12, ms = 12 }
gap = { a = 1e-3, b = 1e-3 }
load.force = 5e3
"""
FEM = f"""rail = {{ profile = "60E1", influence = "{DATA}/influence/small_rail.h5" }}
wheel = {{ profile = "S1002", influence = "{DATA}/influence/small_wheel.h5" }}
solver.model = "fem"
load.force = 1e5
motion = {{ free_rolling = false, xi = 1e-3 }}
grid = {{ dx = 1, ds = 0.5 }}
position.lateral = 6.5
"""
SCENES = {"patch.toml": PATCH, "sweep.toml": PATCH.replace("load.force = 5e3\n", "[sweep]\nload.force = [4e3, 5e3, 6e3, 7e3]\n"),
          "table.toml": PATCH.replace("load.force = 5e3\n", "[table]\nload.force = [4e3, 7e3]\n"), "fem.toml": FEM}


@unittest.skipUnless(shutil.which("cc"), "there is no C compiler")
class NoLocks(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        temporary = tempfile.TemporaryDirectory()
        cls.addClassCleanup(temporary.cleanup)
        cls.folder = Path(temporary.name)
        for name, text in (SCENES | {"flock.c": WITHOUT}).items():
            (cls.folder / name).write_text(text)
        subprocess.run(["cc", "-shared", "-fPIC", "-o", "flock.so", "flock.c"], cwd=cls.folder, check=True)

    def run_without_locks(self, *arguments):
        # HDF5 has a variable of its own for this, which nobody needs to know.
        environment = {key: value for key, value in os.environ.items() if key != "HDF5_USE_FILE_LOCKING"}
        done = subprocess.run([PROGRAM, *arguments], cwd=self.folder, env=environment | {"LD_PRELOAD": str(self.folder / "flock.so")},
                              capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        return done.stdout + done.stderr

    def test_parts_are_written_and_joined(self):
        for cases in ("0:2", "2:4"):
            self.run_without_locks("sweep", "sweep.toml", "-o", f"{cases[0]}.h5", "--cases", cases)
        self.assertIn("4 of 4 cases are certified", self.run_without_locks("sweep", "sweep.toml", "--join", "0.h5", "2.h5", "-o", "joined.h5", "--csv", "j.csv"))

    def test_a_whole_sweep_warns_and_goes_on(self):
        (self.folder / "whole.h5.parts").mkdir()  # else so few cases are solved in one process, which locks nothing
        said = self.run_without_locks("sweep", "sweep.toml", "-o", "whole.h5", "--jobs", "2")
        self.assertIn("4 of 4 cases are certified", said)
        self.assertIn("cannot be locked", said)
        self.assertIn("complete", self.run_without_locks("sweep", "sweep.toml", "-o", "whole.h5"))

    def test_a_result_is_written_and_repeated(self):
        self.run_without_locks("solve", "patch.toml", "-o", "result.h5")
        self.run_without_locks("solve", "result.h5")

    def test_a_table_is_written_and_read(self):
        self.run_without_locks("table", "table.toml", "-o", "table.h5", "--tolerance", "0.5")
        self.assertIn("Fx", self.run_without_locks("info", "table.h5"))

    def test_influence_files_are_read(self):
        self.run_without_locks("check", "fem.toml")
        self.run_without_locks("solve", "fem.toml")


if __name__ == "__main__":
    unittest.main()
