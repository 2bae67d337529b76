"""The readers of tools/examples give what the table's own evaluation gives."""

import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

EXAMPLES = Path(os.environ["EXAMPLES"])
SCENE = """rail.profile = "60E1"
wheel.profile = "S1002"
solver.model = "halfspace"
motion.xi = 1e-3
motion.free_rolling = false
grid.dx = 1.5
grid.ds = 1.5
[table]
position.lateral = [ -3, -2 ]
load.force = [ 5e4, 8e4 ]
"""


def run(*command):
    done = subprocess.run([str(c) for c in command], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    if done.returncode != 0:
        raise AssertionError(f"{command} ended with {done.returncode}:\n{done.stdout}{done.stderr}")
    return done.stdout


class Readers(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        folder = Path(cls.temporary.name)
        (folder / "scene.toml").write_text(SCENE)
        cls.tables = {"creep": folder / "creep", "forces": folder / "forces"}
        table = os.environ["BEM_CONTACT"], "table", "--tolerance"
        run(*table, "0.28", "--creep-forces", "--elements", "6", "--ratio", "0.5:2", "-o", folder / "creep.h5",
            "--text", folder / "creep.txt")
        run(*table, "0.5", folder / "scene.toml", "-o", folder / "forces.h5", "--text", folder / "forces.txt")
        flags = run("pkg-config", "--cflags", "--libs", "hdf5-serial").split()
        run("gcc", "-std=c99", "-Wall", "-Werror", EXAMPLES / "table_reader.c", "-o", folder / "c", *flags, "-lhdf5_hl",
            "-lm")
        run("gfortran", "-J", folder, EXAMPLES / "table_reader.f90", "-o", folder / "fortran")
        cls.readers = {"Python": ([sys.executable, EXAMPLES / "table_reader.py"], ".h5"), "C": ([folder / "c"], ".h5"),
                       "Fortran": ([folder / "fortran"], ".txt")}

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    def check(self, kind, point):
        own = run(os.environ["BEM_CONTACT"], "table", f"{self.tables[kind]}.h5", "--at", ",".join(point))
        expected = {line.split()[0]: float(line.split()[1]) for line in own.splitlines()}
        for language, (command, ending) in self.readers.items():
            numbers = [float(word) for word in run(*command, f"{self.tables[kind]}{ending}", *point).split()]
            self.assertEqual(len(numbers), 3)
            for name, number in zip(("Fx", "Fy", "Mz"), numbers):
                with self.subTest(language=language, name=name, point=point):
                    self.assertAlmostEqual(number, expected[name], delta=1e-9 * max(1, abs(expected[name])))
        return expected

    def test_creep_forces(self):
        for creepages in (("0.001", "0", "0"), ("-0.001", "0.0005", "0.0002"), ("0.002", "-0.0005", "0.0003"),
                          ("0", "0", "-0.001"), ("0", "0", "0")):
            self.check("creep", ("5", "4", "82000", "30000", *creepages))
        self.assertGreater(self.check("creep", ("50", "4", "82000", "30000", "0.001", "0", "0"))["Fx"], 0)  # beyond the end

    def test_forces_of_a_scene(self):
        for point in (("-3", "50000"), ("-2.3", "66000"), ("-2", "80000"), ("-9", "1e6")):
            self.assertGreater(self.check("forces", point)["Fx"], 1000)


if __name__ == "__main__":
    unittest.main()
