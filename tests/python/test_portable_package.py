"""The package of the portable wheel (ctypes, and the program) says what the compiled module says: names, numbers, errors."""

import importlib.util
import inspect
import json
import math
import os
import pickle
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import numpy as np

import bem_contact

ROOT = Path(__file__).resolve().parents[2]
SCENES = ROOT / "data" / "scenes"
ROLLING, CORNER, SWEEP = SCENES / "steady_rolling.toml", SCENES / "conformal_small.toml", SCENES / "cases_two_areas.toml"
PATCH = {"kind": "patch", "load": {"force": 1e4}, "motion.xi": 1e-3, "grid": {"dx": 0.5, "ds": 0.5, "mx": 24, "ms": 24},
         "gap": {"a": 1e-3, "b": np.float64(1e-3)}}


def made_package(folder):
    """As tools/makers/portable_wheel packs it, from this build."""
    package = folder / "portable_contact"
    shutil.copytree(ROOT / "bem_contact" / "python" / "portable" / "bem_contact", package)
    (package / "bin").mkdir()
    (package / "bin" / "bem_contact").symlink_to(os.environ["BEM_CONTACT"])
    (package / "libconformal_contact.so").symlink_to(os.environ["CONFORMAL_LIBRARY"])
    found = importlib.util.spec_from_file_location("portable_contact", package / "__init__.py")
    sys.modules["portable_contact"] = module = importlib.util.module_from_spec(found)
    found.loader.exec_module(module)
    return module


