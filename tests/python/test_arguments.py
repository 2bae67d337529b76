"""What Python may hand over, and when: numbers of any type, dicts that hold themselves, names that are no UTF-8, the end of Python."""

import itertools
import os
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

import numpy as np

import bem_contact

SCENES = Path(__file__).resolve().parents[2] / "data" / "scenes"
HERTZ, ROLLING = SCENES / "hertz.toml", SCENES / "steady_rolling.toml"
PATCH = {"kind": "patch", "load.force": 1e4, "motion.frictionless": True, "grid": {"dx": 0.5, "ds": 0.5, "mx": 24, "ms": 24},
         "gap": {"a": 1e-3, "b": 1e-3}}
PAIR = {"wheel.profile": "S1002", "rail.profile": "60E1"}
CREEP_TABLE = {"tolerance": 0.25, "elements": 10}
COLLECTIVE = {**PAIR, "solver.model": "halfspace", "load.force": 8e4, "motion": {"xi": 2e-3, "free_rolling": False},
              "grid": {"dx": 1, "ds": 0.5}, "sweep": {"position.lateral": [0.0, 1.0]}}


def plain(value):
    """What two calls of a function have returned, to be compared."""
    if isinstance(value, dict):
        return {key: plain(v) for key, v in value.items() if key != "seconds"}
    return value.tolist() if isinstance(value, np.ndarray) else value


class Numbers(unittest.TestCase):
    """Every argument that is a float takes whole numbers and NumPy's."""

    TYPES = (int, np.float16, np.float32, np.int8, np.int64, np.array)

    def alike(self, call, **values):
        """`values` are whole, and all types have them."""
        self.same(call, values, [dict.fromkeys(values, kind) for kind in self.TYPES])

    def alike_at_once(self, call, **values):
        """As alike(), in one call of a function that takes long: each value has another type."""
        self.same(call, values, [dict(zip(values, itertools.cycle(self.TYPES)))])

    def same(self, call, values, types):
        expected = plain(call(**{name: float(value) for name, value in values.items()}))
        for kinds in types:
            with self.subTest(kinds):
                self.assertEqual(repr(plain(call(**{name: kinds[name](value) for name, value in values.items()}))), repr(expected))

    def test_wear_and_fatigue_of_a_result(self):
        result = bem_contact.solve(ROLLING)
        self.alike(lambda **n: bem_contact.wear(result, "archard", **n), hardness=100, speed=120)
        self.alike(lambda hardness: bem_contact.wear(result, "archard", hardness), hardness=100)
        self.alike(lambda **n: bem_contact.fatigue(result, stresses=False, **n), yield_shear=100)
        whole, real = ([[a, b], [c], [[1, 2, 3], [4, 5, 6]]] for a, b, c in ((1, 2, 3), (1.0, 2.0, 3.0)))
        self.assertEqual(plain(bem_contact.wear(result, "archard", map=whole)), plain(bem_contact.wear(result, "archard", map=real)))
        of = {"nodes": [15, 175, 1000], "damage": [0, 1, 1]}
        as_arrays = {name: np.array(values, dtype=np.float32) for name, values in of.items()}
        self.assertEqual(plain(bem_contact.fatigue(result, **of)), plain(bem_contact.fatigue(result, **as_arrays)))
        for wrong in ({"hardness": "hard"}, {"hardnes": 3000}, {"law": 3}):
            with self.assertRaises(TypeError) as caught:
                bem_contact.wear(result, **wrong)
            self.assertNotIn("its type is Result", str(caught.exception))

    def test_wear_and_fatigue_of_a_collective(self):
        self.alike_at_once(lambda **n: bem_contact.wear(COLLECTIVE, law="archard", cap=0.5, body="wheel", **n), depth=1, hardness=100,
                           speed=120, smoothing=3, passages=1, kept_turn=1)
        self.alike_at_once(lambda **n: bem_contact.fatigue(COLLECTIVE, **n), yield_shear=100)

    def test_all_other_functions(self):
        self.alike(lambda **n: bem_contact.conicity(changes=PAIR, **n), to=4, step=2)
        self.alike(lambda **n: bem_contact.conicity_map(changes=PAIR, gauges=[1435], draws=2, **n), amplitude=2, noise=0)
        self.alike(lambda step: bem_contact.profile("60E1", step=step), step=1)
        of_types = [bem_contact.table(tolerance=kind(0.25), poisson=kind(0.25), elements=10)["values"]
                    for kind in (float, np.float16, np.float32)]
        for values in of_types[1:]:
            self.assertEqual(plain(values), plain(of_types[0]))
        of_types = [bem_contact.table(ratio=(kind(1), kind(2)), **CREEP_TABLE)["axes"] for kind in (float, int, np.float32, np.int64)]
        for axes in of_types[1:]:
            self.assertEqual(plain(axes), plain(of_types[0]))
        with tempfile.TemporaryDirectory() as folder:
            bem_contact.table(output=Path(folder) / "t.h5", **CREEP_TABLE)
            table = bem_contact.read_table(Path(folder) / "t.h5")
        self.alike(lambda **n: table.creep_forces(**n), a=4, b=4, shear_modulus=100, bound=100, xi=0, eta=0, phi=0)


