"""data/TUTORIAL.md: its files, taken from the page, give the numbers that the page prints."""

import json
import os
import re
import subprocess
import tempfile
import unittest
from pathlib import Path

import programs

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

    def test_accuracy(self):
        result = self.solved(self.scene + self.grid, "--model", "fem")
        contact, pmax, fy = self.printed(r"\| 0\.01 \|.*?\| (\d+) \| (\S+) \+- \S+ \| (\d+) \|")
        self.near(result["quantities"]["pmax"], pmax)
        self.near(result["quantities"]["Fy"], fy)
        self.near(sum(patch["contact"] for patch in result["patches"]), contact, 0.02)

    def test_sweep(self):
        text = re.sub(r"\[position\]\n.*?\n\n", "", self.scene + self.grid, flags=re.S) + self.sweep
        (self.folder / "sweep.toml").write_text(text)
        done = subprocess.run([programs.BIN / "bem_contact", "sweep", "sweep.toml", "--model", "halfspace", "-o", "S.h5"],
                              cwd=self.folder, check=True, stdout=subprocess.PIPE, text=True)
        self.assertIn("9 certified, of 9 cases", done.stdout)

    def test_equal_forces_in_python(self):
        code = re.search(r"```python\n(.*?)```", self.page, re.S)[1]
        done = subprocess.run(["/usr/bin/python3", "-c", code], cwd=self.folder, check=True, stdout=subprocess.PIPE, text=True,
                              env=os.environ | {"PYTHONPATH": str(programs.BIN.parent / "python")})
        pattern = r"pmax: (\d+) MPa \(FEM\), (\d+) MPa \(half-space\)"
        for value, printed in zip(re.search(pattern, done.stdout).groups(), self.printed(pattern)):
            self.near(float(value), printed)


if __name__ == "__main__":
    unittest.main()
