"""Whether a result is certified is one yes or no, of all its steps, and every door says the same."""

import csv
import ctypes
import json
import os
import re
import subprocess
import tempfile
import unittest
from pathlib import Path

import h5py
import numpy as np

import bem_contact
from bem_contact.plotting.contact import Contact

ROOT = Path(__file__).resolve().parents[2]

SHIFT = """kind = "patch"
wheel.material = { shear_modulus = 800, poisson = 0 }
load.approach = 0.01
motion = { kind = "shift", step_table = "steps.csv", friction = 0.3, xi = 1e-3 }
solver = { max_outer = 1, model = "halfspace" }
grid = { dx = 0.5, ds = 0.5, mx = 16, ms = 16 }
gap = { a = 1e-3, b = 1e-3 }
"""
STEPS = {  # one outer iteration is too few for unlike materials; without contact it is enough
    "the first four are no solutions": ([0.01, 0.01, 0.01, 0.01, -0.01], False),
    "the last is none": ([-0.01, 0.01], False),
    "all are solutions": ([-0.01, -0.02], True),
}
WARNED = """rail.profile = "60E1"
wheel.profile = "S1002"
position.rail_inclination = 0.025
load.force = 4e5
motion = { friction = 1.2, xi = 0.15 }
stresses.x = [1]
solver.model = "halfspace"
grid = { dx = 1.0, ds = 0.5 }
"""


class Doors(unittest.TestCase):
    def setUp(self):
        self.temporary = tempfile.TemporaryDirectory()
        self.folder = Path(self.temporary.name)
        self.scene = self.folder / "s.toml"

    def tearDown(self):
        self.temporary.cleanup()

    def program(self, *arguments):
        return subprocess.run([os.environ["BEM_CONTACT"], *map(str, arguments)], capture_output=True, text=True)

    def warnings_of_c(self):
        library = ctypes.CDLL(os.environ["CONFORMAL_LIBRARY"])
        handle, message, count, text = ctypes.c_void_p(), ctypes.create_string_buffer(2000), ctypes.c_int(), ctypes.c_char_p()
        self.assertEqual(library.conformal_open_file(str(self.scene).encode(), ctypes.byref(handle), message, 2000), 0, message.value)
        library.conformal_solve(handle)
        library.conformal_warning_count(handle, ctypes.byref(count))
        out = []
        for ask in (library.conformal_warning, library.conformal_warning_kind):
            for k in range(count.value):
                self.assertEqual(ask(handle, k, ctypes.byref(text)), 0)
                out.append(text.value.decode())
        self.assertEqual(library.conformal_warning_kind(handle, count.value, ctypes.byref(text)), 2)
        library.conformal_close(handle)
        return out

    def test_warnings_and_their_kinds(self):
        """The most important comes first, whatever found it, and each door has the kind beside the text."""
        self.scene.write_text(WARNED)
        kinds = ["unlikely_value", "large_creepage", "yield", "without_effect"]
        done = self.program("solve", self.scene, "--json", "-o", self.folder / "r.h5")
        found = json.loads(done.stdout)
        self.assertEqual(found["warning_kinds"], kinds, found["warnings"])
        self.assertEqual(found["warning_about"], ["motion.friction", "", "", "stresses.x"])
        self.assertEqual([line.removeprefix("warning: ") for line in done.stderr.splitlines()], found["warnings"])
        with h5py.File(self.folder / "r.h5") as h5:
            for name in ("warnings", "warning_kinds", "warning_about"):
                self.assertEqual(h5[name][()].decode().split("\n")[:-1], found[name])
        result = bem_contact.solve(self.scene)
        self.assertEqual((result.warnings, result.warning_kinds), (found["warnings"], kinds))
        self.assertEqual(self.warnings_of_c(), [*found["warnings"], *kinds])

    def of_c(self):
        library = ctypes.CDLL(os.environ["CONFORMAL_LIBRARY"])
        handle, message = ctypes.c_void_p(), ctypes.create_string_buffer(2000)
        self.assertEqual(library.conformal_open_file(str(self.scene).encode(), ctypes.byref(handle), message, 2000), 0, message.value)
        code = library.conformal_solve(handle)
        library.conformal_close(handle)
        return code == 0

    @staticmethod
    def page_says(page):
        data = json.loads(re.search(r'id="data">(.*?)</script>', page.read_text(), re.S)[1])["data"]
        return data["attributes"]["certified"] == 1

    def answers(self):
        """What each door says."""
        file, page, table = (self.folder / name for name in ("r.h5", "r.html", "s.csv"))
        text, printed = self.program("solve", self.scene, "-o", file), self.program("solve", self.scene, "--json")
        found = json.loads(printed.stdout)
        yield "exit code", text.returncode == 0
        yield "text", re.search(r"^certified: (yes|NO)", text.stdout, re.M)[1] == "yes"
        yield "JSON", found["certified"]
        yield "why, JSON", found["why_not_certified"] is None
        yield "history, JSON", all(step["certified"] for step in found["history"])
        with h5py.File(file) as h5:
            yield "HDF5", bool(h5.attrs["certified"])
            yield "picture", Contact(h5).verdict().startswith("certified")
        yield "info", "NOT" not in re.search(r"^  result: .* certified$", self.program("info", file).stdout, re.M)[0]
        self.assertEqual(self.program("report", file, "-o", page).returncode, 0)
        yield "page", self.page_says(page)
        result = bem_contact.solve(self.scene)
        yield "Python", result.certified
        yield "Python, by path", result["certified"]
        yield "why, Python", result.why_not_certified == ""
        yield "repr", "NOT" not in repr(result)
        for path, found in (("quantities/Fx", result.Fx), ("history/0/Fz", result.history["Fz"][0]), ("p_n", result.p_n), ("history/Fz", result.history["Fz"])):
            for _ in range(2):  # the record is kept
                np.testing.assert_array_equal(result[path], found)
        with self.assertRaisesRegex(KeyError, "Did you mean quantities/Fx"):
            result["quantities/Fxx"]
        result.save(self.folder / "python.h5")
        result.report(self.folder / "python.html")
        yield "Python's page", self.page_says(self.folder / "python.html")
        shown = result.plot().axes[0]
        yield "Python's picture", any(text.get_text().startswith("certified") for text in shown.texts)
        with h5py.File(self.folder / "python.h5") as h5:
            yield "Python's file", bool(h5.attrs["certified"])
        (self.folder / "sweep.toml").write_text(self.scene.read_text() + "sweep.motion.xi = [1e-3]\n")
        (self.folder / "s.h5").unlink(missing_ok=True)
        self.program("sweep", self.folder / "sweep.toml", "-o", self.folder / "s.h5", "--csv", table)
        with open(table, newline="") as lines:
            yield "sweep", next(csv.DictReader(lines))["status"] == "certified"
        yield "Python's sweep", bem_contact.sweep(self.folder / "sweep.toml")["status"] == ["certified"]
        yield "C", self.of_c()

    def test_all_say_the_same(self):
        for name, (loads, certified) in STEPS.items():
            (self.folder / "steps.csv").write_text("load\n" + "".join(f"{load}\n" for load in loads))
            self.scene.write_text(SHIFT)
            count = 0
            for door, answer in self.answers():
                with self.subTest(name, door=door):
                    self.assertEqual(answer, certified)
                count += 1
            self.assertEqual(count, 19)


