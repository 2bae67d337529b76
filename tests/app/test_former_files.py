"""Files of versions before 0.2 are still read: by info, report, plot and solve, which repeats them.

Here a file of today is written again in the former layout: fields in a group named as the model, numbers of the certificate and
the size of an element as attributes, digests of curves beside the inputs.
"""

import json
import os
import re
import subprocess
import tempfile
import unittest
from pathlib import Path

import h5py

import bem_contact

COORDINATES = ("x", "s", "y", "z", "delta", "wheel_s", "gap", "rail_profile", "wheel_profile")
SCENE_OF_FILE = ("scene_text", "scene_with_defaults", "inputs", "materials")


def text(value):
    return value.decode() if isinstance(value, bytes) else str(value)


def copy_coordinates(result, to):
    for name in COORDINATES:
        if name in result:
            result.copy(name, to)
    to.attrs.update({"frame": text(result.attrs["frame"]), "friction": result["friction"][()],
                     "dx_mm": result["quantities/dx"][()], "ds_mm": result["quantities/ds"][()]})


def copy_result(result, to):
    """What was in the group of a model: fields, numbers, and attributes under their former names."""
    for name, item in result.items():
        if name not in COORDINATES + SCENE_OF_FILE and (name in ("patches", "quantities", "warnings") or len(getattr(item, "shape", ())) == 2):
            result.copy(item, to, name)
    worst, tolerance = result["quantities/certificate"][()], result["certificate/tolerance"][()]
    to.attrs.update({"model": text(result.attrs["model"]), "reason": text(result.attrs["why_this_model"]), "certificate_worst": worst,
                     "certificate_tolerance": tolerance, "certificate_holds": float(result.attrs["certified"]),
                     "normal_solver": text(result["solver"].attrs["normal"]), "tangential_solver": text(result["solver"].attrs["tangential"]),
                     "remark": "", "seconds": 0.1, "approach_datum": text(result.attrs["approach_datum"]), "converges_with_elements": 1.0})


def copy_scene(today, former, kind):
    for name in SCENE_OF_FILE:
        if name in today:
            today.copy(name, former)
    for name in ("program", "commit", "scene_folder"):
        former.attrs[name] = text(today.attrs[name])
    former.attrs["format"] = f"bem_contact {kind} 2"
    for body in ("rail", "wheel"):
        former[f"inputs/{body}.profile"].attrs["geometry"] = text(today["geometry"].attrs[body])


def former_result(file, output):
    with h5py.File(file) as today, h5py.File(output, "w") as former:
        copy_scene(today, former, "result")
        copy_coordinates(today, former)
        copy_result(today, former.create_group(text(today.attrs["model"])))


def former_comparison(file, output):
    with h5py.File(file) as today, h5py.File(output, "w") as former:
        copy_scene(today, former, "comparison")
        for name in ("equal_forces", "equal_position"):
            for model, result in today[f"at_{name}"].items():
                if isinstance(result, h5py.Group) and "p_n" in result:
                    group = former.create_group(f"{name}/{model}")
                    copy_coordinates(result, group)
                    copy_result(result, group)


class FormerFiles(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.folder = Path(cls.temporary.name)
        cls.scene = cls.folder / "s.toml"
        cls.scene.write_text('rail.profile = "60E1"\nwheel.profile = "S1002"\nload.force = 8e4\nmotion = { friction = 0.3, xi = 1e-3 }\n'
                             'grid = { dx = 1, ds = 0.5 }\nsolver.model = "halfspace"\n')
        cls.today, cls.former = cls.folder / "today.h5", cls.folder / "former.h5"
        cls.program("solve", cls.scene, "-o", cls.today)
        former_result(cls.today, cls.former)

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    @classmethod
    def program(cls, *words):
        done = subprocess.run([os.environ["BEM_CONTACT"], *map(str, words)], capture_output=True, text=True, cwd=cls.folder)
        if done.returncode != 0:
            raise AssertionError(f"{words}: {done.returncode}\n{done.stdout}{done.stderr}")
        return done.stdout

    def test_info_says_the_same(self):
        lines = [re.search(r"^  result: .*", self.program("info", file), re.M) for file in (self.today, self.former)]
        self.assertTrue(all(lines), self.program("info", self.former))
        self.assertEqual(lines[0][0], lines[1][0])
        self.assertIn("certified", lines[0][0])
        self.assertEqual(self.program("info", "--scene", self.former), self.program("info", "--scene", self.today))

    def test_it_is_repeated(self):
        self.assertIn("the same: every total", self.program("solve", self.former))
        with h5py.File(self.folder / "other.h5", "w") as other, h5py.File(self.former) as former:
            for name in former:
                former.copy(name, other)
            other.attrs.update(former.attrs)
            other["halfspace/quantities/Fx"][()] *= 1.01
            other["inputs/rail.profile"].attrs["geometry"] = "0123456789abcdef"
        done = subprocess.run([os.environ["BEM_CONTACT"], "solve", self.folder / "other.h5"], capture_output=True, text=True)
        self.assertEqual(done.returncode, 3)
        self.assertRegex(done.stdout, r"(?m)^Fx ")
        self.assertIn("0123456789abcdef", done.stdout)

    def pictures(self, name):
        """All words of the picture of each file."""
        for file in (self.folder / f"{name}.h5", self.folder / f"former_{name}.h5"):
            self.program("plot", file, "-o", file.with_suffix(".svg"))
            yield re.findall(r"<!-- (.*?) -->", file.with_suffix(".svg").read_text())

    def test_the_picture_is_the_same(self):
        for source, name in ((self.today, "r.h5"), (self.former, "former_r.h5")):
            (self.folder / name).write_bytes(source.read_bytes())
        today, former = self.pictures("r")
        self.assertGreater(len(today), 40)
        self.assertEqual(former, today)

    def test_the_picture_of_a_comparison_is_the_same(self):
        self.program("compare", self.scene, "--models", "halfspace", "tangent_plane", "-o", "c.h5")
        former_comparison(self.folder / "c.h5", self.folder / "former_c.h5")
        today, former = self.pictures("c")
        self.assertGreater(len(today), 60)
        self.assertEqual(former, today)

    def test_the_page_has_its_numbers(self):
        """The page's scripts know today's layout alone."""
        pages = []
        for file in (self.today, self.former):
            self.program("report", file, "-o", file.with_suffix(".html"))
            pages.append(json.loads(re.search(r'id="data">(.*?)</script>', file.with_suffix(".html").read_text(), re.S)[1])["data"])
        for path in ("quantities/Fx", "quantities/dx", "quantities/certificate", "certificate/tolerance", "friction", "x", "rail_profile", "p_n",
                     "attributes/certified", "attributes/why_this_model", "attributes/frame", "solver/attributes/normal", "patches/Fn",
                     "inputs/wheel.profile/attributes/name"):  # "a wheel with the profile S1002"
            found = pages
            for name in path.split("/"):
                found = [page[name] for page in found]
            self.assertEqual(*[one["values"] if isinstance(one, dict) else one for one in found], path)

    def test_python_draws_it(self):
        self.assertEqual(len(bem_contact.plot(self.former).axes), len(bem_contact.plot(self.today).axes))


if __name__ == "__main__":
    unittest.main()
