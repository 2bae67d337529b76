#!/usr/bin/env python3
"""from-contact with whole input files: each number of a case is in its scene, or the case has none; and input files that
are broken in many ways. Reads the program from BEM_CONTACT."""

import json
import os
import random
import re
import subprocess
import tempfile
import tomllib
import unittest
from pathlib import Path

PROGRAM = os.environ["BEM_CONTACT"]
ROOT = Path(__file__).resolve().parents[2]
FOUND = ROOT / ".." / "shared" / "data" / "found"

BALL = """ 3 MODULE
 203100   P-B-T-N-F-S
 022020   L-D-C-M-Z-E
 0101111  H-G-I-A-O-W-R
 5000.  -0.001  0.0005  0.0004    FN, CKSI, CETA, CPHI
 0.3 0.3                    FSTAT, FKIN
 0d 0.2 30000.              CHI, DQ, VELOC
 0.28 0.28 82000. 82000.    POISS, GG
 1                          IPOTCN
 40 40 -4.0 -4.0 0.2 0.2    MX, MY, XL, YL, DX, DY
 1 1                        IBASE, IPLAN
 0.01 0.0 0.01 0 0 0        B1..B6
"""
END = " 0 MODULE\n"


def run(*arguments: str) -> subprocess.CompletedProcess:
    return subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True, timeout=300)


def flat(table: dict, before: str = "") -> dict:
    """{"load.force": 5000}"""
    out = {}
    for key, value in table.items():
        out.update(flat(value, f"{before}{key}.") if isinstance(value, dict) else {before + key: value})
    return out


class Conversion(unittest.TestCase):
    def setUp(self):
        self._folder = tempfile.TemporaryDirectory()
        self.folder = Path(self._folder.name)

    def tearDown(self):
        self._folder.cleanup()

    def convert(self, file: Path) -> dict:
        done = run("from-contact", file, "-o", self.folder / file.stem, "--json")
        self.assertIn(done.returncode, (0, 2), done.stderr)
        self.assertTrue(done.stdout, done.stderr)
        return json.loads(done.stdout)

    def convert_text(self, text: str) -> list:
        file = self.folder / "x.inp"
        file.write_text(text)
        return list(self.convert(file)["cases"].values())

    def keys(self, entry: dict, stem: str = "x") -> dict:
        self.assertTrue(entry["scene"], entry["refused"])
        return flat(tomllib.loads((self.folder / stem / entry["scene"]).read_text()))

    def solve(self, entry: dict, stem: str = "x") -> dict:
        self.assertTrue(entry["scene"], entry["refused"])
        done = run("solve", self.folder / stem / entry["scene"], "--json")
        self.assertEqual(done.returncode, 0, done.stderr)
        return json.loads(done.stdout)["quantities"]

    def refused(self, entry: dict, words: str):
        self.assertEqual(entry["scene"], "")
        self.assertIn(words, " ".join(entry["refused"]))


