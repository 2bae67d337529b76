"""One name, one number, one unit: in --json, HDF5, CSV and Python. And the type stubs."""

import ast
import csv
import inspect
import json
import os
import pydoc
import subprocess
import tempfile
import unittest
from pathlib import Path

import h5py
import numpy as np

import bem_contact
from bem_contact.plotting import shakedown

ROOT = Path(__file__).resolve().parents[2]
SCENES = ROOT / "data" / "scenes"
CORNER = SCENES / "conformal_small.toml"


def program(*arguments):
    subprocess.run([os.environ["BEM_CONTACT"], *map(str, arguments)], check=True, stdout=subprocess.DEVNULL,
                   stderr=subprocess.DEVNULL)


def rows_of(file):
    """As pandas.read_csv reads it: names in the first line, an empty cell is nan."""
    with open(file, newline="") as lines:
        return list(csv.DictReader(lines))


def number(cell):
    return float(cell) if cell else np.nan


def same(a, b):
    return np.array_equal(np.asarray(a, dtype=float), np.asarray(b, dtype=float), equal_nan=True)


class Names(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.scratch = tempfile.TemporaryDirectory()
        folder = Path(cls.scratch.name)
        cls.json = json.loads(subprocess.run([os.environ["BEM_CONTACT"], "solve", CORNER, "--json"], check=True,
                                             stdout=subprocess.PIPE, stderr=subprocess.DEVNULL).stdout)
        program("solve", CORNER, "-o", folder / "r.h5")
        cls.h5 = h5py.File(folder / "r.h5")
        cls.python = bem_contact.solve(CORNER)
        text = CORNER.read_text().replace("../influence/", f"{SCENES.parent}/influence/")
        (folder / "s.toml").write_text(text + "\n[sweep]\nposition.lateral = [6.6]\nwheel.profile = ['S1002']\n")
        program("sweep", folder / "s.toml", "-o", folder / "s.h5", "--csv", folder / "s.csv")
        cls.cases, cls.patches, cls.units = (rows_of(folder / f"s{kind}.csv") for kind in ("", "_patches", "_units"))
        cls.sweep = h5py.File(folder / "s.h5")

    @classmethod
    def tearDownClass(cls):
        cls.h5.close()
        cls.sweep.close()
        cls.scratch.cleanup()

    def test_numbers(self):
        quantities = self.json["quantities"]
        self.assertEqual(set(self.h5["quantities"]), set(quantities))
        self.assertGreater(len(quantities), 40)
        for name, value in quantities.items():
            with self.subTest(name):
                value = np.nan if value is None else value
                of_python = getattr(self.python, name)
                values = [self.h5["quantities"][name][()], number(self.cases[0][name]), self.sweep[name][0],
                          np.nan if of_python is None else of_python]
                for other in values:
                    self.assertTrue(same(other, value), (other, value))

    def test_patches(self):
        group = self.h5["patches"]
        for i, patch in enumerate(self.json["patches"]):
            self.assertEqual(set(group), set(patch))
            self.assertEqual(set(self.python.patches[i]), set(patch))
            for name, value in patch.items():
                value = np.nan if value is None else value
                of_python = self.python.patches[i][name]
                for other in (group[name][i], number(self.patches[i][name]), self.sweep["patches"][name][i],
                              np.nan if of_python is None else of_python):
                    self.assertTrue(same(other, value), name)

    def test_units(self):
        units = self.json["units"]
        for name, unit in self.python.units.items():
            if name in units:
                self.assertEqual(units[name], unit, name)
        for name in {**self.json["quantities"], **self.json["patches"][0]}:
            self.assertEqual(self.python.units[name], units[name.removesuffix("_error")], name)
        for group in ("quantities", "patches"):
            for name, data in self.h5[group].items():
                self.assertEqual(data.attrs["unit"].decode(), units[name.removesuffix("_error")], name)
        for name in ("p_n", "u_x", "slip_s", "friction_work_density", "friction_work"):
            self.assertEqual(self.h5[name].attrs["unit"].decode(), self.python.units[name], name)
        listed = {(row["table"], row["name"]): row["unit"] for row in self.units}
        for table, rows in (("cases", self.cases), ("patches", self.patches)):
            for name in rows[0]:
                if name not in ("case", "patch", "reason") and (table, name) != ("patches", "status"):
                    self.assertIn((table, name), listed)
                    unit = listed[table, name].split(" (shift")[0]
                    if name.removesuffix("_error") in units and name != "seconds":
                        self.assertEqual(unit, units[name.removesuffix("_error")], name)
        self.assertEqual(listed["patches", "position.lateral"], "mm")

    def test_elements(self):
        for name in ("p_x", "p_s", "p_n", "slip_x", "slip_s", "u_x", "u_s", "u_n", "friction_work_density", "friction_work",
                     "deformed_distance", "state"):
            self.assertTrue(same(self.h5[name], getattr(self.python, name)), name)
        for name in ("x", "s", "y", "z", "delta", "wheel_s", "gap"):
            self.assertTrue(same(self.h5[name], getattr(self.python, name)), name)
        r = self.python
        work = r.p_x * r.slip_x + r.p_s * r.slip_s
        # What the slip of elements shows is a part of the power of friction.
        self.assertGreaterEqual((r.friction_work_density - work).min(), -1e-9 * work.max())
        self.assertLess(work.sum() * r.dx * r.ds / r.T_gamma, 1 + 1e-9)
        self.assertAlmostEqual(r.friction_work.sum() / r.T_gamma, 1, delta=1e-12)
        np.testing.assert_allclose(r.friction_work, r.friction_work_density * r.dx * r.ds, rtol=1e-12)
        # Where the bodies touch, the deformed distance is zero: h - q cos(delta) - u_n.
        distance = r.gap - r.approach * np.cos(r.delta)[:, None] - r.u_n
        self.assertLess(np.abs(distance[r.state > 0]).max(), 1e-5 * r.approach)

    def test_stresses(self):
        r = bem_contact.solve(SCENES / "stresses.toml")
        shape = tuple(len(r.stresses[name]) for name in ("x", "s", "depths"))
        self.assertEqual(r.stresses["stress"].shape, (*shape, 6))
        self.assertEqual(r.stresses["von_mises"].shape, shape)
        xx, ss, nn, xs, xn, sn = np.moveaxis(r.stresses["stress"], -1, 0)
        mises = np.sqrt(0.5 * ((xx - ss)**2 + (ss - nn)**2 + (nn - xx)**2) + 3 * (xs**2 + xn**2 + sn**2))
        np.testing.assert_allclose(r.stresses["von_mises"], mises, rtol=1e-9)
        self.assertEqual(r.stresses["components"], ["xx", "ss", "nn", "xs", "xn", "sn"])
        self.assertIsNone(self.python.stresses)

    def test_temperatures(self):
        scene = SCENES / "falling_friction.toml"
        with tempfile.TemporaryDirectory() as folder:
            program("solve", scene, "-o", Path(folder) / "t.h5")
            r = bem_contact.solve(scene)
            with h5py.File(Path(folder) / "t.h5") as h5:
                self.assertTrue(same(h5["T_rail"], r.T_rail))
                self.assertEqual(h5["T_wheel"].attrs["unit"].decode(), r.units["Tmax_wheel"])
        self.assertEqual(r.T_rail.max(), r.Tmax_rail)
        self.assertNotIn("T_rail", self.h5)
        self.assertIsNone(self.python.Tmax_rail)

    def test_scenes_as_text_and_as_dict(self):
        expected = bem_contact.solve(CORNER, model="halfspace")
        text = bem_contact.solve(CORNER.read_text(), model="halfspace", folder=SCENES)
        self.assertTrue(same(text.p_n, expected.p_n))
        nested = {"kind": "patch", "load": {"force": np.float32(1e4)}, "motion.frictionless": True,
                  "grid": {"dx": 0.5, "ds": 0.5, "mx": np.int64(16), "ms": 16}, "gap": {"a": 1e-3, "b": 1e-3},
                  "rail": {"material": {"poisson": 0.3}, "influence": Path("")}, "stresses.depths": np.array([0.5, 1])}
        toml = ("kind = 'patch'\nload.force = 1e4\nmotion.frictionless = true\nrail.material.poisson = 0.3\n[grid]\n"
                "dx = 0.5\nds = 0.5\nmx = 16\nms = 16\n[gap]\na = 1e-3\nb = 1e-3\n[stresses]\ndepths = [0.5, 1]\n")
        del nested["rail"]["influence"]
        of_dict, of_text = (bem_contact.Sequence(scene).solve() for scene in (nested, toml))
        self.assertEqual(of_dict.pmax, of_text.pmax)
        self.assertTrue(same(of_dict.stresses["stress"], of_text.stresses["stress"]))
        with self.assertRaisesRegex(bem_contact.InputError, "dict:.*load.force"):
            bem_contact.solve({"kind": "patch", "load": {"forze": 1}})
        with self.assertRaisesRegex(TypeError, "keys is of type int"):
            bem_contact.solve({1: 2})
        with self.assertRaisesRegex(TypeError, "The folder cannot be used"):
            bem_contact.solve(nested, folder=3)
        with self.assertRaisesRegex(bem_contact.InputError, "text:2"):
            bem_contact.solve("kind = 'patch'\nload.forze = 1\n")

    def test_stubs_name_what_is_there(self):
        package = Path(bem_contact.__file__).parent
        stubs, made = (ast.parse((package / file).read_text()) for file in ("__init__.pyi", "_numbers.pyi"))
        bases = {node.name: node.body for node in made.body if isinstance(node, ast.ClassDef)}

        def names(body):
            return ({n.name for n in body if isinstance(n, (ast.ClassDef, ast.FunctionDef))} |
                    {n.target.id for n in body if isinstance(n, ast.AnnAssign)}) - {"__init__", "__getitem__", "__fspath__", "_repr_html_"}

        for node in stubs.body:
            if isinstance(node, ast.ClassDef) and not issubclass(getattr(bem_contact, node.name), Exception):
                of = getattr(bem_contact, node.name)
                there = {n for n in dir(of) if not n.startswith("_")} - set(dir(of.__base__)) | ({"kind"} if node.name == "Profile" else set())  # of each profile
                body = node.body + [line for base in node.bases for line in bases.get(ast.unparse(base).lstrip("_"), [])]
                self.assertEqual(names(body), there, node.name)
        public = {name for name, value in vars(bem_contact).items() if not name.startswith("_") and not inspect.ismodule(value)}
        self.assertEqual(names(stubs.body), public | {"__commit__", "__version__"})
        help_text = pydoc.render_doc(bem_contact, renderer=pydoc.plaintext)
        self.assertNotIn("Method resolution order", help_text)
        for name in public:  # the functions, in Python's own list (not from 3.13 on) or in ours
            if inspect.isroutine(getattr(bem_contact, name)):
                self.assertIn(f"{name}(", help_text)
        optional = {n.target.id for n in bases["Numbers"] if isinstance(n, ast.AnnAssign) and "None" in ast.unparse(n.annotation)}
        patch = bem_contact.solve(SCENES / "hertz.toml")  # has fewer numbers than a wheel on a rail
        missing = {n for n in names(bases["Numbers"]) if getattr(patch, n) is None}
        self.assertGreater(len(missing), 4)
        self.assertLessEqual(missing, optional)


class Wear(unittest.TestCase):
    SCENE = """rail.profile = "60E1"
wheel.profile = "S1002"
solver.model = "halfspace"
load.force = 8e4
motion = { xi = 2e-3, free_rolling = false }
grid = { dx = 1, ds = 0.5 }
sweep.position.lateral = [0.0, 1.0]
sweep.weight = [3, 1]
"""

    def test_python_wears_as_the_program_does(self):
        with tempfile.TemporaryDirectory() as folder:
            scene, worn = Path(folder) / "scene.toml", Path(folder) / "worn"
            scene.write_text(self.SCENE)
            program("wear", scene, "-o", worn, "--depth", "0.05", "--body", "wheel")
            found = bem_contact.wear(scene, 0.05, body="wheel")
            with h5py.File(worn / "wear.h5") as h5:
                numbers = {name for name, item in h5.items() if isinstance(item, h5py.Dataset)}
                self.assertEqual(set(found) - {"rail", "wheel"}, numbers)
                for name in numbers:
                    np.testing.assert_array_equal(found[name], h5[name][()], name)
            self.assertEqual(found["wheel_depth"][-1], 0.05)
            for step in range(len(found["step"])):
                for body in ("rail", "wheel"):
                    written = np.loadtxt(worn / f"{body}_{step:04}.txt")  # mm, with twelve digits
                    np.testing.assert_allclose(found[body][step], written, rtol=0, atol=1e-10)

    def test_what_cannot_wear_is_refused(self):
        for words, scene, options in (("There is no body 'both wheels'", self.SCENE, {"body": "both wheels"}),
                                      ("depth of a step", self.SCENE, {"cap": 0}),
                                      ("sweep", self.SCENE.split("sweep")[0], {})):
            with self.assertRaisesRegex(bem_contact.InputError, words):
                bem_contact.wear(scene, **options)
        for words, options in ((r"wear\(\) has no argument 'laws' .* Did you mean law\?", {"laws": "energy"}),
                               ("'cap' of wear.* cannot be used .* Give a number", {"cap": "thick"})):
            with self.assertRaisesRegex(TypeError, words):
                bem_contact.wear(self.SCENE, **options)


class Fatigue(unittest.TestCase):
    SCENE = """kind = "patch"
rail.material.poisson = 0.4
load.force = 1e4
motion = { xi = 2e-3 }
grid = { dx = 0.5, ds = 0.5, mx = 24, ms = 24 }
gap = { a = 1e-3, b = 1e-3 }
"""

    def test_both_doors_have_the_same_stresses(self):
        """Those of the rail's Poisson ratio, of one result and of a collective."""
        with tempfile.TemporaryDirectory() as folder:
            scene = Path(folder) / "scene.toml"
            scene.write_text(self.SCENE + "[sweep]\nmotion.xi = [2e-3, 4e-3]\nweight = [3, 1]\n")
            asked = [os.environ["BEM_CONTACT"], "fatigue", scene, "--json"]
            told = json.loads(subprocess.run(asked, check=True, stdout=subprocess.PIPE).stdout)
            found = bem_contact.fatigue(scene)
            for name in ("cases", "beyond_surface_limit", "beyond_limit_below", "damage"):
                self.assertEqual(found[name], told[name], name)
            self.assertEqual(found["patches"], told["patches"])  # a list of rows, as of one result
            for patch in told["patches"]:
                self.assertAlmostEqual(patch["p0_over_k_limit"], shakedown.shakedown_limit(patch["mu_used"]), 9, "the line of the picture")
        for case, xi in enumerate((2e-3, 4e-3)):
            one = bem_contact.fatigue(bem_contact.solve(self.SCENE, {"motion.xi": xi}))
            for name in ("von_mises", "tresca"):
                self.assertAlmostEqual(one[name]["stress"] / told["patches"][case][name], 1, delta=1e-6)


class TwoPointContact(unittest.TestCase):
    """A sweep over two-point contact is plotted from its CSV files alone."""

    def test_patches_add_up_to_cases(self):
        with tempfile.TemporaryDirectory() as folder:
            csv_file = Path(folder) / "s.csv"
            program("sweep", SCENES / "cases_two_areas.toml", "-o", Path(folder) / "s.h5", "--csv", csv_file)
            cases, patches = rows_of(csv_file), rows_of(Path(folder) / "s_patches.csv")
            self.assertEqual([row["model"] for row in cases], ["halfspace"] * len(cases))
            self.assertGreater(max(float(row["patch_count"]) for row in cases), 1)
            for case in cases:
                own = [row for row in patches if row["case"] == case["case"]]
                self.assertEqual([row["patch"] for row in own], [str(i + 1) for i in range(len(own))])
                self.assertEqual(len(own), float(case["patch_count"]))
                for name in ("Fx", "Fy", "Fz", "area", "T_gamma"):
                    self.assertAlmostEqual(sum(float(row[name]) for row in own), float(case[name]),
                                           delta=1e-9 * float(case["Fz"]), msg=name)
                for row in own:
                    for key in ("position.lateral", "wheel.profile", "load.force"):
                        self.assertEqual(row[key], case[key])
            # Tread and flange are told apart by the inclination.
            self.assertTrue(any(float(row["delta"]) < -0.5 for row in patches))
            self.assertTrue(any(abs(float(row["delta"])) < 0.5 for row in patches))

    def test_a_stream_gets_the_cases_alone(self):
        with tempfile.TemporaryDirectory() as folder:
            out = subprocess.run([os.environ["BEM_CONTACT"], "sweep", SCENES / "cases_two_areas.toml", "-o",
                                  Path(folder) / "s.h5", "--csv", "/dev/stdout"], check=True, stdout=subprocess.PIPE,
                                 stderr=subprocess.DEVNULL, text=True).stdout
            self.assertTrue(out.startswith("case,"))
            self.assertEqual([f.name for f in Path(folder).iterdir()], ["s.h5"])


if __name__ == "__main__":
    unittest.main()
