"""bem_contact.creep_curves: against single solutions and against the program."""

import json
import os
import subprocess
import tempfile
import unittest
from pathlib import Path

import numpy as np

import bem_contact

SCENE = Path(__file__).resolve().parents[2] / "data" / "scenes" / "steady_rolling.toml"


class CreepCurves(unittest.TestCase):
    def test_a_point_is_a_solution(self):
        r = bem_contact.creep_curves(SCENE, eta=np.array([0.0, 1e-3]))
        self.assertTrue(r["certified"])
        self.assertEqual(list(r["curves"]), ["eta"])
        alone = bem_contact.solve(SCENE, {"motion.eta": 1e-3})
        self.assertAlmostEqual(r["curves"]["eta"]["Fs"][1], alone.Fs, delta=1e-5 * r["bound"])
        self.assertAlmostEqual(r["forces"][0], bem_contact.solve(SCENE).Fx, delta=1e-5 * r["bound"])

    def test_slopes_are_near_kalkers(self):
        r = bem_contact.creep_curves(SCENE, xi=[0.0, 1e-5])
        for f, k in ((0, 0), (1, 1), (1, 2), (2, 1), (2, 2)):
            self.assertAlmostEqual(r["slopes"][f, k] / r["kalker"][f, k], 1, delta=0.015)

    def test_is_what_the_program_computes(self):
        r = bem_contact.creep_curves(SCENE, {"motion.friction": 0.3}, "halfspace", xi=[0, 1e-3, 2e-3])
        out = subprocess.run([os.environ["BEM_CONTACT"], "creep-curves", SCENE, "--xi", "0:0.002:3", "--json"], check=True,
                             stdout=subprocess.PIPE).stdout
        expected = json.loads(out)
        for name in ("slopes", "sensitivities", "forces"):
            np.testing.assert_allclose(r[name], expected[name], rtol=1e-12)
        for name, values in expected["curves"]["xi"].items():
            np.testing.assert_allclose(r["curves"]["xi"][name], np.array(values, float), rtol=1e-12, err_msg=name)

    def test_beside_measured_forces(self):
        with tempfile.TemporaryDirectory() as folder:
            points = Path(folder, "points.csv")
            points.write_text("xi,Fx\n1e-3,700\n2e-3,1000\n")
            r = bem_contact.creep_curves(SCENE, xi=[0, 1e-3], measured=points)
            out = subprocess.run([os.environ["BEM_CONTACT"], "creep-curves", SCENE, "--xi", "0:0.001:2", "--measured", points, "--json"],
                                 check=True, stdout=subprocess.PIPE).stdout
            points.write_text("xi,Fz\n1e-3,700\n")
            with self.assertRaisesRegex(bem_contact.InputError, "its columns are xi, Fz"):
                bem_contact.creep_curves(SCENE, measured=points)
        expected = json.loads(out)["measured"]
        self.assertNotIn("scatter", r["measured"]["points"])
        self.assertEqual(r["measured"]["force"], "Fx")
        for name, values in expected["points"].items():
            np.testing.assert_allclose(r["measured"]["points"][name], np.array(values, float), rtol=1e-12, err_msg=name)
        np.testing.assert_allclose(r["measured"]["points"]["difference"], r["measured"]["points"]["computed"] - [700, 1000])

    def test_wrong_input(self):
        with self.assertRaisesRegex(TypeError, "no list of numbers"):
            bem_contact.creep_curves(SCENE, xi=0.1)
        with self.assertRaisesRegex(bem_contact.InputError, "no friction"):
            bem_contact.creep_curves(SCENE.with_name("hertz.toml"))


if __name__ == "__main__":
    unittest.main()
