"""bem_contact table: its outputs agree, processes do not matter, and wrong input is refused in words."""

import json
import os
import signal
import subprocess
import tempfile
import time
import unittest
from pathlib import Path

import h5py
import numpy as np

SCENE = """kind = "patch"
gap.a = 1e-3
gap.b = 2e-3
motion.xi = 1e-3
solver.model = "halfspace"
[grid]
dx = 0.5
ds = 0.5
mx = 20
ms = 16
[table]
motion.eta = [ 0, 2e-3 ]
load.force = { from = 2e3, to = 4e3, count = 3 }
"""


class TableCommand(unittest.TestCase):
    def setUp(self):
        self.temporary = tempfile.TemporaryDirectory()
        self.folder = Path(self.temporary.name)
        self.scene = self.folder / "scene.toml"
        self.scene.write_text(SCENE)

    def tearDown(self):
        self.temporary.cleanup()

    def run_table(self, *arguments):
        return subprocess.run([os.environ["BEM_CONTACT"], *map(str, arguments)], stdout=subprocess.PIPE,
                              stderr=subprocess.PIPE, text=True)

    def test_a_process_that_dies_ends_the_command_in_words(self):
        """It is not tried again in the command's own process, which it might take with it."""
        command = [os.environ["BEM_CONTACT"], "table", "--creep-forces", "-o", self.folder / "t.h5", "--jobs", "1"]
        with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as running:
            children = Path(f"/proc/{running.pid}/task/{running.pid}/children")
            while running.poll() is None and not children.read_text():
                time.sleep(0.01)
            os.kill(int(children.read_text().split()[0]), signal.SIGKILL)
            _, said = running.communicate()
        self.assertEqual(running.returncode, 3, said)
        self.assertIn("has no result (the process that solved it was ended by signal 9", said)
        self.assertFalse((self.folder / "t.h5").exists())

    def test_a_packed_table_needs_no_library(self):
        """One C source gives the same numbers, and derivatives that are theirs."""
        file, source, program = self.folder / "t.h5", self.folder / "t.c", self.folder / "t"
        self.assertEqual(self.run_table("table", self.scene, "-o", file, "--tolerance", 0.05).returncode, 0)
        packed = self.run_table("table", file, "--pack", source, "--columns", "Fx,Fz,pmax")
        self.assertEqual(packed.returncode, 0, packed.stderr)
        source.write_text(source.read_text() + """
#include <stdio.h>
#include <stdlib.h>
int main(int count, char** words) {
  double at[2], values[3], slopes[6], errors[3];
  int beyond, code, i;
  for (i = 0; i < 2 && i + 1 < count; ++i)
    at[i] = atof(words[i + 1]);
  code = conformal_packed_force(conformal_packed, at, 3, values, slopes, errors, &beyond);
  printf("%d %d %.17g %.17g %.17g %.17g %.17g %s %s", code, beyond, values[0], values[1], values[2], slopes[1], errors[0],
         conformal_packed_axes[1], conformal_packed_columns[2]);
  return 0;
}
""")
        subprocess.run(["cc", "-std=c89", "-pedantic", "-Wall", "-Werror", source, "-o", program], check=True)

        def call(*at):
            return subprocess.run([program, *map(repr, at)], stdout=subprocess.PIPE, text=True, check=True).stdout.split()

        found = call(7e-4, 2345.0)
        said = self.run_table("table", file, "--at", "7e-4,2345").stdout.splitlines()
        own = {line.split()[0]: float(line.split()[1]) for line in said}
        self.assertEqual(found[:2], ["0", "0"])
        for name, value in zip(["Fx", "Fz", "pmax"], found[2:5]):
            self.assertAlmostEqual(float(value), own[name], delta=1e-9 * abs(own[name]))
        difference = (float(call(7e-4, 2346.0)[2]) - float(call(7e-4, 2344.0)[2])) / 2
        self.assertAlmostEqual(float(found[5]), difference, delta=1e-6 * abs(difference))
        with h5py.File(file) as stored:  # so few elements do not tell their error
            np.testing.assert_allclose(float(found[6]), stored["interpolation_error/Fx"][()] + np.nan_to_num(stored["element_error/Fx"][()]))
        self.assertIn(f" +- {float(found[6]):.2g} N", said[0] if said[0].startswith("Fx ") else "\n".join(said))
        self.assertEqual(found[7:], ["load.force,", "N", "pmax,", "MPa"])
        self.assertEqual(call(7e-4, 5000.0)[:2], ["5", "2"])
        self.assertIn("The table has no 'Fq'", self.run_table("table", file, "--pack", source, "--columns", "Fq").stderr)

    def test_json_file_and_values_agree(self):
        file = self.folder / "t.h5"
        done = self.run_table("table", self.scene, "-o", file, "--tolerance", 0.05, "--json", "--jobs", 2)
        self.assertEqual(done.returncode, 0, done.stderr)
        said = json.loads(done.stdout)
        with h5py.File(file) as f:
            self.assertEqual(f["axes/motion.eta"][()].tolist(), said["axes"]["motion.eta"])
            self.assertEqual(f["axes/load.force"].attrs["unit"], b"N")
            self.assertTrue(said["columns"]["Fx"]["held"])
            for name, column in said["columns"].items():
                if column["held"]:
                    self.assertLessEqual(column["interpolation_error"], 0.05 * column["scale"], name)
                    self.assertEqual(f["interpolation_error"][name][()], column["interpolation_error"])
            fx, points = f["values/Fx"][()], f["points"][()]
        self.assertEqual(fx.size, points)
        alone = self.folder / "one.h5"
        self.run_table("table", self.scene, "-o", alone, "--tolerance", 0.05, "--jobs", 1)
        with h5py.File(alone) as f:
            np.testing.assert_allclose(f["values/Fx"][()], fx, atol=1e-2)
        at = self.run_table("table", file, "--at", "0,3000").stdout
        self.assertAlmostEqual(float(at.split()[1]), fx[0, list(said["axes"]["load.force"]).index(3000)], delta=1e-8 * 3e3)
        info = self.run_table("info", file).stdout
        self.assertIn("A table of contact forces", info)
        self.assertIn("values/Fx", info)
        self.assertIn("motion.eta", self.run_table("info", "--scene", file).stdout)

    def test_a_point_that_fails_is_named_once_and_keeps_its_exit_code(self):
        """After its name comes what its scene alone says."""
        unlike = "solver.max_outer = 1\nwheel.material.shear_modulus = 800\nwheel.material.poisson = 0\n"
        for force, more, problem, advice, code in (
                (1e12, "", "The load is far beyond elastic contact", "Check load, lengths and moduli", 2),
                (2e3, unlike, "The halfspace result is not a solution", "Coarsen the grid", 3)):
            self.scene.write_text(more + SCENE.split("[table]")[0] + f"[table]\nload.force = [1e3, {force!r}]\n")
            done = self.run_table("table", self.scene, "-o", self.folder / "t.h5", "--jobs", "1")
            self.assertEqual(done.returncode, code, done.stderr)
            self.assertRegex(done.stderr, rf"The table has no value at load\.force = [0-9e+]+: {problem} \(.*\) {advice}")
            self.assertEqual(done.stderr.count("The table"), 1, done.stderr)

    def test_wrong_input(self):
        def refused(word, *arguments, code=2):
            done = self.run_table("table", *arguments)
            self.assertEqual(done.returncode, code, done.stderr)
            self.assertEqual(done.stdout, "")
            self.assertIn(word, done.stderr)

        out = self.folder / "t.h5"
        refused("which table is wanted", "-o", out)
        refused("which table is wanted", self.scene, "--creep-forces", "-o", out)
        refused("has no file", self.scene)
        refused("scene.toml", self.scene, "-o", self.scene)
        refused("'1-10' cannot be read", "--creep-forces", "--ratio", "1-10", "-o", out)
        refused("two ends", "--creep-forces", "--ratio", "1", "-o", out)
        refused("2 elements", "--creep-forces", "--elements", "2", "-o", out)
        refused("begins with 6 points", self.scene, "-o", out, "--most-points", "5")
        refused("--most-points", self.scene, "-o", out, "--most-points", "6", "--tolerance", "0.001", code=3)
        self.assertFalse(out.exists())
        refused("cannot be read", self.scene, "--at", "1,2")
        self.scene.write_text(SCENE.split("[table]")[0])
        refused("describes no table", self.scene, "-o", out)


if __name__ == "__main__":
    unittest.main()
