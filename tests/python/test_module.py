"""The Python module: as a user imports it, against closed forms and against the program."""

import copy
import decimal
import fractions
import json
import os
import pickle
import shutil
import subprocess
import sys
import tempfile
import threading
import unittest
import unittest.mock
from pathlib import Path

import h5py
import numpy as np

import bem_contact

SCENES = Path(__file__).resolve().parents[2] / "data" / "scenes"
CORNER = SCENES / "conformal_small.toml"


class Module(unittest.TestCase):
    def test_without_its_compiled_part_it_says_what_to_call(self):
        with tempfile.TemporaryDirectory() as folder:
            shutil.copytree(Path(bem_contact.__file__).parent, Path(folder) / "bem_contact",
                            ignore=shutil.ignore_patterns("_core*"))
            run = subprocess.run([sys.executable, "-c", "import bem_contact; bem_contact.solve"], cwd=folder,
                                 env={"PYTHONPATH": folder}, capture_output=True, text=True)
            self.assertNotEqual(run.returncode, 0)
            self.assertIn("cmake --build --preset full --target bem_contact_python", run.stderr)

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

    def test_compare_is_what_the_program_compares(self):
        c = bem_contact.compare(CORNER)
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / "comparison.h5"
            out = subprocess.run([os.environ["BEM_CONTACT"], "compare", CORNER, "--json", "-o", file], check=True,
                                 stdout=subprocess.PIPE).stdout
            with h5py.File(file) as h5:
                stored = h5["creep_forces"]
                np.testing.assert_array_equal(stored["xi_from_free_rolling"], c["creep_forces"]["xi_from_free_rolling"])
                for kind in ("Fx", "Fx_error"):
                    self.assertEqual(set(stored[kind]), set(c["creep_forces"][kind]))
                    for model, values in c["creep_forces"][kind].items():
                        np.testing.assert_array_equal(stored[kind][model], values)
        expected = json.loads(out)
        self.assertEqual(c["reference"], "fem")
        for kind in ("at_equal_forces", "at_equal_position"):
            self.assertEqual(list(c[kind]), ["halfspace", "fem"])
            for model, result in c[kind].items():
                self.assertEqual(result.pmax, expected[kind][model]["quantities"]["pmax"])
        forces = expected["creep_forces"]
        self.assertEqual(list(c["creep_forces"]["xi_from_free_rolling"]), forces["xi_from_free_rolling"])
        for model, fx in forces["Fx"].items():
            self.assertEqual(list(c["creep_forces"]["Fx"][model]), fx)
        with self.assertRaisesRegex(bem_contact.InputError, "auto cannot be compared"):
            bem_contact.compare(CORNER, ["auto", "fem"])
        with self.assertRaisesRegex(TypeError, "Give a list of names"):
            bem_contact.compare(CORNER, "fem")

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
        for name in ("Fx", "Fy", "Fz", "Fs", "Mz", "T_gamma"):
            self.assertAlmostEqual(getattr(r, name), expected["quantities"][name], delta=1e-9 * r.Fz)
        self.assertEqual(r.model, expected["model"])
        for name in ("pmax", "area", "approach"):
            self.assertEqual(getattr(r, name), expected["quantities"][name])
        self.assertEqual(len(r.patches), len(expected["patches"]))
        self.assertEqual(r.discretisation, expected["quantities"]["discretisation"])
        for name in ("pmax_error", "area_error", "approach_error"):
            self.assertEqual(getattr(r, name), expected["quantities"][name], name)
        self.assertEqual(r.Fx_error, expected["quantities"]["Fx_error"])
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
                self.assertEqual(r.pmax, expected["quantities"]["pmax"], grid)
                self.assertEqual(r.Fx, expected["quantities"]["Fx"], grid)
                self.assertEqual(list(r.p_n.shape), [expected["quantities"]["ms"], expected["quantities"]["mx"]], grid)

    def test_changes_may_be_dicts_of_dicts(self):
        wanted = {"load.force": 2e5, "grid.dx": 0.08, "grid.mx": 30, "motion.xi": 1e-4}
        nested = {"load": {"force": 2e5}, "grid": {"dx": 0.08, "mx": 30}, "motion.xi": 1e-4}
        carter = SCENES / "carter.toml"
        expected = bem_contact.solve(carter, wanted)
        self.assertAlmostEqual(expected.Fz, 2e5, delta=0.1)
        for r in (bem_contact.solve(carter, nested), bem_contact.Sequence(carter).solve(nested)):
            self.assertEqual((r.Fz, r.Fx, r.pmax), (expected.Fz, expected.Fx, expected.pmax))
        for changes, words in (({"load": {"forse": 1e5}}, "load.forse.*Did you mean load.force"),
                               ({"load": {"force": {"N": 1e5}}}, "load.force.N")):
            with self.assertRaisesRegex(bem_contact.InputError, words):
                bem_contact.solve(carter, changes)
        for values in ({"from": [0.0, 1e-3]}, 0.1):
            with self.assertRaisesRegex(TypeError, "no list of numbers"):
                bem_contact.creep_curves(carter, xi=values)

    def test_a_sequence_finds_the_same(self):
        sequence = bem_contact.Sequence(CORNER)
        for lateral in (0.0, 3.0, 3.2, 6.7):
            changes = {"position.lateral": lateral}
            r, alone = (of(changes, model="halfspace") for of in
                        (sequence.solve, lambda *a, **k: bem_contact.solve(CORNER, *a, **k)))
            self.assertTrue(r.certified)
            self.assertAlmostEqual(r.Fy, alone.Fy, delta=1e-5 * alone.Fz)
            self.assertAlmostEqual(r.Fx, alone.Fx, delta=1e-4 * alone.Fz)

    def test_every_error_has_one_base(self):
        """Also an error of the machine, which was a RuntimeError like any other."""
        self.assertFalse(issubclass(bem_contact.Error, (ValueError, RuntimeError)))
        for kind, usual in ((bem_contact.InputError, ValueError), (bem_contact.ConvergenceError, RuntimeError)):
            self.assertTrue(issubclass(kind, bem_contact.Error) and issubclass(kind, usual))
        with self.assertRaisesRegex(bem_contact.Error, "no such file") as caught:
            bem_contact.solve("no/such.toml")
        self.assertIs(type(caught.exception), bem_contact.InputError)
        with unittest.mock.patch.dict(os.environ, TMPDIR="/no/such/folder"), \
                self.assertRaisesRegex(bem_contact.Error, "No temporary folder") as caught:
            bem_contact.wear(SCENES / "wear_collective.toml")
        self.assertIs(type(caught.exception), bem_contact.Error)

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

    def test_wrong_arguments_are_refused_in_our_words(self):
        for call, words in (
                (lambda: bem_contact.solve(), "path of a scene file"),
                (lambda: bem_contact.solve(3), "its type is int"),
                (lambda: bem_contact.solve(b"scene.toml"), "its type is bytes"),
                (lambda: bem_contact.solve(CORNER, [1]), "Give a dict"),
                (lambda: bem_contact.solve(CORNER, {1: 2}), "keys is of type int"),
                (lambda: bem_contact.solve(CORNER, model=3), "its type is int"),
                (lambda: bem_contact.solve(CORNER, modell="fem"), "Did you mean model"),
                (lambda: bem_contact.solve(CORNER, {}, "fem", False, 1), "too many arguments"),
                (lambda: bem_contact.solve(CORNER, {"load.force": 1j}), "its type is complex"),
                (lambda: bem_contact.solve(CORNER, {"load.force": np.complex64(1)}), "its type is complex64"),
                (lambda: bem_contact.solve(CORNER, {"load.force": {}}), "its type is dict"),
                (lambda: bem_contact.solve(CORNER, {"stresses.depths": np.ones((2, 2))}), "of type list"),
                (lambda: bem_contact.Sequence(), "path of a scene file"),
                (lambda: bem_contact.Sequence(CORNER, 1), "help(bem_contact.Sequence)"),
                (lambda: bem_contact.Sequence(CORNER, model="fem"), "scene, folder and threads")):
            with self.assertRaises(TypeError) as caught:
                call()
            self.assertIn(words, str(caught.exception))
            self.assertNotIn("incompatible", str(caught.exception))
        for changes, words in (({"grid.elements": 10**30}, "out of range"), ({"stresses.depths": ["deep"]}, "list of numbers"),
                               ({"load.force": np.nan}, "load.force"),
                               ({"load.force": np.array([1.0, 2.0])}, "load.force is a list"),
                               ({"stresses.depths": [-1.0]}, "stresses.depths")):
            with self.assertRaisesRegex(bem_contact.InputError, words):
                bem_contact.solve(CORNER, changes)

    def test_numbers_of_any_type(self):
        types = [float, int, np.float16, np.float32, np.float64, np.longdouble, np.int8, np.uint8, np.int32, np.uint64,
                 np.array, decimal.Decimal, fractions.Fraction]
        expected = bem_contact.solve(SCENES / "hertz.toml", {"load.force": 64.0}, "hertz").pmax
        for kind in types:
            self.assertEqual(bem_contact.solve(SCENES / "hertz.toml", {"load.force": kind(64)}, "hertz").pmax, expected)
        frictionless = bem_contact.solve(SCENES / "steady_rolling.toml", {"motion.frictionless": np.bool_(True)})
        self.assertEqual(frictionless.Fx, 0)
        for depths in ([0.5, 1], (0.5, 1.0), np.array([0.5, 1.0]), np.array([0.5, 1.0], dtype=np.float32),
                       [np.float32(0.5), np.int16(1)]):
            bem_contact.solve(SCENES / "hertz.toml", {"stresses.depths": depths}, "halfspace")

    def test_copies_and_pickles(self):
        r = bem_contact.solve(SCENES / "cattaneo.toml")
        for other in (copy.copy(r), copy.deepcopy(r), pickle.loads(pickle.dumps(r)),
                      pickle.loads(pickle.dumps(pickle.loads(pickle.dumps(r))))):
            self.assertIsInstance(other, bem_contact.Result)
            for name in (n for n in dir(bem_contact.Result) if not n.startswith("_") and n not in ("save", "report", "plot")):
                np.testing.assert_equal(getattr(other, name), getattr(r, name), name)
            self.assertEqual(repr(other), repr(r))

    def test_a_sequence_reads_its_scene_once(self):
        """The scene may change, and the working directory too: the text and the paths are those of the beginning."""
        with tempfile.TemporaryDirectory() as folder:
            before = Path.cwd()
            shutil.copytree(SCENES.parent / "influence", Path(folder) / "influence",
                            ignore=lambda _, names: [n for n in names if not n.startswith("small")])
            (Path(folder) / "scenes").mkdir()
            shutil.copy(CORNER, Path(folder) / "scenes" / "corner.toml")
            os.chdir(Path(folder) / "scenes")
            try:
                sequence = bem_contact.Sequence("corner.toml")
                os.chdir("/")
                (Path(folder) / "scenes" / "corner.toml").write_text("no scene")
                self.assertEqual(sequence.solve(model="fem").Fz, bem_contact.solve(CORNER, model="fem").Fz)
            finally:
                os.chdir(before)
        with self.assertRaisesRegex(bem_contact.InputError, "no such file"):
            bem_contact.Sequence("no/such.toml")

    def test_threads_share_one_sequence(self):
        sequence = bem_contact.Sequence(CORNER)
        found = {}

        def solve(i):
            found[i] = [sequence.solve({"position.lateral": 0.5 * (i + k)}, "halfspace") for k in range(3)]

        threads = [threading.Thread(target=solve, args=(i,)) for i in range(4)]
        for t in threads:
            t.start()
        for t in threads:
            t.join()
        for i, results in found.items():
            for k, r in enumerate(results):
                alone = bem_contact.solve(CORNER, {"position.lateral": 0.5 * (i + k)}, "halfspace")
                self.assertTrue(r.certified)
                self.assertAlmostEqual(r.Fy, alone.Fy, delta=1e-5 * alone.Fz)
        self.assertEqual(sorted(found), [0, 1, 2, 3])

    def interrupted(self, begin, call, after=""):
        """Presses Ctrl-C during a long call, in a process of its own, which must end in order; what it prints then."""
        code = f"""
import atexit, os, signal, threading, time
atexit.register(lambda: print("ended after", time.monotonic() - pressed[0]))  # and after what bem_contact waits for
import bem_contact
{begin}
pressed = []
def press():
    pressed.append(time.monotonic())
    os.kill(os.getpid(), signal.SIGINT)
threading.Timer(0.3, press).start()
try:
    {call}
    print("was not interrupted")
except KeyboardInterrupt:
    print("interrupted after", time.monotonic() - pressed[0])
{after}
"""
        run = subprocess.run([sys.executable, "-c", code], check=True, stdout=subprocess.PIPE, text=True)
        *lines, ended = run.stdout.splitlines(keepends=True)
        self.assertLess(float(ended.split()[-1]), 2, "what was stopped went on")
        return "".join(lines)

    def test_interrupted(self):
        """Ctrl-C ends a long solution; the sequence can be used again."""
        out = self.interrupted(f"sequence = bem_contact.Sequence({str(CORNER)!r})",
                               'sequence.solve({"grid.dx": 0.06, "grid.ds": 0.06}, "halfspace")',
                               'print(sequence.solve({}, "halfspace").certified)')
        self.assertRegex(out, r"^interrupted after .*\nTrue\n$")

    def test_interrupted_curves(self):
        for call in (f'bem_contact.creep_curves({str(CORNER)!r}, model="halfspace")',
                     'bem_contact.conicity(changes={"wheel.profile": "S1002", "rail.profile": "60E1"}, roll=True, to=40, '
                     'step=0.005)'):
            self.assertRegex(self.interrupted("", call), r"^interrupted after .*\n$")

    def test_interrupted_wear(self):
        """A step of many cases ends with the case that is being solved."""
        scene = """rail.profile = "60E1"
wheel.profile = "S1002"
solver.model = "halfspace"
load.force = 8e4
motion = { xi = 2e-3, free_rolling = false }
grid = { dx = 0.5, ds = 0.5 }
sweep.position.lateral = { from = 0, to = 2, count = 1000 }
"""
        self.assertRegex(self.interrupted("", f"bem_contact.wear({scene!r})"), r"^interrupted after .*\n$")

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

    def test_wear_and_fatigue(self):
        r = bem_contact.solve(SCENES / "steady_rolling.toml")  # mild wear: linear in T-gamma
        wear, fatigue = bem_contact.wear(r), bem_contact.fatigue(r, stresses=False)
        area = (r.x[1] - r.x[0]) * (r.s[1] - r.s[0])
        self.assertAlmostEqual(wear["volume_per_distance"] * 7.8e-6 / 5.3e-12 / r.T_gamma, 1, delta=1e-9)
        self.assertAlmostEqual(wear["rate"].sum() * area / wear["volume_per_distance"], 1, delta=1e-9)
        self.assertAlmostEqual(sum(p["T_gamma"] for p in fatigue["patches"]) / r.T_gamma, 1, delta=1e-9)
        self.assertEqual(fatigue["FI"].shape, r.p_n.shape)
        self.assertNotIn("von_mises", fatigue)
        self.assertNotIn("axle_load", wear)  # a patch has no wheel
        solved = bem_contact.solve(CORNER, model="halfspace")
        rates = bem_contact.wear(solved)
        self.assertAlmostEqual(rates["axle_load"], 2 * solved.Fz / 9806.65)
        self.assertAlmostEqual(rates["rail_area_per_mgt"] * rates["axle_load"] / rates["rail_area_per_million_axles"], 1)
        self.assertAlmostEqual(rates["rail_depth_per_million_axles"] / rates["depth"].max(), 1e6, delta=1)
        kth = ([200, 700], [2400], [[5.5e-4, 35e-4, 5.5e-4], [350e-4, 350e-4, 350e-4]])
        by_map = bem_contact.wear(r, "archard", map=kth)
        np.testing.assert_array_equal(by_map["depth"], bem_contact.wear(r, "archard")["depth"])
        with self.assertRaisesRegex(bem_contact.InputError, "2 regions, and it has 1 coefficients"):
            bem_contact.wear(r, "archard", map=([200], [], [[1e-4]]))
        with self.assertRaisesRegex(bem_contact.InputError, "There is no wear law 'x'"):
            bem_contact.wear(r, "x")
        with self.assertRaisesRegex(bem_contact.InputError, "solved here"):
            bem_contact.wear(pickle.loads(pickle.dumps(r)))


if __name__ == "__main__":
    unittest.main()
