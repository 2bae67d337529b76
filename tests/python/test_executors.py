"""Work shared by executors: the numbers are those of one process."""

import concurrent.futures
import multiprocessing
import os
import pickle
import signal
import tempfile
import unittest
from pathlib import Path

import numpy as np

import bem_contact

PATCH = """kind = "patch"
motion.friction = 0.3
grid = { dx = 0.8, ds = 0.8, mx = 12, ms = 12 }
gap = { a = 1e-3, b = 1e-3 }
"""
SWEEP = PATCH + """[sweep]
load.force = [4e3, 5e3, 6e3, 7e3]
motion.xi = { from = 0, to = 2e-3, count = 5 }
"""
TABLE = PATCH + """motion.xi = 1e-3
[table]
load.force = [4e3, 7e3]
hold = ["Fx"]
"""
COLLECTIVE = """rail.profile = "60E1"
wheel.profile = "S1002"
load.force = 8e4
motion = { xi = 2e-3, free_rolling = false }
solver.model = "halfspace"
grid = { dx = 2, ds = 1 }
[sweep]
position.lateral = [0, 0.5, 1, 1.5, 2, 2.5]
"""
WHEELSET = """rail.profile = "60E1"
wheel.profile = "S1002"
solver.model = "halfspace"
position.rail_inclination = 0.025
motion.friction = 0.3
grid = { dx = 1.5, ds = 1 }
wheelset.force = 2e5
[sweep]
position.lateral = [-2, -1, 0, 1, 2]
"""


STUDY = """rail.profile = "60E1"
wheel.profile = "S1002"
load.force = 8e4
motion = { friction = 0.3, xi = 1e-3 }
solver.model = "halfspace"
grid = { dx = 2, ds = 1.5 }
conicity.to = 3
creep_curves.xi = "-1e-3:1e-3:3"
sweep.position.lateral = [0, 1]
[uncertainty]
friction = 0.03
draws = 3
parts = "creep_curves"
"""


def die():
    os.kill(os.getpid(), signal.SIGKILL)


class AtOnce:
    """An executor of somebody else: it has submit() alone, and runs a task at once."""

    def submit(self, function, *arguments):
        future = concurrent.futures.Future()
        try:
            future.set_result(pickle.loads(pickle.dumps(function(*pickle.loads(pickle.dumps(arguments))))))
        except Exception as error:
            future.set_exception(error)
        return future