STEADY = """kind = "patch"
wheel.material = { shear_modulus = 800, poisson = 0 }
load.force = 100
motion = { friction = 0.3, xi = 1e-3 }
solver = { max_outer = 1, model = "halfspace" }
grid = { dx = 0.5, ds = 0.5, mx = 16, ms = 16 }
gap = { a = 1e-3, b = 1e-3 }
"""
ON_RAIL = """rail.profile = "60E1"
wheel.profile = "S1002"
wheel.material = { shear_modulus = 8000, poisson = 0 }
position.rail_inclination = 0.025
motion = { friction = 0.3, xi = 2e-3 }
solver = { max_outer = 1, model = "halfspace" }
grid = { dx = 2.0, ds = 2.0 }
"""
AXLE = ON_RAIL.replace(", xi = 2e-3", "") + "wheelset.force = 1.6e5\n"
TABLE = "[table]\nmotion.xi = [1e-3, 2e-3]\n"
SWEEP = "[sweep]\nmotion.xi = [1e-3, 2e-3]\n"
REPLAY = "[replay.columns]\nmotion.xi = \"nu\"\n"

# Every command that solves a contact, with a scene that is no solution: the program ends with 3. {0}: the scene, {1}: a name, {2}: a run, {3}: measured points.
SOLVE = {"solve": (SHIFT, ["{0}"]), "compare": (STEADY, ["{0}", "--models", "halfspace,tangent_plane"]), "sweep": (SHIFT + SWEEP, ["{0}", "-o", "{1}.h5"]),
         "creep-curves": (STEADY, ["{0}", "--xi", "-1e-3:1e-3:3"]), "table": (SHIFT + TABLE, ["{0}", "-o", "{1}.h5"]), "fatigue": (SHIFT, ["{0}"]),
         "shakedown": (SHIFT, ["{0}"]),
         "fit": (STEADY, ["{0}", "--measured", "{3}", "--parameters", "motion.friction"]), "replay": (SHIFT + REPLAY, ["{2}", "{0}", "-o", "{1}.h5"]),
         "wear": (ON_RAIL + "load.force = 8e4\n", ["{0}"]), "wheelset": (AXLE, ["{0}"]), "study": (SHIFT, ["{0}", "-o", "{1}"])}