class FromContact(Conversion):
    def test_a_grid_off_the_middle(self):
        """w = CKSI - CPHI y: the same contact with its origin elsewhere has other creepages there, and the same forces."""
        moved = BALL.replace("-4.0 -4.0 0.2 0.2", "-3.0 -1.0 0.2 0.2").replace("0.01 0.0 0.01 0 0 0", "0.01 0 0.01 -0.02 -0.06 0.1")
        here, there = self.convert_text(BALL + moved + END)
        a, b = self.keys(here), self.keys(there)
        self.assertAlmostEqual(b["motion.xi"] - a["motion.xi"], 0.0004 * 3)
        self.assertAlmostEqual(b["motion.eta"] - a["motion.eta"], -0.0004 * 1)
        spun = moved.replace("0.0004    FN", "0.0004 1.0 3.0 FN")  # SPINXO, SPINYO: the spin is about the contact again
        again = self.keys(self.convert_text(BALL + spun + END)[1])
        self.assertEqual([again[f"motion.{k}"] for k in ("xi", "eta", "phi")], [a[f"motion.{k}"] for k in ("xi", "eta", "phi")])

    def test_rolling_backwards_is_the_same_turned(self):
        """CHI = 180 degrees: with the other signs of creepages it is the same contact, seen from its other end."""
        back = BALL.replace(" 0d 0.2", " 180d 0.2").replace("-0.001  0.0005", "0.001  -0.0005")
        ahead, turned = self.convert_text(BALL + back + END)
        a, b = self.keys(ahead), self.keys(turned)
        self.assertEqual({k: v for k, v in a.items()}, b)
        self.assertIn("the other way", turned["left_out"][0])
        skew = self.convert_text(BALL.replace(" 0d 0.2", " 20d 0.2") + END)[0]
        self.refused(skew, "CHI")

    def test_forces_relative_to_a_normal_force_that_is_found(self):
        """F = 1 with N = 0: FX is a share of friction times the normal force at this approach."""
        given = BALL.replace("203100 ", "203010 ").replace(" 5000.  -0.001", " 0.02  -0.5")
        entry = self.convert_text(given + END)[0]
        found = self.solve(entry)
        self.assertAlmostEqual(found["Fx"] / (0.3 * found["Fz"]), -0.5, places=5)
        unlike = given.replace("0.28 0.28 82000. 82000.", "0.28 0.28 82000. 820.")
        self.refused(self.convert_text(unlike + END)[0], "depends on it")

    def test_a_transient_goes_on_from_a_shift(self):
        """From Cattaneo to Carter: rolling begins with the tractions of a shift (motion.start_table)."""
        shift = BALL.replace("203100 ", "201110 ").replace("-0.001  0.0005  0.0004", "-0.6 0. 0.").replace(" 0d 0.2 30000.              CHI, DQ, VELOC\n", "")
        rolls = (" 3 MODULE\n 002110\n 102000\n 0101111\n 5000. -0.6 0. 0.\n 0d 0.2 30000.\n 0.28 0.28 82000. 82000.\n"
                 " 3 MODULE\n 002110\n 100000\n 0101111\n 5000. -0.6 0. 0.\n")
        first, second = self.convert_text(shift + rolls + END)
        self.assertEqual((second["first"], second["last"]), (2, 3))
        self.assertIn("motion.start_table", self.keys(second))
        self.assertAlmostEqual(self.solve(second)["Fx"], -0.6 * 0.3 * 5000, places=2)

    def test_what_has_no_counterpart_is_refused_by_its_digit(self):
        changes = {
            "B = 3": (("203100 ", "233100 "),), "M = 1": (("022020 ", "022120 "), ("POISS, GG\n", "\n 1 1 1 1\n")),
            "M = 3": (("022020 ", "022320 "), ("POISS, GG\n", "\n 1 1 1\n")),
            "TAU_C0": (("022020 ", "022420 "), ("POISS, GG\n", "\n 8200. 0.05 10. 0.\n")),
            "IPLAN = 2": ((" 1 1      ", " 1 2      "), ("0 0 0        B1..B6", "0 0 0\n 1 0 1 0 0 -9\n")),
            "FSTAT = 0.3 and FKIN = 0.2": (("0.3 0.3 ", "0.3 0.2 "),),
            "MEMDST": (("022020 ", "422020 "), ("0.3 0.3 ", "0.2 0.1 100. 0 0\n 0.5 1 ")),
            "L = 2": (("022020 ", "222020 "), ("0.3 0.3 ", "0.2 0.1 100. 0 0\n 0 1 ")),
            "R = 3": (("0101111 ", "0101113 "),), "M2": (("022020 ", "022020 2 "), ("POISS, GG\n", "\n 1 0 1 1\n")),
            "DQ = 0.4": (("203100 ", "202100 "), (" 0d 0.2 ", " 0d 0.4 ")),
        }
        for words, replaced in changes.items():
            text = BALL
            for old, new in replaced:
                self.assertIn(old, text, words)
                text = text.replace(old, new)
            with self.subTest(words):
                self.refused(self.convert_text(text + END)[0], words)

    def test_a_number_in_the_place_of_a_remark_is_said(self):
        entry = self.convert_text(BALL.replace("0.3 0.3   ", "0.3 0.3 7 ") + END)[0]
        self.assertIn("'7' stands behind FSTAT, FKIN", " ".join(entry["left_out"]))

    def test_two_hundred_mutated_files(self):
        """A file with one word changed, removed or doubled: an error with its line, or a reading that says what it took."""
        rng = random.Random(66)
        words = [m.span() for m in re.finditer(r"[^\s,]+", BALL)]
        broken = 0
        for _ in range(200):
            begin, end = rng.choice(words)
            new = rng.choice(["", "x", "-", "1e999", "0.1-07", "nan", "'", "%", "9999999999", "-1", "1,2", BALL[begin:end] * 2])
            file = self.folder / "m.inp"
            file.write_text(BALL[:begin] + new + BALL[end:] + BALL + END)
            done = run("from-contact", file, "-o", self.folder / "m", "--json")
            self.assertIn(done.returncode, (0, 2), f"{file.read_text()}\n{done.stderr}")
            result = json.loads(done.stdout)
            if result["broken"]:
                broken += 1
                self.assertRegex(result["broken"], r"m\.inp:\d+: |has no case", file.read_text())
        self.assertGreater(broken, 40)


