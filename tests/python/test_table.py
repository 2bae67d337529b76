"""bem_contact.table: against single solutions, and against the file that it writes."""

import tempfile
import unittest
from pathlib import Path

import numpy as np

import bem_contact

ROOT = Path(__file__).resolve().parents[2]
SCENE = {"kind": "patch", "gap": {"a": 1e-3, "b": 2e-3}, "grid": {"dx": 0.5, "ds": 0.5, "mx": 20, "ms": 16},
         "motion": {"xi": 1e-3}, "solver.model": "halfspace"}


class TableOfForces(unittest.TestCase):
    def test_a_scene(self):
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / "t.h5"
            t = bem_contact.table(SCENE, {"motion.xi": [0, 1e-3, 2e-3], "load.force": [2e3, 4e3]}, tolerance=0.1,
                                  hold=["Fx", "pmax"], output=file)
            own = bem_contact.read_table(file)
        self.assertEqual(list(t["axes"]), ["motion.xi", "load.force"])
        self.assertEqual(t["values"]["Fx"].shape, tuple(len(a) for a in t["axes"].values()))
        np.testing.assert_array_equal(own.values["Fx"], t["values"]["Fx"])
        for name in ("Fx", "pmax"):
            self.assertLessEqual(t["errors"][name]["interpolation"], 0.1 * t["errors"][name]["scale"])
        alone = bem_contact.solve(SCENE, {"motion.xi": 1e-3, "load.force": 4e3})
        self.assertAlmostEqual(own.look_up((1e-3, 4e3))["Fx"], alone.Fx, delta=1e-3 * 4e3)
        many = own.look_up([[[0, 2e3], [1e-3, 4e3]], [[2e-3, 2e3], [5e-4, 3e3]]])["Fx"]
        self.assertEqual(many.shape, (2, 2))
        self.assertEqual(own.look_up(np.zeros((0, 2)))["Fx"].shape, (0,))
        self.assertEqual(many[1, 1], own.look_up((5e-4, 3e3))["Fx"])
        self.assertEqual(own.errors["pmax"]["interpolation"], t["errors"]["pmax"]["interpolation"])
        self.assertIsNone(own.creep_scale)
        for wrong in ((3e-3, 3e3), (1e-3, float("nan")), (1e-3,), 1e-3, [], np.zeros((3, 0)), np.zeros((0, 3))):
            with self.assertRaisesRegex(bem_contact.InputError, "outside the table|not in the table"):
                own.look_up(wrong)
        with self.assertRaisesRegex(bem_contact.InputError, "the table is one of a scene"):
            own.creep_forces(6, 4, 8e4, 3e4)
        with self.assertRaisesRegex(bem_contact.InputError, "no_table.h5"):
            bem_contact.read_table("no_table.h5")
        self.assertEqual(t["units"]["load.force"], "N")

    def test_creep_forces(self):
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / "t.h5"
            t = bem_contact.table(tolerance=0.29, elements=6, ratio=(0.8, 1.25), output=file)
            own = bem_contact.read_table(file)
        slipping = own.creep_forces(5, 5, 8e4, 3e4, xi=-1e3)
        self.assertAlmostEqual(slipping["Fx"], -3e4, delta=1)  # full slip: the friction bound
        self.assertAlmostEqual(slipping["errors"]["Fx"], 3e4 * t["errors"]["Fx"]["stated"], delta=1e-6)
        for place, wrong in ((0, "inf"), (1, "nan"), (2, "inf"), (3, "inf"), (4, "inf"), (5, "nan"), (2, "1e308")):
            numbers = [5, 5, 8e4, 3e4, 1e-3, 0, 0]
            numbers[place] = float(wrong)
            with self.assertRaisesRegex(bem_contact.InputError, "must be positive and finite|the largest number"):
                own.creep_forces(*numbers)
        self.assertEqual(list(t["values"]), ["Fx", "Fy", "Mz"])
        self.assertLess(t["errors"]["Mz"]["interpolation"], 0.29)
        self.assertAlmostEqual(t["creep_scale"]["C11"][len(t["creep_scale"]["C11"]) // 2], 4.2, delta=0.2)

    def test_wrong_input(self):
        with self.assertRaisesRegex(bem_contact.InputError, "describes no table"):
            bem_contact.table(ROOT / "data/scenes/steady_rolling.toml")
        with self.assertRaisesRegex(bem_contact.InputError, "Give a scene"):
            bem_contact.table(axes={"load.force": [1e3, 2e3]})
        with self.assertRaisesRegex(TypeError, "no list of numbers"):
            bem_contact.table(SCENE, {"load.force": 1e3})
        with self.assertRaisesRegex(bem_contact.ConvergenceError, "--most-points"):
            bem_contact.table(SCENE, {"motion.xi": [-2e-2, 0, 2e-2], "load.force": [2e3, 4e3]}, most_points=8)


if __name__ == "__main__":
    unittest.main()
