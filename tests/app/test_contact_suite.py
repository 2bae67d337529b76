#!/usr/bin/env python3
"""tools/verification/contact_suite: what it counts, and what it refuses. Reads the program from BEM_CONTACT."""

import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
SUITE = ROOT / "tools/verification/contact_suite"
sys.path.insert(0, str(SUITE.parent))
import contact_reasons  # noqa: E402

BALL = """ 3 MODULE
 200100  P-B-T-N-F-S
 022020  L-D-C-M-Z-E
 0101111 H-G-I-A-O-W-R
 1000. 0. 0. 0.            FN, CKSI, CETA, CPHI
 0.3 0.3                   FSTAT, FKIN
 0.28 0.28  82000.  82000. POISS 1,2, GG 1,2
 -1                        IPOTCN
 20 20  1d-2 1d-2 1.2      MX, MY, A1, B1, SCALE
"""
LAW = BALL.replace("022020", "222020").replace("0.3 0.3 ", "0.2 0.1 100. 0 0\n 0 1 ").replace("200100", "203100").replace(
    "\n 0.28", "\n 0d 0.2 1000.\n 0.28")


def printed(number: int, pressure: float) -> str:
    return f" Case {number:5}\n\n     FN          FX          FY\n      1000.       0.000       0.000\n     PMAX\n {pressure}\n"


class ContactSuite(unittest.TestCase):
    def setUp(self):
        self._folder = tempfile.TemporaryDirectory()
        self.folder = Path(self._folder.name)

    def tearDown(self):
        self._folder.cleanup()

    def suite(self, folder: Path, *arguments: str) -> subprocess.CompletedProcess:
        return subprocess.run([sys.executable, str(SUITE), str(folder), "--program", os.environ["BEM_CONTACT"], *arguments],
                              capture_output=True, text=True, timeout=120)

    def refused(self, words: str, folder: Path, *arguments: str):
        done = self.suite(folder, *arguments)
        self.assertEqual((done.returncode, done.stdout), (2, ""))
        self.assertIn(words, done.stderr)

    def test_what_cannot_be_run(self):
        self.refused("nowhere' is no folder", self.folder / "nowhere")
        self.refused("has no input file", self.folder)
        (self.folder / "a.inp").write_text(BALL + " 0 MODULE\n")
        self.refused("with 'b.inp' in its path", self.folder, "--only", "b.inp")
        self.refused("is no program", self.folder, "--program", "nothing")

    def test_what_is_counted(self):
        """One case agrees, one has another pressure and nobody has said why, one has no scene."""
        (self.folder / "a.inp").write_text(BALL + BALL + LAW + " 0 MODULE\n")
        (self.folder / "a.out").write_text(printed(1, 1001.4) + printed(2, 1200.0) + printed(3, 1200.0))
        done = self.suite(self.folder, "-o", str(self.folder / "t.md"))
        self.assertEqual(done.returncode, 0, done.stderr)
        table = (self.folder / "t.md").read_text()
        for line in ("| a.inp | 3 | 2 | 2 | 1 |", "1 of 2 that can be compared agree (50%).", "| not looked at | 1 |", "| L = ...:"):
            self.assertIn(line, table)

    def test_a_file_that_is_not_read_to_its_end(self):
        (self.folder / "a.inp").write_text(BALL + " 3 MODULE\n x\n")
        (self.folder / "a.out").write_text(printed(1, 1001.4))
        done = self.suite(self.folder)
        self.assertEqual(done.returncode, 1)
        self.assertIn("Not read to its end: a.inp", done.stdout)

    def test_the_reasons_are_whole(self):
        """Each names a file, cases and a reason that there is; no case has two."""
        self.assertEqual(contact_reasons.cases_of("1-3, 7"), [1, 2, 3, 7])
        reasons = contact_reasons.Reasons()
        entries = contact_reasons.read()["shown"]
        self.assertEqual(len(reasons), sum(len(contact_reasons.cases_of(entry["cases"])) for entry in entries))
        self.assertEqual(reasons.of(Path("none.inp"), 1), contact_reasons.UNKNOWN)

    def test_friction_is_that_of_the_scene(self):
        scene = self.folder / "s.toml"
        scene.write_text("motion.friction = 0.52\n")
        self.assertEqual(contact_reasons.friction_of(scene), 0.52)
        (self.folder / "mu.csv").write_text("s,mu\n0,0.2\n1,0.4\n")
        scene.write_text('motion.friction_table = "mu.csv"\n')
        self.assertEqual(contact_reasons.friction_of(scene), 0.4)


if __name__ == "__main__":
    unittest.main()
