"""bem_contact.conicity: against closed forms and against the program."""

import concurrent.futures
import contextlib
import io
import json
import math
import os
import re
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

    def test_a_map_is_what_the_program_computes(self):
        hollow = str(Path(__file__).parents[2] / "data/bodies/hollow_wheel.txt")
        asked = {"changes": {"position.rail_inclination": 0.025}, "wheels": ["S1002", hollow], "rails": ["60E1", "60E2"],
                 "gauges": [1433, 1435], "amplitude": 2, "noise": 0.01, "draws": 2, "seed": 7}
        out = subprocess.run([os.environ["BEM_CONTACT"], "conicity", "--wheels", "S1002", hollow, "--rails", "60E1", "60E2",
                              "--rail-inclination", "0.025", "--gauges", "1433:1435:2", "--amplitude", "2", "--noise", "0.01",
                              "--draws", "2", "--seed", "7", "--json"], check=True, stdout=subprocess.PIPE).stdout
        expected = json.loads(out)
        with concurrent.futures.ThreadPoolExecutor(2) as threads:
            for executor in (None, threads):
                m = bem_contact.conicity_map(**asked, executor=executor)
                self.assertEqual(m["wheels"], expected["wheels"])
                self.assertEqual(m["rails"], expected["rails"])
                self.assertEqual(set(m["map"]), set(expected["map"]))
                for name, values in expected["map"].items():
                    np.testing.assert_array_equal(m["map"][name], np.array(values, float), name)
        self.assertTrue(np.all(m["map"]["tan_gamma_spread"][:2] > 0))

    def test_the_example_of_the_page(self):
        page = (Path(__file__).parents[2] / "data/tutorial/conicity.md").read_text()
        example = re.search(r"```python\n(import bem_contact\nm = .*?)```", page, re.S)[1]
        printed = io.StringIO()
        with contextlib.redirect_stdout(printed):
            exec(example, {"bem_contact": bem_contact})
        first = printed.getvalue().splitlines()[0].split()
        name, gauge, tan_gamma = re.search(r"the first line: (\S+) (\S+), (\S+)", page).groups()
        self.assertEqual(first[:2], [name, gauge])
        self.assertAlmostEqual(float(first[2]), float(tan_gamma), delta=5e-5)

    def test_a_map_with_the_profiles_of_a_scene(self):
        one = bem_contact.conicity(changes=S1002)
        m = bem_contact.conicity_map({**S1002, "load.force": 8e4})
        self.assertEqual((m["wheels"], m["rails"]), (["S1002"], ["60E1"]))
        np.testing.assert_allclose(m["map"]["tan_gamma"], [one["conicity"]["tan_gamma"][2]], rtol=1e-6)
        np.testing.assert_array_equal(m["map"]["gauge"], [1435])

    def test_wrong_maps(self):
        for wrong in ({"wheels": "S1002"}, {"rails": 3}, {"gauges": 1435}, {"gauges": []}, {"draws": 2.5}):
            with self.assertRaises(TypeError, msg=str(wrong)):
                bem_contact.conicity_map(changes=S1002, **wrong)
        for wrong in ({"noise": -1}, {"noise": 0.01, "draws": 1}, {"noise": 0.01, "seed": -1}, {"amplitude": 60}, {"wheels": ["nosuch"]}):
            with self.assertRaises(bem_contact.InputError, msg=str(wrong)):
                bem_contact.conicity_map(changes=S1002, **wrong)

    def test_wrong_input(self):
        with self.assertRaisesRegex(bem_contact.InputError, "at most 45 mm"):
            bem_contact.conicity(changes=S1002, to=60)
        with self.assertRaisesRegex(bem_contact.InputError, "rail.profile"):
            bem_contact.conicity(changes={"wheel.profile": "S1002"})


if __name__ == "__main__":
    unittest.main()
