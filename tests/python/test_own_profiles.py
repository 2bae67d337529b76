"""bem_contact.Profile and standards: an own profile as arrays, wherever a profile file goes."""

import ast
import json
import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import numpy as np

import bem_contact

ROOT = Path(__file__).resolve().parents[2]
SCENE = {"rail": {"profile": "60E1"}, "wheel": {"profile": "S1002"}, "load": {"force": 8e4}, "grid": {"dx": 1.0, "ds": 0.5},
         "position": {"rail_inclination": 0.025}}


def points(standard, step=0.2):
    p = bem_contact.profile(standard, step=step)
    return p["y"], p["z"]


class OwnProfiles(unittest.TestCase):
    def test_are_the_same_as_a_file_with_these_points(self):
        y, z = points("S1002")
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / "wheel.txt"
            file.write_text("".join(f"{float(a)!r} {float(b)!r}\n" for a, b in zip(y, z)))
            from_file = bem_contact.solve(SCENE, {"wheel.profile": str(file)})
        own = bem_contact.Profile(y, z, kind="wheel")
        for result in (bem_contact.solve(SCENE, {"wheel.profile": own}),
                       bem_contact.solve({**SCENE, "wheel": {"profile": own}}),
                       bem_contact.Sequence(SCENE).solve({"wheel.profile": own})):
            self.assertEqual((result.pmax, result.area, result.Fx), (from_file.pmax, from_file.area, from_file.Fx))

    def test_go_wherever_a_file_goes(self):
        rail = bem_contact.Profile(*points("60E1"), kind="rail")
        wheel = bem_contact.Profile(list(points("S1002")[0]), list(points("S1002")[1]), "wheel")
        self.assertEqual(bem_contact.profile(rail)["kind"], "rail")
        standard = bem_contact.conicity(changes={"wheel.profile": "S1002", "rail.profile": "60E1", "position.rail_inclination": 0.025})
        own = bem_contact.conicity(changes={"wheel.profile": wheel, "rail.profile": rail, "position.rail_inclination": 0.025},
                                   left_wheel=wheel, left_rail=rail)
        np.testing.assert_allclose(own["conicity"]["tan_gamma"], standard["conicity"]["tan_gamma"], rtol=0.02)
        sweep = bem_contact.sweep({**SCENE, "wheel": {"profile": wheel}, "sweep": {"position.lateral": [0.0, 1.0]}})
        self.assertEqual(list(sweep["status"]), ["certified"] * 2)
        self.assertTrue(bem_contact.check({**SCENE, "rail": {"profile": rail}})["lines"])

    def test_the_same_points_are_the_same_file(self):
        y, z = points("60E1")
        one, two = bem_contact.Profile(y, z, "rail"), bem_contact.Profile(np.asarray(y), tuple(z), "rail")
        self.assertEqual(os.fspath(one), os.fspath(two))
        self.assertNotEqual(os.fspath(one), os.fspath(bem_contact.Profile(y + 1e-9, z, "rail")))

    def test_refuse_what_is_no_profile(self):
        for arguments, words in ((([0, 1], [0], "rail"), "there are 2 y and 1 z"), (([0], [0], "sleeper"), "no kind of profiles"),
                                 ((["a"], [0], "rail"), "no lists of numbers"), ((1.0, 2.0, "rail"), "no lists of numbers")):
            with self.assertRaisesRegex(bem_contact.InputError, words):
                bem_contact.Profile(*arguments)
        with self.assertRaisesRegex(bem_contact.InputError, "needs at least 3"):
            bem_contact.profile(bem_contact.Profile([0, 1], [0, 0], "rail"))


class Sections(unittest.TestCase):
    def test_that_are_all_equal_are_the_profile(self):
        rail = bem_contact.Profile(*points("60E1"), kind="rail")
        one = bem_contact.solve(SCENE, {"rail.profile": rail})
        for features, off in ((None, 1e-7), ([[0, 60, 9999]] * 3, 1e-5)):  # along a line two splines meet
            sections = bem_contact.Sections([0, 40, 100], [rail] * 3, features)
            r = bem_contact.solve({**SCENE, "position": {**SCENE["position"], "along": 55.0}}, {"rail.profile": sections})
            self.assertAlmostEqual(r.pmax / one.pmax, 1, delta=off)
            self.assertAlmostEqual(r.vertical, one.vertical, delta=1e-6)

    def test_of_standards_and_of_wheels(self):
        scene = {**SCENE, "position": {**SCENE["position"], "along": 55.0}}
        one = bem_contact.solve(SCENE, {"rail.profile": "60E1"})
        for key, sections in (("rail.profile", bem_contact.Sections([0, 40, 100], ["60E1"] * 3)),
                              ("wheel.profile", bem_contact.Sections([-2, 0, 2], ["S1002"] * 3, kind="wheel"))):
            r = bem_contact.solve(scene, {"rail.profile": "60E1", key: sections})
            self.assertAlmostEqual(r.pmax / one.pmax, 1, delta=1e-7)
            self.assertAlmostEqual(r.vertical, one.vertical, delta=1e-6)

    def test_refuse_what_makes_no_rail(self):
        rail = bem_contact.Profile(*points("60E1"), kind="rail")
        for arguments, words in ((([0], [rail, rail]), "1 places, 2 profiles"), (([0, 1], [rail, rail], [[0, 1], [0]]), "more than others")):
            with self.assertRaisesRegex(bem_contact.InputError, words):
                bem_contact.Sections(*arguments)
        with self.assertRaisesRegex(bem_contact.InputError, "rising place"):
            bem_contact.solve(SCENE, {"rail.profile": bem_contact.Sections([1, 0], [rail, rail])})


