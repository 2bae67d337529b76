"""bem_contact.conicity: against closed forms and against the program."""

import json
import math
import os
import subprocess
import tempfile
import unittest
from pathlib import Path

import numpy as np

import bem_contact

S1002 = {"wheel.profile": "S1002", "rail.profile": "60E1", "position.rail_inclination": 0.025}


class Conicity(unittest.TestCase):
    def test_a_cone(self):
        with tempfile.TemporaryDirectory() as folder:
            cone = Path(folder) / "cone.txt"
            cone.write_text("60 -3\n30 -1.5\n0 0\n-30 1.5\n-60 3\n")
            r = bem_contact.conicity(changes={"wheel.profile": str(cone), "rail.profile": "60E1"}, to=5)
        np.testing.assert_allclose(r["conicity"]["tan_gamma"], 0.05, rtol=1e-5)
        np.testing.assert_allclose(r["conicity"]["wavelength"], 2 * math.pi * math.sqrt(750 * 460 / 0.05), rtol=1e-5)
        np.testing.assert_allclose(r["function"]["difference"], 0.1 * r["function"]["lateral"], atol=1e-6)

    def test_is_what_the_program_computes(self):
        r = bem_contact.conicity(changes=S1002, left_wheel="S1002", roll=True, to=4, step=0.5)
        out = subprocess.run([os.environ["BEM_CONTACT"], "conicity", "--wheel", "S1002", "--rail", "60E1", "--rail-inclination", "0.025",
                              "--roll", "--to", "4", "--step", "0.5", "--json"], check=True, stdout=subprocess.PIPE).stdout
        expected = json.loads(out)
        for group in ("function", "conicity"):
            self.assertEqual(set(r[group]), set(expected[group]))
            for name, values in expected[group].items():
                np.testing.assert_array_equal(r[group][name], np.array(values, float), name)

    def test_wrong_input(self):
        with self.assertRaisesRegex(bem_contact.InputError, "at most 45 mm"):
            bem_contact.conicity(changes=S1002, to=60)
        with self.assertRaisesRegex(bem_contact.InputError, "rail.profile"):
            bem_contact.conicity(changes={"wheel.profile": "S1002"})


if __name__ == "__main__":
    unittest.main()
