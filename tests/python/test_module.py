"""The Python module: as a user imports it, against closed forms and against the program."""

import json
import os
import subprocess
import threading
import unittest
from pathlib import Path

import numpy as np

import bem_contact

SCENES = Path(__file__).resolve().parents[2] / "data" / "scenes"
CORNER = SCENES / "conformal_small.toml"


class Module(unittest.TestCase):
    def test_hertz(self):
        r = bem_contact.solve(SCENES / "hertz.toml", model="halfspace")
        self.assertTrue(r.certified)
        self.assertAlmostEqual(r.pmax / 1237.56, 1, delta=5e-3)
        self.assertAlmostEqual(r.approach / 0.104119, 1, delta=2e-3)
        self.assertEqual(r.p_n.shape, (len(r.s), len(r.x)))
        area = (r.x[1] - r.x[0]) * (r.s[1] - r.s[0])
        self.assertAlmostEqual(r.p_n.sum() * area, 1e5, delta=1e-2)
        self.assertAlmostEqual((r.state > 0).sum() * area, r.area, delta=1e-9)
        self.assertFalse(r.slip_x.any())

    def test_is_what_the_program_computes(self):
        changes = {"position.lateral": np.float32(6.5) - np.float64(0.1), "load.force": 80000, "grid.planar": False}
        r = bem_contact.solve(str(CORNER), changes, "fem")
        text = CORNER.read_text().replace("lateral = 6.6", "lateral = 6.4").replace("force = 1e5", "force = 8e4")
        scene = CORNER.with_name("changed_by_test.toml")
        scene.write_text(text)
        try:
            out = subprocess.run([os.environ["BEM_CONTACT"], "solve", scene, "--json", "--model", "fem"],
                                 check=True, stdout=subprocess.PIPE).stdout
        finally:
            scene.unlink()
        expected = json.loads(out)
        for name in ("Fx", "Fy", "Fz", "Fs", "Mz", "friction_power"):
            self.assertAlmostEqual(getattr(r, name), expected["totals"][name], delta=1e-9 * r.Fz)
        for name in ("pmax", "area", "approach", "model"):
            self.assertEqual(getattr(r, name), expected[name])
        self.assertEqual(len(r.patches), len(expected["patches"]))
        self.assertEqual(r.discretisation, expected["certificate"]["discretisation"])
        for name in ("pmax_error", "area_error", "approach_error"):
            self.assertEqual(getattr(r, name), expected[name], name)
        self.assertEqual(r.Fx_error, expected["totals"]["Fx_error"])
        self.assertEqual(r.patches[0]["Fn_error"], expected["patches"][0]["Fn_error"])
        self.assertEqual(r.converges_with_elements, expected["converges_with_elements"])
        # Fz from the fields
        area = (r.x[1] - r.x[0]) * (r.s[1] - r.s[0])
        fz = (r.p_n * np.cos(r.delta)[:, None] + r.p_s * np.sin(r.delta)[:, None]).sum() * area
        self.assertAlmostEqual(fz, 8e4, delta=0.1)

    def test_every_door_gives_the_same(self):
        """The program, solve() and Sequence: with the scene's own elements, a number of elements, an accuracy."""
        for grid in ({}, {"grid.elements": 300}, {"grid.accuracy": 0.02}):
            lines = "".join(f"{key.removeprefix('grid.')} = {value}\n" for key, value in grid.items())
            text = CORNER.read_text().replace("lateral = 6.6", "lateral = 6.4")
            scene = CORNER.with_name("doors_of_test.toml")
            scene.write_text(text + lines)  # its last table is [grid]
            try:
                expected = json.loads(subprocess.run(
                    [os.environ["BEM_CONTACT"], "solve", scene, "--json", "--model", "halfspace"],
                    check=True, stdout=subprocess.PIPE).stdout)
            finally:
                scene.unlink()
            changes = {"position.lateral": 6.4, **grid}
            for r in (bem_contact.solve(CORNER, changes, "halfspace"),
                      bem_contact.Sequence(CORNER).solve(changes, "halfspace")):
                self.assertEqual(r.pmax, expected["pmax"], grid)
                self.assertEqual(r.Fx, expected["totals"]["Fx"], grid)
                self.assertEqual(list(r.p_n.shape), [expected["grid"]["ms"], expected["grid"]["mx"]], grid)

    def test_a_sequence_finds_the_same(self):
        sequence = bem_contact.Sequence(CORNER)
        for lateral in (0.0, 3.0, 3.2, 6.7):
            changes = {"position.lateral": lateral}
            r, alone = (of(changes, model="halfspace") for of in
                        (sequence.solve, lambda *a, **k: bem_contact.solve(CORNER, *a, **k)))
            self.assertTrue(r.certified)
            self.assertAlmostEqual(r.Fy, alone.Fy, delta=1e-5 * alone.Fz)
            self.assertAlmostEqual(r.Fx, alone.Fx, delta=1e-4 * alone.Fz)

    def test_a_history(self):
        r = bem_contact.solve(SCENES / "cattaneo.toml")
        self.assertEqual(len(r.history["Fx"]), len(r.history["approach"]))
        self.assertEqual(r.history["Fx"][-1], r.Fx)

    def test_wrong_input(self):
        def message(*arguments, **named):
            with self.assertRaises(ValueError) as caught:
                bem_contact.solve(*arguments, **named)
            self.assertIsInstance(caught.exception, bem_contact.InputError)
            return str(caught.exception)

        self.assertIn("position.lateral", message(CORNER, {"position.laterol": 1.0}))
        self.assertIn("no/such.toml", message("no/such.toml"))
        self.assertIn("mu", message(CORNER, model="mu"))
        self.assertRegex(message(CORNER, {"motion.friction": "much"}), r"toml: motion.friction is text")
        with self.assertRaisesRegex(TypeError, "motion.friction"):
            bem_contact.solve(CORNER, {"motion.friction": None})

    def test_threads(self):
        found = [None] * 4

        def solve(i):
            found[i] = bem_contact.solve(CORNER, {"position.lateral": 1.0 * i}, "halfspace").Fy

        threads = [threading.Thread(target=solve, args=(i,)) for i in range(4)]
        for t in threads:
            t.start()
        for t in threads:
            t.join()
        for i, fy in enumerate(found):
            self.assertEqual(fy, bem_contact.solve(CORNER, {"position.lateral": 1.0 * i}, "halfspace").Fy)


if __name__ == "__main__":
    unittest.main()