class Scenes(unittest.TestCase):
    def test_a_dict_that_holds_itself(self):
        scene, changes = {"kind": "patch"}, {}
        scene["load"] = scene
        changes["load"] = {"more": changes}
        deep = {}
        for _ in range(100_000):
            deep = {"a": deep}
        for call in (bem_contact.solve, bem_contact.check, bem_contact.compare, bem_contact.sweep, bem_contact.table, bem_contact.wear,
                     bem_contact.fatigue, bem_contact.wheelset, bem_contact.creep_curves, bem_contact.conicity, bem_contact.Sequence):
            for given in (scene, deep):
                with self.assertRaisesRegex(bem_contact.InputError, "nested in it more than"):
                    call(given)
        for given in (changes, deep):
            with self.assertRaisesRegex(bem_contact.InputError, "nested in it more than"):
                bem_contact.solve(HERTZ, given)
        while deep:  # Python itself would take them apart by recursion
            deep = deep["a"]

    def test_no_folder_is_the_working_directory(self):
        for call in (bem_contact.solve, bem_contact.check, bem_contact.compare, bem_contact.creep_curves):
            for folder in ("", os.path.dirname("scene.toml"), Path("")):
                with self.assertRaisesRegex(bem_contact.InputError, "nosuch"):
                    call({**COLLECTIVE, "rail.profile": "nosuch.txt"}, folder=folder)
        self.assertTrue(bem_contact.solve(PATCH, folder="").certified)
        self.assertTrue(bem_contact.Sequence(PATCH, folder="").solve().certified)
        self.assertEqual(bem_contact.sweep({**PATCH, "sweep": {"load.force": [1e4]}}, folder="")["status"], ["certified"])
        for call in (bem_contact.table, bem_contact.wheelset, bem_contact.wear, bem_contact.fatigue):
            with self.assertRaises(bem_contact.InputError):
                call(PATCH, folder="")
        before = os.getcwd()
        with tempfile.TemporaryDirectory() as folder:
            (Path(folder) / "gap.csv").write_text("ix,is,h\n" + "".join(f"{i},{k},{1e-3 * (i - 2)**2 + 1e-3 * (k - 2)**2}\n"
                                                                        for i in range(5) for k in range(5)))
            scene = {"kind": "patch", "load.force": 10, "motion.frictionless": True, "gap.table": "gap.csv",
                     "grid": {"dx": 1, "ds": 1, "mx": 5, "ms": 5}}
            os.chdir(folder)
            try:
                self.assertEqual(bem_contact.solve(scene, folder="").Fz, 10)
            finally:
                os.chdir(before)

    def test_names_that_are_no_UTF_8(self):
        name = os.fsdecode(b"worn\xff.txt")
        for call in (lambda: bem_contact.solve(HERTZ, {"rail.influence": name}), lambda: bem_contact.solve({"kind": name}),
                     lambda: bem_contact.solve({name: 1}), lambda: bem_contact.solve(name), lambda: bem_contact.solve(Path(name)),
                     lambda: bem_contact.solve(HERTZ, {name: 1}), lambda: bem_contact.solve(HERTZ, model=name),
                     lambda: bem_contact.solve(PATCH, folder=name), lambda: bem_contact.solve("kind = 1\n" + name),
                     lambda: bem_contact.sweep({**PATCH, "sweep": {"rail.profile": [name]}}), lambda: bem_contact.profile(name, "rail"),
                     lambda: bem_contact.profile("60E1", name), lambda: bem_contact.conicity(changes=PAIR, left_rail=name),
                     lambda: bem_contact.read_table(name), lambda: bem_contact.report(name, "page.html"),
                     lambda: bem_contact.solve(PATCH, **{name: 1})):
            with self.assertRaises(bem_contact.InputError):
                call()

    def test_messages_are_short(self):
        long, numbers = "a" * 1_000_000, [np.nan] * 300_000
        for call in (lambda: bem_contact.solve({**COLLECTIVE, "rail.profile": long}), lambda: bem_contact.solve({**PATCH, long: 1}),
                     lambda: bem_contact.solve({**PATCH, "kind": long}), lambda: bem_contact.solve({**PATCH, "stresses.depths": numbers}),
                     lambda: bem_contact.solve(long), lambda: bem_contact.solve(PATCH, {"load": {long: 1}}),
                     lambda: bem_contact.solve(PATCH, model=long),
                     lambda: bem_contact.profile(long), lambda: bem_contact.read_table(long), lambda: bem_contact.report(long, "page.html"),
                     lambda: bem_contact.solve(PATCH, **{long: 1})):
            begin = time.monotonic()
            with self.assertRaises((bem_contact.InputError, TypeError)) as caught:
                call()
            self.assertLess(len(str(caught.exception)), 1000)
            self.assertLess(time.monotonic() - begin, 20)


