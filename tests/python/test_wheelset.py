"""bem_contact.wheelset: against the program."""

import json
import os
import subprocess
import unittest
from pathlib import Path

import bem_contact

SCENE = Path(__file__).resolve().parents[2] / "data" / "scenes" / "wheelset.toml"


class Wheelset(unittest.TestCase):
    def test_is_what_the_program_computes(self):
        r = bem_contact.wheelset(SCENE)
        self.assertTrue(r["certified"])
        self.assertAlmostEqual(r["wheelset"]["Fy"], 2e4, delta=0.4)
        self.assertAlmostEqual(r["right"]["track"]["Fy"] + r["left"]["track"]["Fy"], r["wheelset"]["Fy"], delta=1e-6)
        self.assertAlmostEqual(r["left"]["result"].Fy, -r["left"]["track"]["Fy"], delta=1e-6)
        out = subprocess.run([os.environ["BEM_CONTACT"], "wheelset", SCENE, "--json"], check=True,
                             stdout=subprocess.PIPE).stdout
        expected = json.loads(out)
        self.assertEqual(r["wheelset"]["roll"], expected["wheelset"]["roll"])
        for side in ("right", "left"):
            for name, value in expected[side]["track"].items():
                self.assertEqual(r[side]["track"][name], value, name)

    def test_wrong_input(self):
        with self.assertRaisesRegex(bem_contact.InputError, "of one wheel"):
            bem_contact.wheelset(SCENE.with_name("conformal_small.toml"))
        with self.assertRaisesRegex(bem_contact.InputError, "bem_contact wheelset"):
            bem_contact.solve(SCENE)


if __name__ == "__main__":
    unittest.main()
