#!/usr/bin/python3
"""tools/verification/contact_suite: what it counts, and what it refuses. Reads the program from BEM_CONTACT."""

import os
import subprocess
import sys
import tempfile
import unittest
from importlib.machinery import SourceFileLoader
from importlib.util import module_from_spec, spec_from_loader
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
SUITE = ROOT / "tools/verification/contact_suite"
sys.path.insert(0, str(SUITE.parent))
import contact_finer  # noqa: E402
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


def script(name: str):
    """A program without an ending, as a module."""
    loader = SourceFileLoader(name, str(SUITE.with_name(name)))
    module = module_from_spec(spec_from_loader(name, loader))
    loader.exec_module(module)
    return module


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
        for line in ("| a.inp | 3 | 2 | 2 | 1 | 0 |", "1 of 2 that can be compared agree (50%); with those that agree", "| not looked at | 1 |", "| L = ...:"):
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

    def test_a_case_on_smaller_elements(self):
        """The same rectangle in twice as many elements; a rolling step over one of them becomes two."""
        grid = "\n 3 IPOTCN\n 4 2 -1.5 -0.5 1.0 1.0  MX, MY, XC1, YC1, DX, DY\n"
        first = BALL[:BALL.index("\n -1")].replace("200100", "202100").replace("\n 0.28", "\n 0d 1.0 1000. CHI, DQ, VELOC\n 0.28") + grid
        text, numbers = contact_finer.finer("% a remark\n" + first + first.replace("202100", "002100") + first + " 0 MODULE\n")
        self.assertEqual(numbers, [1, 3, 4])
        self.assertEqual(text.count("8 4 -1.75 -0.75 0.5 0.5"), 4)
        self.assertEqual(text.count("0d 0.5 1000."), 4)
        text, numbers = contact_finer.finer(" 1 MODULE\n 1203100\n 0.4 0.2 1.0 90d0 8.0 4.0  DX, DS, DQREL\n")
        self.assertIn("0.2 0.1 1.0 90d0 8.0 4.0", text)
        self.assertEqual(numbers, [1])

    def test_smaller_elements_of_both_programs(self):
        """On 5 elements across pmax is 2.4 % less than Hertz's, on 10 0.7 %, and here both "programs" are compared on those."""
        suite = script("contact_suite")
        program, known = Path(os.environ["BEM_CONTACT"]), suite.Known()
        known.finer = {("a.inp", 1): {"Fn": 1000, "Fx": 0, "Fy": 0, "pmax": 1001.4}, ("a.inp", 2): {"Fn": 1000, "Fx": 0, "Fy": 0, "pmax": 900}}
        coarse = BALL.replace("20 20  1d-2", "6 6  1d-2")
        (self.folder / "a.inp").write_text(coarse * 3 + " 0 MODULE\n")
        (self.folder / "a.out").write_text("".join(printed(n, 1100.0) for n in (1, 2, 3)))
        cases = suite.cases_of_file(program, self.folder / "a.inp", self.folder, self.folder / "scenes", known)["cases"]
        self.assertEqual([cases[n]["state"] for n in (1, 2, 3)], ["agrees on smaller elements", "differs", "differs"])
        self.assertLess(abs(cases[1]["finer"]["pmax"]), 0.02)

    def test_friction_is_that_of_the_scene(self):
        scene = self.folder / "s.toml"
        scene.write_text("motion.friction = 0.52\n")
        self.assertEqual(contact_reasons.friction_of(scene), 0.52)
        (self.folder / "mu.csv").write_text("s,mu\n0,0.2\n1,0.4\n")
        scene.write_text('motion.friction_table = "mu.csv"\n')
        self.assertEqual(contact_reasons.friction_of(scene), 0.4)


if __name__ == "__main__":
    unittest.main()