SHOW = {"info", "report", "plot"}  # files of results: Doors has what each says
ASKED = {"explore": "it serves a page; test_explore and test_answers ask it"}
NO_CONTACT = {"new", "from-contact", "check", "schema", "influence", "profile", "conicity", "stresses", "fmu"}  # they solve none


class EveryDoor(unittest.TestCase):
    """The lists of commands and functions are the program's and the module's own: a new one must be visited here."""

    def setUp(self):
        self.temporary = tempfile.TemporaryDirectory()
        self.folder = Path(self.temporary.name)
        (self.folder / "steps.csv").write_text("load\n" + "0.01\n" * 4 + "-0.01\n")  # the last step is a solution, those before are none
        (self.folder / "run.csv").write_text("nu\n1e-3\n2e-3\n")
        (self.folder / "points.csv").write_text("xi,Fx\n1e-3,10\n2e-3,15\n")

    def tearDown(self):
        self.temporary.cleanup()

    def scene(self, text, name="s.toml"):
        (self.folder / name).write_text(text)
        return self.folder / name

    def program(self, *words):
        return subprocess.run([os.environ["BEM_CONTACT"], *map(str, words)], capture_output=True, text=True)

    def test_every_command(self):
        listed = re.findall(r"^  ([a-z][a-z-]*) ", self.program("--help").stdout.split("Subcommands:")[1], re.M)
        self.assertGreater(len(listed), 15)
        self.assertEqual(set(listed), set(SOLVE) | SHOW | set(ASKED) | NO_CONTACT)
        for command, (text, words) in SOLVE.items():
            with self.subTest(command):
                scene = self.scene(text)
                done = self.program(command, *(word.format(scene, self.folder / f"out_{command}", self.folder / "run.csv", self.folder / "points.csv") for word in words))
                self.assertEqual(done.returncode, 3, done.stdout + done.stderr)

    def of_functions(self):
        """What says whether a function takes the scene for solved."""
        of_history, steady = self.scene(SHIFT), self.scene(STEADY, "steady.toml")
        on_rail, axle = self.scene(ON_RAIL + "load.force = 8e4\n", "rail.toml"), self.scene(AXLE, "axle.toml")
        swept, tabled = self.scene(SHIFT + SWEEP, "swept.toml"), self.scene(SHIFT + TABLE, "tabled.toml")
        worn = self.scene(ON_RAIL + "load.force = 8e4\n" + SWEEP, "worn.toml")
        return {"solve": lambda: bem_contact.solve(of_history).certified,
                "compare": lambda: all(r.certified for r in bem_contact.compare(steady, ["halfspace", "tangent_plane"])["at_equal_forces"].values()),
                "sweep": lambda: "certified" in bem_contact.sweep(swept)["status"],
                "creep_curves": lambda: bem_contact.creep_curves(steady, xi=[-1e-3, 0, 1e-3])["certified"],
                "fit": lambda: bem_contact.fit(steady, self.folder / "points.csv", ["motion.friction"])["certified"],
                "table": lambda: bem_contact.table(tabled) is not None, "fatigue": lambda: bem_contact.fatigue(swept) is not None,
                "shakedown": lambda: bem_contact.shakedown(bem_contact.solve(of_history)) is not None,
                "wear": lambda: bem_contact.wear(worn) is not None, "wheelset": lambda: bem_contact.wheelset(axle)["certified"],
                "study": lambda: bem_contact.study(of_history, self.folder / "studied")["parts"]["solve"]["study_status"] == "certified",
                "fatigue of a result": lambda: bem_contact.fatigue(bem_contact.solve(of_history)) is not None,
                "wear of a result": lambda: bem_contact.wear(bem_contact.solve(on_rail)) is not None,
                "Sequence": lambda: bem_contact.Sequence(of_history).solve().certified}

    def test_every_function(self):
        visits = self.of_functions()
        named = {name for name in dir(bem_contact) if not name.startswith("_") and callable(getattr(bem_contact, name))}
        apart = {"Error", "InputError", "ConvergenceError", "Result", "Sweep", "Table", "Profile", "Sections",  # what functions give and take
                 "check", "conicity", "conicity_map", "profile", "standards", "read_table",  # no contact is solved
                 "plot", "report"}  # files of results: Doors has what each says
        self.assertEqual(named, {name for name in visits if " of " not in name} | apart)
        for name, visit in visits.items():
            with self.subTest(name):
                try:
                    self.assertFalse(visit())
                except bem_contact.ConvergenceError:
                    pass  # the same in one word


if __name__ == "__main__":
    unittest.main()