@unittest.skipUnless(FOUND.exists(), "the shared data are not at hand")
class Found(Conversion):
    """Input files that gave another problem without a word (each folder's README says which)."""

    def entries(self, folder: str, file: str) -> list:
        return list(self.convert(FOUND / folder / f"{file}.inp")["cases"].values())

    def test_curvature_of_the_track(self):
        straight, curve = self.entries("door-02-from-contact-curv", "curv")
        self.assertNotIn("track.curve_radius", self.keys(straight, "curv"))
        self.assertAlmostEqual(self.solve(curve, "curv")["Fx"], -3000, delta=30)

    def test_a_grid_off_the_origin(self):
        off = self.entries("door-03-from-contact-grid-offset", "off")[0]
        centred = self.entries("door-03-from-contact-grid-offset", "cen")[0]
        a, b = self.solve(off, "off"), self.solve(centred, "cen")
        self.assertAlmostEqual(abs(a["Fx"]), 506.0, delta=0.5)
        self.assertAlmostEqual(a["Fs"], -224.5, delta=0.5)
        self.assertAlmostEqual(a["Fx"], b["Fx"], delta=0.01)

    def test_the_height_of_the_wheelset(self):
        entry = self.entries("door-04-from-contact-height", "height")[0]
        self.assertEqual(self.keys(entry, "height")["position.vertical"], 0.128)
        found = self.solve(entry, "height")
        self.assertAlmostEqual(found["Fz"] / 55364, 1, delta=2e-3)
        self.assertAlmostEqual(found["pmax"] / 1276, 1, delta=2e-3)

    def test_a_layer_and_a_sheet_end_with_their_digit(self):
        layered, plain = self.entries("door-05-from-contact-kept-layer", "layer")
        self.assertIn("layer.thickness", self.keys(layered, "layer"))
        self.assertAlmostEqual(self.solve(plain, "layer")["Fx"], 10704, delta=20)
        sheet, plain = self.entries("door-05-from-contact-kept-layer", "sheet")
        self.assertIn("layer.normal_compliance", self.keys(sheet, "sheet"))
        self.assertAlmostEqual(self.solve(plain, "sheet")["pmax"] / 1186, 1, delta=0.01)

    def test_a_place_ends_with_the_next_one(self):
        absolute, gauge = self.entries("door-06-from-contact-kept-place", "gauge")
        self.assertEqual(self.keys(absolute, "gauge")["rail.place"], "absolute")
        self.assertEqual(self.keys(gauge, "gauge")["position.gauge"], 1445)
        found = self.solve(gauge, "gauge")
        self.assertAlmostEqual(found["pmax"] / 898, 1, delta=2e-3)
        self.assertAlmostEqual(found["Fx"] / 3634, 1, delta=5e-3)

    def test_a_mirrored_profile(self):
        entry = self.entries("door-07-from-contact-mirrory", "mirror")[0]
        if entry["scene"]:
            self.assertIs(self.keys(entry, "mirror")["wheel.mirror"], True)

    def test_result_elements(self):
        third = self.entries("door-08-from-contact-result-elements", "reid")[2]
        found = self.solve(third, "reid")
        self.assertAlmostEqual(found["Fx"], 1500, delta=1)
        self.assertAlmostEqual(found["pmax"] / 1709, 1, delta=2e-3)

    def test_the_scale_of_a_profile(self):
        entry = self.entries("door-09-from-contact-scale", "scale")[0]
        self.assertEqual(self.keys(entry, "scale")["rail.unit"], "cm")
        self.solve(entry, "scale")

    def test_a_shift_of_the_wheelset(self):
        entry = self.entries("door-10-from-contact-shift", "shift")[0]
        self.assertAlmostEqual(self.solve(entry, "shift")["Fx"] / 18006, 1, delta=2e-3)

    def test_points_below_the_surface(self):
        first, second = self.entries("door-11-from-contact-subsurface", "sub")
        self.assertAlmostEqual(self.solve(first, "sub")["pmax"] / 999.6, 1, delta=1e-3)
        # D = 1 forms the elements anew for the larger load
        self.assertAlmostEqual(self.solve(second, "sub")["pmax"] / 1260.9, 1, delta=2e-3)

    def test_tread_and_flange_root(self):
        entry = self.entries("door-12-from-contact-two-patches", "two")[0]
        self.assertAlmostEqual(self.solve(entry, "two")["Fy"] / 8818, 1, delta=0.02)

    def test_a_law_of_friction_that_is_kept(self):
        """All of the law is kept, and the heat that it depends on: nothing is a default."""
        second = self.entries("door-17-from-contact-law-kept", "r3_law_kept")[1]
        keys = self.keys(second, "r3_law_kept")
        expected = {"motion.friction": 0.4, "temperature.hot_friction": 0.2, "temperature.falls_from": 0, "temperature.falls_to": 200,
                    "temperature.rail": 0, "temperature.wheel": 0, "temperature.rail_conductivity": 50,
                    "temperature.wheel_density": 7850, "temperature.rail_heat_capacity": 450}
        self.assertEqual({key: keys[key] for key in expected}, expected)
        found = self.solve(second, "r3_law_kept")
        self.assertLess(found["Fx"], 0.3 * found["Fz"])

    def test_a_force_and_then_a_creepage(self):
        for entry in self.entries("door-18-from-contact-force-then-creepage", "r10_force_then_creepage"):
            self.assertTrue(entry["scene"] or entry["refused"])


if __name__ == "__main__":
    unittest.main()
