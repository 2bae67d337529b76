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
from bem_contact.plotting.former import results_in

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


class Doors(unittest.TestCase):
    def setUp(self):
        self.temporary = tempfile.TemporaryDirectory()
        self.folder = Path(self.temporary.name)
        self.scene = self.folder / "s.toml"

    def tearDown(self):
        self.temporary.cleanup()

    def program(self, *arguments):
        return subprocess.run([os.environ["BEM_CONTACT"], *map(str, arguments)], capture_output=True, text=True)

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
            contact, = (Contact(model, *parts) for model, parts in results_in(h5).items())
            yield "picture", contact.verdict().startswith("certified")
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


if __name__ == "__main__":
    unittest.main()