class Sweeps(unittest.TestCase):
    TEXT = """kind = "patch"
motion.frictionless = true
grid = { dx = 0.5, ds = 0.5, mx = 24, ms = 24 }
gap = { a = 1e-3, b = 1e-3 }
[sweep]
mode = "zip"
load.force = [1e4, 2e4, 3e4]
solver.model = ["halfspace", "hertz", "halfspace"]
weight = [3, 1, 2]
"""

    def test_a_dict_has_a_table_as_a_file_has(self):
        expected = bem_contact.sweep(self.TEXT)
        base = {key: value for key, value in PATCH.items() if key != "load.force"}
        sweep = {"mode": "zip", "load": {"force": np.array([1e4, 2e4, 3e4])}, "solver.model": ["halfspace", "hertz", "halfspace"],
                 "weight": (3, 1, 2)}
        ranged = {**sweep, "load": {"force": {"from": 1e4, "to": np.float32(3e4), "count": 3}}}
        for given in (sweep, ranged):
            found = bem_contact.sweep({**base, "sweep": given})
            for name in ("pmax", "status", "model", "weight", "load.force"):
                self.assertEqual(plain(found[name]), plain(expected[name]), name)
        self.assertTrue(bem_contact.solve({**PATCH, "sweep": sweep}).certified)  # as of a file, [sweep] is for sweeps

    def test_changes(self):
        for text in (self.TEXT, self.TEXT.replace('mode = "zip"\n', "").replace('solver.model = ["halfspace", "hertz", "halfspace"]\n', "")):
            expected = bem_contact.sweep(text.replace("a = 1e-3", "a = 2e-3"))
            for changes in ({"gap.a": 2e-3}, {"gap": {"a": np.float64(2e-3)}}):
                found = bem_contact.sweep(text, changes)
                self.assertEqual(list(found), list(expected))
                self.assertEqual(plain(found["pmax"]), plain(expected["pmax"]))
        text = self.TEXT.replace('solver.model = ["halfspace", "hertz", "halfspace"]\n', "")
        self.assertEqual(bem_contact.sweep(text, {"gap.b": 2e-3}, "hertz")["model"], ["hertz"] * 3)
        self.assertEqual(bem_contact.sweep(text, "hertz")["model"], ["hertz"] * 3)  # it was the second argument
        for words, changes in (("the sweep gives it", {"load.force": 1.0}), ("unknown key", {"gap.z": 1.0}), ("gap.a", {"gap.a": np.nan})):
            with self.assertRaisesRegex(bem_contact.InputError, words):
                bem_contact.sweep(text, changes)


def ends(code):
    """A Python of its own: its exit code and what it says."""
    done = subprocess.run([sys.executable, "-W", "ignore::DeprecationWarning", "-c", f"SCENES = {str(SCENES)!r}\n{code}"], capture_output=True, text=True, timeout=120)
    return done.returncode, done.stdout + done.stderr


class Processes(unittest.TestCase):
    def test_daemons_that_solve_when_python_ends(self):
        """Also those that begin then, and functions that Python calls on its way."""
        code, said = ends("""
import atexit
def at_the_end():
    assert bem_contact.solve(SCENES + "/hertz.toml").certified
    print("solved at the end")
atexit.register(at_the_end)
import bem_contact, threading, time
def endless(call):
    while True:
        call()
sequence = bem_contact.Sequence(SCENES + "/conformal_small.toml")
for call in (lambda: bem_contact.table(SCENES + "/forces_to_look_up.toml"), lambda: bem_contact.solve(SCENES + "/hertz.toml"),
             lambda: sequence.solve({"grid.dx": 0.1, "grid.ds": 0.1}, "halfspace"), lambda: sequence.solve(model="halfspace"),
             lambda: bem_contact.sweep(SCENES + "/cases_halfspace.toml"), lambda: bem_contact.check(SCENES + "/hertz.toml")):
    threading.Thread(target=endless, args=[call], daemon=True).start()
time.sleep(0.5)
print("exit")
""")
        self.assertEqual((code, said), (0, "exit\nsolved at the end\n"))

    def test_a_fork_while_another_thread_solves(self):
        code, said = ends("""
import bem_contact, os, signal, threading, time
sequence = bem_contact.Sequence(SCENES + "/conformal_small.toml")
fine = {"grid.dx": 0.1, "grid.ds": 0.1}
thread = threading.Thread(target=lambda: [sequence.solve(fine, "halfspace") for _ in range(3)])
thread.start()
time.sleep(0.2)
def child():
    process = os.fork()
    if process == 0:
        signal.alarm(60)
        try:
            bem_contact.solve(SCENES + "/hertz.toml")
            os._exit(1)
        except bem_contact.Error as error:
            os._exit(0 if "forked while another thread was solving" in str(error) else 2)
    return os.waitstatus_to_exitcode(os.waitpid(process, 0)[1])
print(child())
thread.join()
print(child(), bem_contact.solve(SCENES + "/hertz.toml").certified)
""")
        self.assertEqual((code, said), (0, "0\n1 True\n"))


if __name__ == "__main__":
    unittest.main()
