"""Stresses and shakedown in a body file's body: `stresses --body`, `shakedown --body`, and [shakedown] body of a study."""

import json
import os
import subprocess
import tempfile
import unittest
from pathlib import Path

import programs

SCENE = """kind = "patch"
solver.model = "halfspace"
[motion]
xi = 1e-3
[load]
force = 1000
[grid]
dx = 0.1
ds = 0.1
mx = 18
ms = 18
[gap]
a = 0.01
b = 0.01
"""


class BodyStresses(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.folder = Path(cls.temporary.name)
        (cls.folder / "block.toml").write_text(programs.SMALL_BLOCK)
        (cls.folder / "scene.toml").write_text(SCENE + '[shakedown]\nbody = "block.toml"\nyield_shear = 250\n')
        (cls.folder / "plain.toml").write_text(SCENE)
        cls.call_ok("solve", cls.folder / "plain.toml", "-o", cls.folder / "result.h5")

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    @classmethod
    def call(cls, *words, program="bem_contact"):
        return subprocess.run([programs.BIN / program, *map(str, words)], capture_output=True, text=True, cwd="/",
                              env=os.environ | {"CONFORMAL_BIN": str(programs.BIN)})

    @classmethod
    def call_ok(cls, *words, program="bem_contact"):
        done = cls.call(*words, program=program)
        if done.returncode:
            raise AssertionError(done.stderr)
        return done.stdout

    def test_stresses_are_those_of_fem_influence(self):
        f = self.folder
        in_body = json.loads(self.call_ok("stresses", f / "result.h5", "--body", f / "block.toml", "--json"))
        self.call_ok(f / "block.toml", "-o", f / "block.msh", program="mesh_body")
        self.call_ok(f / "block.toml", f / "block.msh", "--stresses", f / "by_hand.h5", "--result", f / "result.h5", program="fem_influence")
        by_hand = json.loads(self.call_ok("stresses", f / "by_hand.h5", "--json"))
        self.assertEqual(in_body["patches"], by_hand["patches"])
        self.assertEqual(in_body["found"], by_hand["found"])
        self.assertNotIn("in a half-space.", " ".join(in_body["found"]))

    def test_shakedown_in_the_body_and_in_a_study(self):
        f = self.folder
        flat = json.loads(self.call_ok("shakedown", f / "plain.toml", "--yield-shear", 250, "--json"))
        said = self.call_ok("shakedown", f / "scene.toml")
        self.assertIn("The steel yields once (shakedown factor", said)
        body = json.loads(self.call_ok("shakedown", f / "scene.toml", "--json"))
        self.assertEqual(body["yield_shear"], 250)
        self.assertNotEqual(body["shakedown"], flat["shakedown"])
        self.assertAlmostEqual(body["shakedown"] / flat["shakedown"], 1, delta=0.05)  # a block of 40 mm is nearly a half-space
        self.call_ok("study", f / "scene.toml", "-o", f / "study")
        page = (f / "study" / "study.html").read_text()
        self.assertIn("The steel yields once (shakedown factor", page)

    def test_cases_of_a_collective_are_those_of_single_scenes(self):
        f = self.folder
        (f / "cases.toml").write_text(SCENE + "[sweep]\nload.force = [600, 1000]\n")
        cases = json.loads(self.call_ok("shakedown", f / "cases.toml", "--body", f / "block.toml", "--yield-shear", 250, "--json"))
        flat = json.loads(self.call_ok("shakedown", f / "cases.toml", "--yield-shear", 250, "--json"))
        alone = json.loads(self.call_ok("shakedown", f / "scene.toml", "--body", f / "block.toml", "--json"))
        of_cases, of_halfspace, of_one = ([patch["shakedown"] for patch in one["patches"]] for one in (cases, flat, alone))
        self.assertEqual(len(of_cases), 2)
        self.assertNotEqual(of_cases, of_halfspace)
        self.assertAlmostEqual(of_cases[1], of_one[0], delta=1e-3 * of_one[0])  # another set of waves

    def patches(self, *command):
        return json.loads(self.call_ok(*command, "--json"))["patches"]

    def test_an_influence_file_with_stresses_needs_no_other_program(self):
        f = self.folder
        with_stresses = programs.SMALL_BLOCK + "[stress]\ndepths = 12\ndeepest = 12\n"
        (f / "kernel.toml").write_text(with_stresses)
        self.call_ok(f / "kernel.toml", "-o", f / "kernel.msh", program="mesh_body")
        self.call_ok(f / "kernel.toml", f / "kernel.msh", "-o", f / "kernel.h5", program="fem_influence")
        self.assertFalse(list(f.glob("kernel.h5.*")))  # partial files are gone
        (f / "points.csv").write_text("s,depth\n" + "".join(f"{s},{depth}\n" for s in (-0.25, 0.25, 0.75) for depth in (0.75, 12)))
        solved, kept = (self.patches("stresses", f / "result.h5", "--body", f / body, "--points", f / "points.csv")[0]
                        for body in ("block.toml", "kernel.h5"))
        for name in ("von_mises", "largest_shear"):  # by a mesh this coarse; the two halve its borders differently
            self.assertAlmostEqual(kept[name] / solved[name], 1, delta=0.015)
            self.assertNotEqual(kept[name], kept["halfspace_" + name])

        (f / "cases.toml").write_text(SCENE + "[sweep]\nload.force = [600, 1000]\n")
        flat, solved, kept = ([p["shakedown"] for p in self.patches("shakedown", f / "cases.toml", *words, "--yield-shear", 250)]
                              for words in ((), ("--body", f / "block.toml"), ("--body", f / "kernel.h5")))
        for by_halfspace, by_solution, by_file in zip(flat, solved, kept):
            self.assertNotEqual(by_file, by_halfspace)
            self.assertAlmostEqual(by_file / by_solution, 1, delta=0.005)
        done = self.call("stresses", f / "result.h5", "--body", programs.ROOT / "data/influence/small_rail.h5")
        self.assertEqual((done.returncode, done.stdout), (2, ""), done.stderr)
        self.assertIn("has no stresses of the inside", done.stderr)
        (f / "deep.csv").write_text("s,depth\n0,30\n")
        done = self.call("stresses", f / "result.h5", "--body", f / "kernel.h5", "--points", f / "deep.csv")
        self.assertEqual((done.returncode, done.stdout), (2, ""), done.stderr)
        self.assertIn("to a depth of 12 mm", done.stderr)

    def kernel(self):
        f = self.folder
        if not (f / "shared.h5").exists():
            (f / "shared.toml").write_text(programs.SMALL_BLOCK + "[stress]\ndepths = 8\ndeepest = 8\n")
            self.call_ok(f / "shared.toml", "-o", f / "shared.msh", program="mesh_body")
            self.call_ok(f / "shared.toml", f / "shared.msh", "-o", f / "shared.h5", program="fem_influence")
        return f / "shared.h5"

    def test_a_scene_asks_for_stresses_in_its_body_where_its_strip_is(self):
        f, kernel = self.folder, self.kernel()
        asked = '[strip]\nrail_s0 = %s\n[stresses]\nin = "bodies"\ns = [0.1, 0.3]\ndepths = [0.4, 1, 4]\n'
        in_body = f'rail.influence = "{kernel}"\n' + SCENE + asked
        (f / "points.csv").write_text("s,depth\n" + "".join(f"{s},{depth}\n" for s in (0.7, 0.9) for depth in (0.4, 1, 4)))
        for shift in (0, 0.6):
            (f / "asks.toml").write_text(in_body % shift)
            said = self.call_ok("solve", f / "asks.toml", "-o", f / "asks.h5")
            self.assertIn("in the rail (block", said)
            answer = json.loads(self.call_ok("solve", f / "asks.toml", "--json"))["stresses"]
            rail = answer["rail"]
            self.assertAlmostEqual(rail["s"][0], shift + 0.1, delta=1e-9)
            flat, body = (max(max(max(line) for line in plane) for plane in values) for values in (answer["von_mises"], rail["von_mises"]))
            self.assertNotEqual(flat, body)
            self.assertAlmostEqual(body / flat, 1, delta=0.05)
        by_command = self.patches("stresses", f / "asks.h5", "--body", kernel, "--points", f / "points.csv")[0]
        self.assertAlmostEqual(by_command["s"], 0.8, delta=1e-9)
        self.assertGreater(by_command["von_mises"], 0.98 * body)  # at more places along x, below the same points
        passed = self.patches("shakedown", f / "asks.toml", "--body", kernel)[0]
        self.assertAlmostEqual(passed["s"], 0.6, delta=0.05)  # the place on the body's own arc length

    def test_fatigue_takes_what_lies_below_the_surface_from_the_body(self):
        f, kernel = self.folder, self.kernel()
        cases = "[sweep]\nload.force = [600, 1000]\nweight = [1, 3]\n"
        (f / "weights.toml").write_text(SCENE + f'[fatigue]\nyield_shear = 250\nbody = "{kernel}"\n' + cases)
        (f / "flat.toml").write_text(SCENE + cases)
        flat, body = (json.loads(self.call_ok("fatigue", f / name, "--yield-shear", 250, "--json")) for name in ("flat.toml", "weights.toml"))
        limits = self.patches("shakedown", f / "flat.toml", "--body", kernel, "--yield-shear", 250)
        for without, inside, limit in zip(flat["patches"], body["patches"], limits):
            self.assertEqual(without["FI_surf"], inside["FI_surf"])
            self.assertEqual(without["damage"], inside["damage"])
            self.assertAlmostEqual(inside["shakedown"], limit["shakedown"], delta=1e-9)
            self.assertAlmostEqual(inside["p0_over_k_limit"], inside["shakedown"] * inside["p0_over_k"], delta=1e-9)
            self.assertAlmostEqual(inside["halfspace_von_mises"] / without["von_mises"], 1, delta=0.05)  # by points, and by a search
            self.assertNotEqual(inside["von_mises"], inside["halfspace_von_mises"])
        self.assertIn("shakedown factor", body["found"][0])
        self.assertNotIn("shakedown factor", flat["found"][0])
        self.call_ok("study", f / "weights.toml", "-o", f / "weights")
        self.assertIn("the steel yields", (f / "weights" / "study.html").read_text())
        done = self.call("fatigue", f / "flat.toml", "--body", programs.ROOT / "data/influence/small_rail.h5")
        self.assertEqual((done.returncode, done.stdout), (2, ""), done.stderr)
        self.assertIn("has no stresses of the inside", done.stderr)

    def test_what_cannot_be_answered_is_refused(self):
        f = self.folder
        (f / "sweep.toml").write_text(SCENE + "[sweep]\nload.force = [500, 1000]\n")
        (f / "wrong.toml").write_text(programs.SMALL_BLOCK.replace("block", "cube"))
        (f / "narrow.toml").write_text(programs.SMALL_BLOCK.replace("2.0", "0.5"))
        for words, why in ((["stresses", f / "result.h5", "--body", f / "none.toml"], "There is no body file"),
                           (["stresses", f / "result.h5", "--body", f / "wrong.toml"], "cube"),
                           (["stresses", f / "result.h5", "--body", f / "narrow.toml"], "strip"),
                           (["stresses", f / "result.h5", "--body", f / "block.toml", "--wheel"], "--wheel cannot be given"),
                           (["shakedown", f / "sweep.toml", "--body", f / "none.toml"], "There is no body file"),
                           (["shakedown", f / "sweep.toml", "--body", f / "block.toml", "-o", f / "block.toml"], "block.toml"),
                           (["shakedown", f / "plain.toml", "--body", f / "none.toml"], "There is no body file"),
                           (["shakedown", f / "plain.toml", "--body", f / "block.toml", "-o", f / "block.toml"], "block.toml")):
            done = self.call(*words)
            self.assertEqual((done.returncode, done.stdout), (2, ""), (words, done.stderr))
            self.assertIn(why, done.stderr)
        self.assertEqual((f / "block.toml").read_text(), programs.SMALL_BLOCK)


if __name__ == "__main__":
    unittest.main()
