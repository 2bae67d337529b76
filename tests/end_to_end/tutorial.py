"""data/TUTORIAL.md: its files, taken from the page, give the numbers that the page prints."""

import json
import os
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import numpy

import programs

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
import page_tables

PAGE = programs.ROOT / "data" / "TUTORIAL.md"


class Tutorial(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.folder = Path(cls.temporary.name)
        cls.page = PAGE.read_text()
        profile = str(programs.ROOT / "data" / "bodies" / "hollow_wheel.txt")
        blocks = re.findall(r"```toml\n(.*?)```", cls.page.replace("../../data/bodies/hollow_wheel.txt", profile), re.S)
        cls.plain, rail, wheel, cls.grid, cls.sweep = blocks
        for name, text in (("rail", rail), ("wheel", wheel)):
            (cls.folder / f"{name}.toml").write_text(text)
            programs.influence(cls.folder / f"{name}.toml", cls.folder / f"{name}.h5")
        cls.scene = cls.plain
        for name in ("rail", "wheel"):
            cls.scene = cls.scene.replace(f"[{name}]\n", f'[{name}]\ninfluence = "{name}.h5"\n')
        (cls.folder / "scene.toml").write_text(cls.scene)

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    def printed(self, pattern):
        """The numbers of the page where the pattern has groups."""
        found = re.search(pattern, self.page)
        self.assertIsNotNone(found, f"the page has no line like {pattern}")
        return [float(number) for number in found.groups()]

    def near(self, value, printed, share=1e-3):
        self.assertAlmostEqual(value, printed, delta=share * abs(printed))

    def solved(self, text, *options):
        file = self.folder / "one.toml"
        file.write_text(text)
        return programs.solve(file, *options)

    def test_half_space(self):
        result = self.solved(self.plain, "--model", "halfspace")
        fx, fy = self.printed(r"on the rail: Fx (\S+) \+- \S+ N, Fy (\S+) \+- \S+ N, Fz 80000.0 N")
        self.near(result["quantities"]["Fx"], fx)
        self.near(result["quantities"]["Fy"], fy)

    def test_comparison(self):
        done = subprocess.run([programs.BIN / "bem_contact", "compare", "scene.toml", "--json"], cwd=self.folder, check=True,
                              stdout=subprocess.PIPE, text=True)
        found = json.loads(done.stdout)
        before, position = self.page.split("    At equal position,")
        forces = before.rsplit("    At equal forces", 1)[1]
        for part, key in ((forces, "at_equal_forces"), (position, "at_equal_position")):
            for model, column in (("halfspace", 1), ("fem", 2)):
                pmax = re.search(r"    pmax +MPa +(\S+) +(\S+)", part)
                self.near(found[key][model]["quantities"]["pmax"], float(pmax[column]))
        lateral = re.search(r"    lateral +mm +(\S+)", forces)
        self.assertAlmostEqual(found["at_equal_forces"]["halfspace"]["quantities"]["lateral"], float(lateral[1]), delta=2e-4)
        for model, column in (("halfspace", 1), ("fem", 2)):
            creep = re.search(r"    \+1\.0e-03 +N +(\S+) +(\S+)", self.page)
            self.near(found["creep_forces"]["Fx"][model][1], float(creep[column]), 2e-3)

    def noisy(self, scatter, seed):
        """The scene of step 2 with a wheel whose points scatter (um)."""
        points = numpy.loadtxt(programs.ROOT / "data" / "bodies" / "hollow_wheel.txt")
        points += numpy.random.default_rng(seed).normal(scale=1e-3 * scatter, size=points.shape) if scatter else 0
        numpy.savetxt(self.folder / "noisy.txt", points, "%.7f")
        return self.plain.replace(str(programs.ROOT / "data" / "bodies" / "hollow_wheel.txt"), "noisy.txt")

    def write_noise(self):
        with open(self.folder / "noise.csv", "w") as out:
            print("scatter,pmax_from,pmax_to,patches_from,patches_to", file=out)
            for scatter in (0, 0.5, 2, 10):
                found = [self.solved(self.noisy(scatter, seed), "--model", "halfspace") for seed in range(1, 7 if scatter else 2)]
                pmax, patches = [one["quantities"]["pmax"] for one in found], [len(one["patches"]) for one in found]
                print(scatter, min(pmax), max(pmax), min(patches), max(patches), sep=",", file=out)

    def write_accuracy(self):
        with open(self.folder / "accuracy.csv", "w") as out:
            print("accuracy,dx,ds,contact,pmax,Fy,estimate", file=out)
            for accuracy in (0.05, 0.02, 0.01):
                found = self.solved(self.scene + self.grid.replace("0.01 ", f"{accuracy} "), "--model", "fem")["quantities"]
                print(accuracy, *(found[name] for name in ("dx", "ds", "contact", "pmax", "Fy")), 100 * found["discretisation"],
                      sep=",", file=out)

    def write_sweeps(self):
        text = re.sub(r"\[position\]\n.*?\n\n", "", self.scene + self.grid, flags=re.S) + self.sweep
        (self.folder / "sweep.toml").write_text(text)
        for model in ("fem", "halfspace"):
            done = subprocess.run([programs.BIN / "bem_contact", "sweep", "sweep.toml", "--model", model, "-o", f"{model}.h5",
                                   "--csv", f"{model}.csv"], cwd=self.folder, check=True, stdout=subprocess.PIPE, text=True)
            self.assertIn("9 of 9 cases are certified", done.stdout)

    def test_every_table(self):
        self.write_noise()
        self.write_accuracy()
        self.write_sweeps()
        self.assertEqual(page_tables.faults_of(self.page, self.folder), [])

    def test_equal_forces_in_python(self):
        code = re.search(r"```python\n(.*?)```", self.page, re.S)[1]
        done = subprocess.run(["/usr/bin/python3", "-c", code], cwd=self.folder, check=True, stdout=subprocess.PIPE, text=True,
                              env=os.environ | {"PYTHONPATH": str(programs.BIN.parent / "python")})
        pattern = r"pmax: (\d+) MPa \(FEM\), (\d+) MPa \(half-space\)"
        for value, printed in zip(re.search(pattern, done.stdout).groups(), self.printed(pattern)):
            self.near(float(value), printed)


if __name__ == "__main__":
    unittest.main()