class Executors(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.processes = concurrent.futures.ProcessPoolExecutor(2, mp_context=multiprocessing.get_context("spawn"))

    @classmethod
    def tearDownClass(cls):
        cls.processes.shutdown()

    def assert_same(self, one, other):
        self.assertEqual(list(one), list(other))
        for name, column in one.items():
            if isinstance(column, dict):
                self.assert_same(column, other[name])
            elif name not in ("seconds", "cpu_seconds"):
                np.testing.assert_array_equal(other[name], column, err_msg=name)

    def test_a_sweep_is_that_of_one_process(self):
        alone = bem_contact.sweep(SWEEP, {"motion.eta": 1e-4})
        self.assertEqual(set(alone["status"]), {"certified"})
        with concurrent.futures.ThreadPoolExecutor(2) as threads:
            for executor in (self.processes, threads, AtOnce()):
                self.assert_same(alone, bem_contact.sweep(SWEEP, {"motion.eta": 1e-4}, executor=executor))

    def test_parts_of_a_sweep_are_kept_in_a_folder(self):
        """Whatever happens to the workers: the same call solves what is missing, and the program joins them."""
        changes = {"motion.eta": 1e-4, "grid.mx": 100, "grid.ms": 100}  # else so little work is one part
        alone = bem_contact.sweep(SWEEP, changes)
        with tempfile.TemporaryDirectory() as folder:
            output = Path(folder, "parts")
            with concurrent.futures.ProcessPoolExecutor(1, mp_context=multiprocessing.get_context("spawn")) as doomed:
                with self.assertRaises(concurrent.futures.BrokenExecutor):
                    bem_contact.sweep(SWEEP, changes, executor=doomed, output=output,
                                      progress=lambda done, of: [os.kill(pid, signal.SIGKILL) for pid in list(doomed._processes)])
            # The one that was being written is not there under its name.
            kept = {file.name: file.stat().st_mtime_ns for file in output.glob("*.h5")}
            self.assertTrue(kept)
            told = []
            self.assert_same(alone, bem_contact.sweep(SWEEP, changes, executor=self.processes, output=output,
                                                      progress=lambda *numbers: told.append(numbers)))
            self.assertEqual(told[-1], (20, 20))
            self.assertEqual(sum(done < of for done, of in told), len(told) - 1)
            files = {file.name: file.stat().st_mtime_ns for file in output.glob("*.h5")}
            self.assertEqual({name: files[name] for name in kept}, kept)
            damaged = output / sorted(files)[0]
            damaged.write_bytes(damaged.read_bytes()[:1000])
            self.assert_same(alone, bem_contact.sweep(SWEEP, changes, output=output))  # in this process
            with self.assertRaisesRegex(bem_contact.InputError, "belongs to another sweep .its options were ' motion.eta = 0.0001"):
                bem_contact.sweep(SWEEP, {**changes, "motion.eta": 0.0}, executor=AtOnce(), output=output)

    def test_the_parent_keeps_columns(self):
        """What an executor's parent holds of a case: its numbers, and no object of Python for each."""
        answers = []

        class Listening(AtOnce):
            def submit(self, function, *arguments):
                future = super().submit(function, *arguments)
                answers.append(future.result())
                return future

        found = bem_contact.sweep(SWEEP, executor=Listening())
        numbers = sum(np.size(column) for table in (found, found["patches"]) for column in table.values())
        self.assertTrue(all(isinstance(answer, bytes) for answer in answers))
        self.assertLess(sum(map(len, answers)), 9 * numbers + 3000)

    def test_a_sweep_of_wheelsets(self):
        self.assert_same(bem_contact.sweep(WHEELSET), bem_contact.sweep(WHEELSET, executor=self.processes))

    def test_paths_are_those_of_the_caller(self):
        with tempfile.TemporaryDirectory() as folder:
            Path(folder, "w.txt").write_text((Path(__file__).parents[2] / "data/bodies/hollow_wheel.txt").read_text())
            Path(folder, "s.toml").write_text("rail.profile = '60E1'\nwheel = { profile = 'w.txt', smoothing = 8 }\n"
                                              "load.force = 8e4\nmotion.frictionless = true\nsolver.model = 'halfspace'\n"
                                              "grid = { dx = 2, ds = 1 }\n[sweep]\nposition.lateral = [0, 1, 2, 3, 900]\n")
            alone = bem_contact.sweep(f"{folder}/s.toml")
            self.assertEqual(alone["status"], ["certified"] * 4 + ["refused"])
            self.assert_same(alone, bem_contact.sweep(f"{folder}/s.toml", executor=self.processes))

    def test_a_table_does_not_depend_on_how_many_share_it(self):
        shared = bem_contact.table(TABLE, tolerance=0.02, executor=self.processes)
        self.assert_same(shared, bem_contact.table(TABLE, tolerance=0.02, executor=AtOnce()))
        alone = bem_contact.table(TABLE, tolerance=0.02)
        np.testing.assert_array_equal(shared["axes"]["load.force"], alone["axes"]["load.force"])
        np.testing.assert_allclose(shared["values"]["Fx"], alone["values"]["Fx"], rtol=1e-5)
        creep = {"tolerance": 0.28, "elements": 6, "ratio": (1, 1.2)}
        shared = bem_contact.table(**creep, executor=self.processes)
        self.assert_same(shared, bem_contact.table(**creep, executor=AtOnce()))
        self.assertEqual(shared["solved"], bem_contact.table(**creep)["solved"])

    def assert_alike(self, one, other, tolerance=1e-5):
        self.assertEqual(list(one), list(other))
        for name, column in one.items():
            if isinstance(column, dict):
                self.assert_alike(column, other[name], tolerance)
            elif isinstance(column, np.ndarray) and not name.endswith("_error") and name != "errors":
                np.testing.assert_allclose(other[name], column, rtol=0, atol=tolerance * np.max(np.abs(column)), err_msg=name)

    def test_wear_does_not_depend_on_how_many_share_it(self):
        """Chunks of the cases start cold, so that it is within the certificate what one process finds alone."""
        for options in ({"body": "wheel"}, {"law": "archard", "hardness": 2000, "speed": 2e4}):
            shared = bem_contact.wear(COLLECTIVE, 0.03, executor=self.processes, **options)
            self.assert_same(shared, bem_contact.wear(COLLECTIVE, 0.03, executor=AtOnce(), **options))
            alone = bem_contact.wear(COLLECTIVE, 0.03, **options)
            self.assert_alike(alone, shared)
            self.assertGreater(alone["wheel_depth"].max(), 0.02)

    def test_wear_with_influence_files_of_a_folder(self):
        folder = Path(__file__).parents[2] / "data/influence"
        scene = {"rail": {"profile": "60E1", "influence": "small_rail.h5"}, "wheel": {"profile": "S1002", "influence": "small_wheel.h5"},
                 "solver.model": "fem", "load.force": 1e5, "motion.free_rolling": False, "motion.xi": 1e-3, "grid": {"dx": 1, "ds": 0.5},
                 "sweep": {"position.lateral": [6.5, 6.6]}}
        shared = bem_contact.wear(scene, 0.01, folder=folder, executor=self.processes)
        self.assert_alike(bem_contact.wear(scene, 0.01, folder=folder), shared)

    def test_creep_curves_do_not_depend_on_how_many_share_them(self):
        for scene in (PATCH + "load.force = 5e3\nlayer.slope = 0.6\n", PATCH + "load.force = 5e3\nmotion.eta = 1e-3\n"):
            asked = {"changes": {"motion.xi": 5e-4}, "xi": np.linspace(-2e-3, 2e-3, 9), "phi": [0, 1e-4]}
            alone = bem_contact.creep_curves(scene, **asked)
            shared = bem_contact.creep_curves(scene, **asked, executor=self.processes)
            self.assert_same(shared["curves"]["xi"], bem_contact.creep_curves(scene, **asked, executor=AtOnce())["curves"]["xi"])
            self.assert_alike(alone["curves"], shared["curves"])
            np.testing.assert_allclose(shared["sensitivities"], alone["sensitivities"], rtol=0, atol=2e-3 * np.max(np.abs(alone["slopes"])))

    def test_a_map_of_conicities_is_that_of_one_process(self):
        changes = {"wheel.profile": "S1002", "rail.profile": "60E1", "position.rail_inclination": 0.025}
        many = {"wheels": ["S1002", "LMA"], "gauges": [1434, 1435], "noise": 0.01, "draws": 2}
        self.assert_same(bem_contact.conicity_map(None, changes, **many), bem_contact.conicity_map(None, changes, **many, executor=self.processes))

    def test_a_study_is_that_of_one_process(self):
        with tempfile.TemporaryDirectory() as folder:
            alone, shared = (bem_contact.study(STUDY, Path(folder, name), executor=executor)
                             for name, executor in (("alone", None), ("shared", self.processes)))
            self.assertEqual({part["study_status"] for part in alone["parts"].values()}, {"certified", "done"})
            self.assertEqual(set(alone["parts"]), {"sweep", "conicity", "creep_curves"})
            self.assertIn("creep_curves/slopes: dFx/dxi", map("/".join, zip(alone["headline_parts"], alone["headline_names"])))
            self.assertEqual(shared["headline_names"], alone["headline_names"])
            for name, column in alone["headline"].items():
                np.testing.assert_array_equal(shared["headline"][name], column, err_msg=name)
            self.assertEqual(np.nanmax(alone["headline"]["draws"]), 3)
            parts = Path(folder, "shared", "parts")
            before = {file: file.stat().st_mtime_ns for file in parts.rglob("*.h5")}
            self.assertEqual(len(before), 6)  # three parts, three draws
            bem_contact.study(STUDY, Path(folder, "shared"), executor=AtOnce())
            self.assertEqual({file: file.stat().st_mtime_ns for file in parts.rglob("*.h5")}, before)

    def test_a_study_of_a_wheelset_and_paths_of_a_dict(self):
        """Parts of one wheel wait for the wheelset; a part that is refused leaves the others alone."""
        profile = Path(__file__).parents[2] / "data/bodies/hollow_wheel.txt"
        scene = {"rail.profile": "60E1", "wheel": {"profile": profile.name, "smoothing": 8}, "solver.model": "halfspace",
                 "grid": {"dx": 2, "ds": 1.5}, "wheelset.force": 1.6e5, "position.lateral": 3, "motion.friction": 0.3,
                 "fatigue": {"yield_shear": 350}, "conicity": {"to": -3}}
        with tempfile.TemporaryDirectory() as folder:
            found = bem_contact.study(scene, folder, folder=profile.parent, executor=self.processes)
            self.assertEqual({name: part["study_status"] for name, part in found["parts"].items()},
                             {"wheelset": "certified", "fatigue": "certified", "conicity": "refused"})
            self.assertEqual(found["parts"]["fatigue"]["yield_shear"], 350)
            with self.assertRaisesRegex(bem_contact.InputError, "load.farce"):
                bem_contact.study("load.farce = 3\n", folder)
            with self.assertRaisesRegex(bem_contact.InputError, "missing.toml"):
                bem_contact.study("missing.toml", folder, executor=AtOnce())

    def test_work_of_a_worker_that_was_killed_is_not_lost_in_silence(self):
        """The engine says it, and the same call with another finds the same."""
        scene = PATCH + "load.force = 5e3\n"
        with concurrent.futures.ProcessPoolExecutor(1, mp_context=multiprocessing.get_context("spawn")) as doomed:
            doomed.submit(die)
            with self.assertRaises(concurrent.futures.BrokenExecutor):
                bem_contact.creep_curves(scene, xi=[0, 1e-3], executor=doomed)
            with self.assertRaises(concurrent.futures.BrokenExecutor):
                bem_contact.wear(COLLECTIVE, 0.02, executor=doomed)
        self.assert_alike(bem_contact.wear(COLLECTIVE, 0.02), bem_contact.wear(COLLECTIVE, 0.02, executor=self.processes))

    def test_an_error_comes_back_as_what_it_was(self):
        with self.assertRaisesRegex(bem_contact.InputError, "The table has no value at position.lateral = 300"):
            bem_contact.table({"rail.profile": "60E1", "wheel.profile": "S1002", "motion.frictionless": True,
                               "solver.model": "halfspace", "grid": {"dx": 2, "ds": 1}, "load.force": 1e4},
                              {"position.lateral": [0, 300]}, executor=self.processes)

    def test_what_is_no_executor(self):
        for wrong in (2, "processes", multiprocessing):
            with self.assertRaisesRegex(TypeError, "no method submit"):
                bem_contact.sweep(SWEEP, executor=wrong)
            with self.assertRaisesRegex(TypeError, "no method submit"):
                bem_contact.wear(COLLECTIVE, executor=wrong)
            with self.assertRaisesRegex(TypeError, "no method submit"):
                bem_contact.creep_curves(PATCH + "load.force = 5e3\n", xi=[0], executor=wrong)

    def test_a_sequence_can_be_pickled(self):
        with tempfile.TemporaryDirectory() as folder:
            Path(folder, "s.toml").write_text(PATCH + "load.force = 5e3\n")
            sequence = bem_contact.Sequence(f"{folder}/s.toml", threads=2)
            copy = pickle.loads(pickle.dumps(sequence))
        cases = [{"motion.xi": xi} for xi in (0.0, 1e-3)]
        alone = [sequence.solve(case).Fx for case in cases]
        self.assertEqual([copy.solve(case).Fx for case in cases], alone)
        # Each case in a process of its own starts cold, and so does a copy of one that was used.
        cold = list(self.processes.map(sequence.solve, cases))
        self.assertEqual([r.Fx for r in cold], [bem_contact.Sequence(PATCH + "load.force = 5e3\n").solve(c).Fx for c in cases])


if __name__ == "__main__":
    unittest.main()
