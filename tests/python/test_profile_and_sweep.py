"""bem_contact.profile, check and sweep: against closed forms and against the program."""

import csv
import os
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path
from types import SimpleNamespace
from unittest import mock

import numpy as np

import bem_contact

ROOT = Path(__file__).resolve().parents[2]
SCENES, BODIES = ROOT / "data" / "scenes", ROOT / "data" / "bodies"
HOLLOW = BODIES / "hollow_wheel.txt"


def program(*arguments):
    return subprocess.run([os.environ["BEM_CONTACT"], *map(str, arguments)], check=True, stdout=subprocess.PIPE,
                          stderr=subprocess.DEVNULL, text=True).stdout


class Profile(unittest.TestCase):
    def test_an_arc(self):
        """Points on a circle of radius 300 mm: its curvature, arc length and no noise."""
        angle = np.linspace(-0.1, 0.1, 121)
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / "arc.txt"
            np.savetxt(file, np.column_stack((300 * np.sin(angle), 300 * (1 - np.cos(angle)))))
            p = bem_contact.profile(file, "rail", step=0.5)
        np.testing.assert_allclose(p["curvature"], 1 / 300, rtol=1e-3)
        np.testing.assert_allclose(p["inclination"], p["s"] / 300, atol=1e-5)
        self.assertAlmostEqual(p["s"][-1] - p["s"][0], 60, delta=1e-3)
        self.assertLessEqual(np.diff(p["s"]).max(), 0.5 + 1e-9)
        self.assertEqual((p["kind"], p["points"], p["outliers"], p["removed_rms"]), ("rail", 121, [], 0))
        self.assertLess(p["noise"]["scatter"], 1e-6)

    def test_is_what_the_program_says(self):
        p = bem_contact.profile(str(HOLLOW), "wheel", {"smoothing": 8})
        with tempfile.TemporaryDirectory() as folder:
            table = Path(folder) / "p.csv"
            said = program("profile", HOLLOW, "--kind", "wheel", "--smoothing", 8, "--csv", table)
            columns = np.loadtxt(table, delimiter=",", skiprows=1, unpack=True)
        for name, column in zip(("s", "y", "z", "inclination", "curvature"), columns):
            np.testing.assert_allclose(p[name], column, rtol=1e-7, atol=1e-6)
        self.assertIn(f"points: {p['points']}, {p['noise']['spacing']:.3g} mm apart", said)
        self.assertIn(f"noise: {1e3 * p['noise']['scatter']:.2f} um", said)
        self.assertIn(f"like {p['like']['name']}", said)
        self.assertIn(f"{1e3 * p['removed_rms']:.2f} um root mean square", said)

    def test_a_standard_has_a_curve_alone(self):
        p = bem_contact.profile("60E1")
        self.assertEqual((p["kind"], p["points"], p["noise"], p["like"]), ("rail", 0, None, None))
        self.assertAlmostEqual(p["curvature"][len(p["s"]) // 2], 1 / 300, delta=1e-6)

    def test_wrong_input(self):
        for words, arguments in (("neither its name nor its ending", (HOLLOW,)), ("no kind of profiles 'axle'", (HOLLOW, "axle")),
                                 ("Unknown profile 'no_such.txt'", ("no_such.txt", "rail")),
                                 ("wheel.smoothing", (HOLLOW, "wheel", {"smoothing": -1})),
                                 ("unknown key 'wheel.smoothin'", (HOLLOW, "wheel", {"smoothin": 1}))):
            with self.assertRaisesRegex(bem_contact.InputError, words):
                bem_contact.profile(*arguments)
        with self.assertRaisesRegex(bem_contact.InputError, "step"):
            bem_contact.profile("60E1", step=0)


class Check(unittest.TestCase):
    def test_is_what_the_program_says(self):
        for file in (SCENES / "conformal_small.toml", SCENES / "steady_rolling.toml", SCENES / "wheelset.toml"):
            found = bem_contact.check(file)
            said = program("check", file)
            self.assertEqual("".join(line + "\n" for line in found["lines"]) + "".join(f"warning: {w}\n" for w in found["warnings"]), said)

    def test_says_where_the_search_for_a_wheelset_begins(self):
        lines = bem_contact.check(SCENES / "wheelset.toml", {"position.lateral": 1.5})["lines"]
        self.assertRegex(lines[0], "^wheelset: .* lateral displacement of 1.5 mm")
        self.assertLess(lines.index("right wheel"), lines.index("left wheel (y, s to the left)"))

    def test_changes_count(self):
        lines = bem_contact.check(SCENES / "conformal_small.toml", {"position.lateral": 0.0}, "halfspace")["lines"]
        self.assertNotEqual(lines, bem_contact.check(SCENES / "conformal_small.toml")["lines"])
        with self.assertRaisesRegex(bem_contact.InputError, "position.latteral"):
            bem_contact.check(SCENES / "conformal_small.toml", {"position.latteral": 1})


class SweepCase(unittest.TestCase):
    def same_as_the_program(self, scene):
        """Status, reason and every number of each case and patch, to the last bit. Returns what Python found."""
        found = bem_contact.sweep(scene)
        with tempfile.TemporaryDirectory() as folder:
            subprocess.run([os.environ["BEM_CONTACT"], "sweep", scene, "-o", Path(folder) / "s.h5", "--csv", Path(folder) / "s.csv"],
                           stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)  # 3: a case is not certified
            tables = {name: list(csv.DictReader((Path(folder) / name).open(newline="")))
                      for name in ("s.csv", "s_patches.csv") if (Path(folder) / name).exists()}
        self.same_columns(found, tables["s.csv"], {"case", "seconds", "cpu_seconds"})
        self.assertEqual("patches" in found, "s_patches.csv" in tables)
        if "patches" in found:
            self.same_columns(found["patches"], tables["s_patches.csv"], {"status", *(name for name in found if "." in name)})
        return found

    def same_columns(self, found, rows, left_out):
        self.assertEqual(set(rows[0]) - left_out - set(found), set())
        for name in set(rows[0]) & set(found):
            column = [row[name] for row in rows]
            if isinstance(found[name], np.ndarray):
                np.testing.assert_array_equal(found[name], [float(text or "nan") for text in column], err_msg=name)
            else:
                self.assertEqual(found[name], column, name)


class Sweep(SweepCase):
    def test_is_what_the_program_solves(self):
        self.same_as_the_program(SCENES / "cases_two_areas.toml")

    def test_every_status_is_that_of_the_program(self):
        """Certified, certified with a remark, not certified, and refused when solved or when read. Three chunks."""
        with tempfile.TemporaryDirectory() as folder:
            scene = Path(folder) / "scene.toml"
            scene.write_text("kind = 'patch'\nrail.material.poisson = 0.2\nmotion.xi = 1e-3\nsolver.tolerance = 1e-12\n"
                             "grid = { dx = 0.5, ds = 0.5, mx = 24, ms = 24 }\ngap = { a = 1e-3, b = 1e-3 }\n"
                             "[sweep]\nload.force = [1e4, 1e9]\nmotion.frictionless = [true, false]\n"
                             "motion.friction = [0.3, 0.0]\nsolver.max_outer = [50, 1, 2]\n")
            found = self.same_as_the_program(scene)
        self.assertEqual(found["status"][6:12], ["certified", "not certified", "certified"] + 3 * ["refused"])
        for case, words in ((7, "worst violation"), (8, "did not settle"), (9, "zero friction"), (18, "beyond elastic")):
            self.assertIn(words, found["reason"][case])

    def test_wheelsets(self):
        found = self.same_as_the_program(SCENES / "wheelset_sweep.toml")
        self.assertEqual(found["right_model"], ["halfspace"] * 18)

    def test_a_frame_has_a_row_for_each_case_or_each_patch(self):
        """Of what pandas is handed; it need not be installed."""
        found = bem_contact.sweep(SCENES / "cases_two_areas.toml")
        with mock.patch.dict(sys.modules, pandas=SimpleNamespace(DataFrame=dict)):
            cases, patches = found.to_frame(), found.to_frame("patches")
        self.assertEqual(set(cases), set(found) - {"patches"})
        self.assertEqual({len(column) for column in cases.values()}, {len(found["status"])})
        self.assertIn("position.lateral", cases)
        self.assertEqual({len(column) for column in patches.values()}, {len(found["patches"]["case"])})
        self.assertGreater(len(patches["Fn"]), len(cases["Fz"]))
        with mock.patch.dict(sys.modules, pandas=None), self.assertRaisesRegex(bem_contact.InputError, "no module pandas.* python3-pandas"):
            found.to_frame()

    def test_parquet_has_the_same_columns(self):
        """What pyarrow is handed, where it is not installed; what it reads again, where it is."""
        found = bem_contact.sweep(SCENES / "cases_two_areas.toml")
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / "cases.parquet"
            for rows, columns in (("cases", {name: column for name, column in found.items() if name != "patches"}), ("patches", found["patches"])):
                try:
                    import pyarrow.parquet
                except ModuleNotFoundError:
                    write = mock.Mock()
                    parquet = SimpleNamespace(write_table=write)
                    with mock.patch.dict(sys.modules, {"pyarrow": SimpleNamespace(table=dict, parquet=parquet), "pyarrow.parquet": parquet}):
                        found.to_parquet(file, rows)
                    written = write.call_args.args[0]
                else:
                    found.to_parquet(file, rows)
                    written = pyarrow.parquet.read_table(file).to_pydict()
                self.assertEqual(set(written), set(columns))
                for name, column in columns.items():
                    np.testing.assert_array_equal(written[name], column, name)
        with mock.patch.dict(sys.modules, pyarrow=None), self.assertRaisesRegex(bem_contact.InputError, "no module pyarrow.* pip install pyarrow"):
            found.to_parquet("never.parquet")

    def test_a_case_that_is_refused_has_no_numbers(self):
        scene = {"kind": "patch", "load.force": 1e4, "grid": {"dx": 0.5, "ds": 0.5, "mx": 24, "ms": 24}, "gap": {"a": 1e-3, "b": 1e-3},
                 "motion.frictionless": True}
        text = "kind = 'patch'\nmotion.frictionless = true\ngrid = { dx = 0.5, ds = 0.5, mx = 24, ms = 24 }\ngap = { a = 1e-3, b = 1e-3 }\n"
        found = bem_contact.sweep(text + "[sweep]\nload.force = [1e4, 1e9]\n")
        self.assertEqual(found["status"], ["certified", "refused"])
        self.assertEqual(found["pmax"][0], bem_contact.solve(scene).pmax)
        self.assertTrue(np.isnan(found["pmax"][1]))
        self.assertTrue(found["reason"][1])
        self.assertEqual(list(found["patches"]["case"]), [0])

    def test_wrong_input(self):
        for words, scene in (("sweep", SCENES / "hertz.toml"), ("no_such.toml", SCENES / "no_such.toml")):
            with self.assertRaisesRegex(bem_contact.InputError, words):
                bem_contact.sweep(scene)
        with self.assertRaisesRegex(bem_contact.InputError, "model"):
            bem_contact.sweep(SCENES / "cases_two_areas.toml", "elastic")


PATCH = ("kind = 'patch'\nmotion = { friction = 0.3, xi = 2e-4 }\ngrid = { dx = 0.5, ds = 0.5, mx = 24, ms = 24 }\n"
         "gap = { a = 1e-3, b = 1e-3 }\nload.force = 1e4\nsolver.model = 'halfspace'\n")
RAIL = ("rail.profile = '60E1'\nwheel.profile = 'S1002'\nmotion.friction = 0.3\nmotion.xi = 1e-3\ngrid = { dx = 1, ds = 1 }\n"
        "solver.model = 'halfspace'\n")


class SweepOfDerivatives(SweepCase):
    def test_its_columns_are_those_of_each_case(self):
        derivatives = "derivatives = ['load', 'xi', 'friction']\n"
        with tempfile.TemporaryDirectory() as folder:
            scene = Path(folder) / "scene.toml"
            scene.write_text(derivatives + PATCH + "[sweep]\nmotion.xi = [2e-4, 5e-4, 5e-2]\n")
            found = self.same_as_the_program(scene)
        for case, xi in enumerate((2e-4, 5e-4, 5e-2)):
            alone = bem_contact.solve(derivatives + PATCH, {"motion.xi": xi}).derivatives
            for name, by in alone.items():
                for total in ("Fx", "Fz", "Mz", "approach", "T_gamma"):
                    scale = max(abs(alone[other][total]) for other in alone)
                    self.assertAlmostEqual(found[f"{total}_by_{name}"][case], by[total], delta=1e-5 * scale, msg=(total, name))
        self.assertAlmostEqual(found["Fz_by_load"][0], 1, delta=1e-8)
        self.assertGreater(found["load_above"][0], 0)

    def test_others_refuse_them(self):
        by = "derivatives = ['load']\n"
        measured = {"xi": [1e-4, 5e-4, 1e-3], "Fx": [100, 400, 500]}
        for shows, ask in (
                ("a creep curve", lambda: bem_contact.creep_curves(by + PATCH)),
                ("a creep curve", lambda: bem_contact.fit(by + PATCH, measured, "motion.friction")),
                ("a comparison", lambda: bem_contact.compare(by + "load.force = 8e4\n" + RAIL, models=["halfspace", "tangent_plane"])),
                ("a table", lambda: bem_contact.table(by + PATCH, {"load.force": [1e3, 2e3]})),
                ("a load collective", lambda: bem_contact.fatigue(by + PATCH + "[sweep]\nload.force = [1e3, 2e3]\n")),
                ("a profile that wears", lambda: bem_contact.wear(by + RAIL + "[sweep]\nload.force = [8e4, 9e4]\n")),
                ("where the wheelset stands", lambda: bem_contact.wheelset("derivatives = ['lateral']\n" + RAIL.replace("motion.xi = 1e-3\n", "")
                                                                           + "wheelset.force = 1e5\n")),
                ("the points of a profile are a table", lambda: bem_contact.sweep("derivatives = ['rail_profile']\n" + RAIL
                                                                                  + "[sweep]\nload.force = [8e4, 9e4]\n"))):
            with self.assertRaisesRegex(bem_contact.InputError, shows):
                ask()
        with tempfile.TemporaryDirectory() as folder:
            scene = Path(folder) / "scene.toml"
            scene.write_text(by + "load.force = 8e4\n" + RAIL)
            for words in (("study", scene, "-o", Path(folder) / "out"), ("shakedown", scene), ("wear", scene)):
                said = subprocess.run([os.environ["BEM_CONTACT"], *map(str, words)], stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
                self.assertEqual(said.returncode, 2, words)
                self.assertRegex(said.stderr, "does not show them", words)


class Help(unittest.TestCase):
    def test_every_command_is_in_the_help_of_the_module(self):
        commands = re.findall(r"^  ([a-z-]+) ", program("--help").split("Subcommands:")[1], re.M)
        for command in commands:
            self.assertRegex(bem_contact.__doc__, rf"\b{command}\b")
        for name in re.findall(r"(\w+)\(\)", bem_contact.__doc__.split("or is called")[1]):
            self.assertTrue(getattr(bem_contact, name).__doc__)


if __name__ == "__main__":
    unittest.main()