class PortablePackage(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.scratch = tempfile.TemporaryDirectory()
        cls.folder = Path(cls.scratch.name)
        cls.portable = made_package(cls.folder)

    @classmethod
    def tearDownClass(cls):
        cls.scratch.cleanup()

    def same(self, a, b, path=""):
        """Numbers within what another order of cases may change; nothing that takes time."""
        if "seconds" in path or path in ("commit", "program") or path.endswith("/work"):
            return
        if isinstance(a, dict):
            self.assertEqual(sorted(a), sorted(b), path)
            for key in a:
                self.same(a[key], b[key], f"{path}/{key}" if path else key)
        elif isinstance(a, list):
            self.assertEqual(len(a), len(b), path)
            for i, (one, other) in enumerate(zip(a, b)):
                self.same(one, other, f"{path}/{i}")
        elif isinstance(a, float) and isinstance(b, (int, float)):
            self.assertTrue(math.isclose(a, b, rel_tol=1e-6, abs_tol=1e-8) or (math.isnan(a) and math.isnan(b)), f"{path}: {a} {b}")
        else:
            self.assertEqual(a, b, path)

    def both_raise(self, *arguments, **keywords):
        """Both packages refuse it by an error of the same names; the text of the module is returned."""
        told = []
        for package in (self.portable, bem_contact):
            with self.assertRaises((package.Error, TypeError)) as caught:
                package.solve(*arguments, **keywords)
            told.append((type(caught.exception).__name__, str(caught.exception)))
        self.assertEqual(told[0][0], told[1][0], told)
        return told[0][1]

    def test_a_result_is_that_of_the_program_and_of_the_module(self):
        for scene in (ROLLING, SCENES / "cattaneo.toml", SCENES / "hertz.toml", SCENES / "roller_rig.toml"):
            here, there = self.portable.solve(scene), bem_contact.solve(scene)
            printed = json.loads(subprocess.run([os.environ["BEM_CONTACT"], "solve", scene, "--json"], check=True,
                                                capture_output=True, text=True).stdout)
            self.same({**here._record, "units": None}, {**printed, "units": None})
            for unit, others in ((here.units, printed["units"]), (here.units, there.units), (printed["units"], there.units)):
                self.assertEqual({name: unit[name] for name in others if name in unit}, {name: others[name] for name in others if name in unit})
            for name in [*there.patches[0], "pmax", "pmax_error", "p_n", "slip_x", "x", "xi"]:
                self.assertEqual(here.units[name], there.units[name])
            for name in dir(here):
                if name.startswith("_") or not hasattr(there, name) or callable(getattr(there, name)):
                    continue
                mine, its = getattr(here, name), getattr(there, name)
                its = its.tolist() if hasattr(its, "tolist") else its
                if name not in ("seconds", "history", "stresses", "structure", "conformity", "units"):
                    self.same(mine, its, name)
            self.assertEqual(repr(here), repr(there))
            self.assertEqual(here["patches/0/Fn"], here.patches[0]["Fn"])
            self.assertEqual(pickle.loads(pickle.dumps(here)).p_n, here.p_n)
            for result in (here, there):
                with self.assertRaises(KeyError) as caught:
                    result["patches/0/Fm"]
                self.assertIn("patches/0/F", str(caught.exception))
                with self.assertRaises(AttributeError):
                    result.pmx
        self.assertTrue({"pmax", "p_n", "patches", "units", "certified", "model"} <= set(dir(here)))

    def test_a_scene_is_a_path_a_text_or_a_dict(self):
        for scene in (PATCH, str(ROLLING), ROLLING, ROLLING.read_text(), {"kind": "patch", **PATCH}):
            self.assertTrue(self.portable.solve(scene).certified)
            self.same(self.portable.solve(scene).pmax, bem_contact.solve(scene).pmax)
        moved = self.folder / "moved.toml"
        moved.write_text(CORNER.read_text())
        with self.assertRaises(self.portable.InputError):
            self.portable.solve(moved)
        self.assertEqual(self.portable.solve(moved, model="halfspace", folder=SCENES).model, "halfspace")
        self.assertEqual(self.portable.solve(CORNER.read_text(), model="halfspace", folder=SCENES).model, "halfspace")

    def test_changes_are_of_one_case_alone(self):
        for package in (self.portable, bem_contact):
            sequence = package.Sequence(ROLLING)
            given = sequence.solve().Fz
            self.assertAlmostEqual(sequence.solve({"load": {"force": 8000}}).Fz, 8000, 3)
            self.assertAlmostEqual(sequence.solve({"motion.xi": 1e-3}).Fz, given, 3)
            self.assertEqual(sequence.solve({"motion.frictionless": True}, "hertz").model, "hertz")
            self.assertAlmostEqual(pickle.loads(pickle.dumps(sequence)).solve().Fz, given, 3)
            self.assertEqual(sequence.solve({"motion.xi": np.array(1e-3), "solver.model": "halfspace"}).model, "halfspace")

    def test_errors_have_the_same_names(self):
        self.assertTrue(issubclass(self.portable.InputError, (self.portable.Error, ValueError)))
        self.assertTrue(issubclass(self.portable.ConvergenceError, (self.portable.Error, RuntimeError)))
        for scene in ("no.toml", "no\0.toml", "no\udc80.toml", "", 3, None, {1: 2}, {"a b": 2}, "kind = \n", {"load": {1: 2}}):
            self.both_raise(scene)
        for changes in ({"load.forc": 1}, {1: 1}, {"load.force": math.nan}, {"load.force": None}, {"load.force": "1e4"}, {"load.force": True},
                        {"load.force": [1, 2]}, {"load.force": {"a": 1}}, "load.force", {"load.force": [None]}, {"a\0b": 1}):
            self.both_raise(ROLLING, changes)
        self.assertIn("hertz", self.both_raise(ROLLING, model="hetz"))
        self.assertNotIn("error:", self.both_raise(ROLLING, {"load.forc": 1}))
        sharp = {"position.lateral": 7.0}
        if bem_contact.solve(CORNER, sharp, "halfspace").warnings:
            self.assertIn("strict", self.both_raise(CORNER, sharp, "halfspace", True))

    def test_commands_return_what_they_print(self):
        here, there = self.portable.compare(CORNER, ["halfspace", "fem"]), bem_contact.compare(CORNER, ["halfspace", "fem"])
        for model in ("halfspace", "fem"):
            self.same(here["at_equal_forces"][model]["quantities"]["pmax"], there["at_equal_forces"][model].pmax)
        columns, arrays = self.portable.sweep(SWEEP), bem_contact.sweep(SWEEP)
        self.assertEqual(set(arrays) - {"weight"} - set(columns), set())
        for name in ("pmax", "Fy", "status", "model", "position.lateral", "wheel.profile"):
            self.same(columns[name], list(arrays[name]), name)
        self.same(columns["patches"]["Fn"], arrays["patches"]["Fn"].tolist())
        answer = self.portable.conicity(wheel="S1002", rail="60E1", rail_inclination=0.025)
        its = bem_contact.conicity(None, {"wheel.profile": "S1002", "rail.profile": "60E1", "position.rail_inclination": 0.025})
        self.same(answer["function"]["difference"], its["function"]["difference"].tolist())
        page = self.folder / "page.html"
        self.portable.compare(CORNER, output=self.folder / "c.h5")
        self.portable.report(self.folder / "c.h5", page)
        self.assertIn("<html", page.read_text())

    def test_commands_refuse_what_they_do_not_take(self):
        """Nothing is written: a dict was once taken for the name of an output."""
        before = set(os.listdir("."))
        for call in (lambda: self.portable.sweep(SWEEP, {"load.force": 9e4}), lambda: self.portable.compare(PATCH),
                     lambda: self.portable.wear(ROLLING.read_text()), lambda: self.portable.sweep(None)):
            with self.assertRaises(TypeError):
                call()
        for call in (lambda: self.portable.conicity(weel="S1002"), lambda: self.portable.sweep("no.toml"),
                     lambda: self.portable.compare(CORNER, ["hetz"]), lambda: self.portable.report("no.h5", self.folder / "no.html"),
                     lambda: self.portable.run("conicity", "--wheel"), lambda: self.portable.table(ROLLING, output=self.folder / "t.h5"),
                     lambda: self.portable.wear(SWEEP)):
            with self.assertRaises(self.portable.InputError) as caught:
                call()
            self.assertNotIn("error:", str(caught.exception))
        self.assertEqual(set(os.listdir(".")), before)

    def test_what_is_here_has_the_names_of_the_module(self):
        own = {"explore", "main", "program_file", "run"}
        for name in set(self.portable.__all__) - own:
            self.assertTrue(hasattr(bem_contact, name), name)
        stub = (ROOT / "bem_contact" / "python" / "bem_contact" / "__init__.pyi").read_text()
        for name in ("changes", "model", "strict", "folder"):
            self.assertIn(name, inspect.signature(self.portable.solve).parameters)
            self.assertIn(name, stub)
        self.assertEqual(self.portable.__version__, bem_contact.__version__)
        told = subprocess.run([sys.executable, "-m", "portable_contact", "--version"], cwd=self.folder, check=True, capture_output=True,
                              text=True).stdout
        self.assertIn(self.portable.__version__, told)


if __name__ == "__main__":
    unittest.main()
