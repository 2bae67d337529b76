"""Work shared by executors: the numbers are those of one process."""

import concurrent.futures
import multiprocessing
import pickle
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

    def test_an_error_comes_back_as_what_it_was(self):
        with self.assertRaisesRegex(bem_contact.InputError, "The table has no value at position.lateral = 300"):
            bem_contact.table({"rail.profile": "60E1", "wheel.profile": "S1002", "motion.frictionless": True,
                               "solver.model": "halfspace", "grid": {"dx": 2, "ds": 1}, "load.force": 1e4},
                              {"position.lateral": [0, 300]}, executor=self.processes)

    def test_what_is_no_executor(self):
        for wrong in (2, "processes", multiprocessing):
            with self.assertRaisesRegex(TypeError, "no method submit"):
                bem_contact.sweep(SWEEP, executor=wrong)

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
