"""tools/verify --quick: what it checks holds, and a program that is wrong is found out. tools/stability --quick."""

import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import programs

VERIFY = programs.ROOT / "tools" / "verify"
sys.path.insert(0, str(programs.ROOT / "tools"))

# Five per cent too much pressure, on its way from the program to who reads it.
WRONG = """#!/usr/bin/python3
import json, subprocess, sys
done = subprocess.run(["{program}", *sys.argv[1:]], stdout=subprocess.PIPE, text=True)
text = done.stdout
if "--json" in sys.argv:
    result = json.loads(text)
    result["quantities"]["pmax"] *= 1.05
    text = json.dumps(result)
sys.stdout.write(text)
sys.exit(done.returncode)
"""


def verify(folder, bin_folder):
    return subprocess.run([VERIFY, "--quick", "-o", folder], stdout=subprocess.PIPE, text=True,
                          env=os.environ | {"CONFORMAL_BIN": str(bin_folder)})


class Verification(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def test_every_check_holds(self):
        done = verify(self.folder, programs.BIN)
        self.assertEqual(done.returncode, 0, done.stdout)
        page = (self.folder / "VERIFICATION.md").read_text()
        for part in ("Hertz, ellipse", "Carter", "tangent plane, groove", "3-D analysis", "sha256", "All checks hold"):
            self.assertIn(part, page)
        self.assertNotIn("FAILS", page)
        self.assertIn("<svg", (self.folder / "index.html").read_text())

    def test_a_wrong_program_is_found_out(self):
        wrong = self.folder / "bin"
        wrong.mkdir()
        (wrong / "bem_contact").write_text(WRONG.format(program=programs.BIN / "bem_contact"))
        (wrong / "bem_contact").chmod(0o755)
        done = verify(self.folder, wrong)
        self.assertEqual(done.returncode, 1)
        self.assertIn("Hertz, ellipse: largest pressure", done.stdout)
        self.assertIn("**FAILS**", (self.folder / "VERIFICATION.md").read_text())


class Stability(unittest.TestCase):
    def test_a_linear_input_is_not_enlarged(self):
        with tempfile.TemporaryDirectory() as name:
            page = Path(name) / "stability.md"
            subprocess.run([programs.ROOT / "tools" / "stability", "--quick", "-o", page], check=True, stdout=subprocess.PIPE,
                           env=os.environ | {"CONFORMAL_BIN": str(programs.BIN)})
            # Fz is the force that the scene gives
            self.assertIn("| carter | halfspace | 1 (force: Fz) | 1 (force: Fz) | 1 (force: Fz) |", page.read_text())


class ExactSolutions(unittest.TestCase):
    """The exact values of the page against printed ones."""

    def test_printed_values(self):
        import numpy as np
        from verification import exact
        h = exact.hertz(1 / 920, 1 / 600, exact.contact_modulus(210000 / 2.6, 0.3), 1e5)
        for name, value in (("a", 7.161676), ("b", 5.387172), ("pmax", 1237.5588), ("approach", 0.10411895)):
            self.assertAlmostEqual(h[name] / value, 1, delta=1e-6)
        for degrees, ratio, middle in ((10, 82.2206, 3.66156), (30, 7.94354, 1.26029), (75, 0.287077, 0.628103)):
            found, pressure = exact.persson(np.radians(degrees))
            self.assertAlmostEqual(found / ratio, 1, delta=5e-6)
            self.assertAlmostEqual(float(pressure(0.0)) / middle, 1, delta=5e-6)
        self.assertAlmostEqual(exact.bentall_johnson_factor(), 0.4573855, delta=1e-7)


if __name__ == "__main__":
    unittest.main()