class Stub(unittest.TestCase):
    def test_a_profile_is_no_abstract_class(self):
        tree = ast.parse((ROOT / "bem_contact" / "python" / "bem_contact" / "__init__.pyi").read_text())
        of = next(node for node in tree.body if isinstance(node, ast.ClassDef) and node.name == "Profile")
        self.assertIn("__fspath__", [node.name for node in of.body if isinstance(node, ast.FunctionDef)])


class Messages(unittest.TestCase):
    NOISY = """
import logging, numpy as np, bem_contact
p = bem_contact.profile("S1002", step=0.25)
z = p["z"] + np.random.default_rng(1).normal(0, 0.003, len(p["z"]))
wheel = bem_contact.Profile(p["y"], z, kind="wheel")
"""

    def said(self, lines):
        done = subprocess.run([sys.executable, "-c", self.NOISY + lines], capture_output=True, text=True, env=os.environ)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stderr

    def test_name_the_array(self):
        said = self.said("bem_contact.profile(wheel)")
        self.assertRegex(said, r"^warning: the array of a wheel \(\d+ points\): its points scatter by")
        self.assertNotIn("bem_contact_profiles_", said)

    def test_can_be_silenced_by_logging(self):
        smooth = "bem_contact.profile(wheel, reading={'smoothing': 9})"
        self.assertIn("info: the array of a wheel", self.said(smooth))
        self.assertEqual(self.said("logging.getLogger('bem_contact').setLevel(logging.WARNING); " + smooth), "")
        self.assertEqual(self.said("logging.disable(logging.WARNING); bem_contact.profile(wheel)"), "")
        kept = "class Keep(logging.Handler):\n  def emit(self, record): print(record.levelname, record.getMessage()[:9], flush=True)\n"
        self.assertEqual(self.said(kept + "logging.getLogger('bem_contact').addHandler(Keep()); bem_contact.profile(wheel)"), "")


class Numbers(unittest.TestCase):
    def test_of_en_15313_are_those_of_the_program(self):
        flange = bem_contact.profile("S1002")["flange"]
        self.assertAlmostEqual(flange["Sh"], 28, delta=1e-3)
        self.assertAlmostEqual(flange["Sd"], 32.5, delta=1e-3)
        self.assertAlmostEqual(flange["qR"], 10.794, delta=1e-3)
        self.assertIsNone(bem_contact.profile("60E1")["flange"])
        program = os.environ["BEM_CONTACT"]
        said = json.loads(subprocess.run([program, "profile", "S1002", "--json"], capture_output=True, text=True, check=True).stdout)
        self.assertEqual(said["flange"], flange)
        text = subprocess.run([program, "profile", "S1002"], capture_output=True, text=True, check=True).stdout
        self.assertIn("flange: Sh 28.00 mm, Sd 32.50 mm, qR 10.79 mm", text)
        rail = ROOT / "data" / "bodies" / "worn_rail.txt"
        said = json.loads(subprocess.run([program, "profile", rail, "--kind", "rail", "--json"], capture_output=True, text=True, check=True).stdout)
        found = bem_contact.profile(rail, "rail")
        self.assertEqual(said["wear"], found["wear"])
        self.assertEqual(set(found["wear"]), {"W1", "W2", "W3"})


class Notebooks(unittest.TestCase):
    def test_results_and_sweeps_show_themselves(self):
        html = bem_contact.solve(SCENE)._repr_html_()
        self.assertIn("<td>pmax</td>", html)
        self.assertIn("Certified", html)
        html = bem_contact.sweep({**SCENE, "sweep": {"position.lateral": [0.0, 1.0]}})._repr_html_()
        self.assertIn("<th>position.lateral</th>", html)
        self.assertEqual(html.count("<td>certified</td>"), 2)


class Standards(unittest.TestCase):
    def test_are_listed_and_can_be_read(self):
        all_of_them = bem_contact.standards()
        names = [s["name"] for s in all_of_them]
        self.assertGreaterEqual(len(names), 48)
        self.assertEqual(len(set(names)), len(names))
        rail = all_of_them[names.index("60E1")]
        self.assertEqual((rail["kind"], rail["part"]), ("rail", "section"))
        self.assertIn("UIC60", rail["other_names"])
        for one in all_of_them[::12]:
            self.assertEqual(bem_contact.profile(one["name"], step=5)["kind"], one["kind"])


if __name__ == "__main__":
    unittest.main()
