"""A study, its parts and the separate commands say the same numbers of one scene."""

import json
import os
import subprocess
import tempfile
import unittest
from pathlib import Path

import h5py

PROGRAM = os.environ["BEM_CONTACT"]
TABLES = '[fatigue]\nyield_shear = 350\n[creep_curves]\nxi = "-1e-3:1e-3:3"\n[wear]\n'
PAIR = 'rail.profile = "{rail}"\nwheel.profile = "{wheel}"\nposition.rail_inclination = 0.025\nmotion.friction = 0.3\ngrid.accuracy = 0.2\n'
AXLES = {  # where the wheelset is displaced, each wheel has a model and elements that a part must not choose again
    "to the right": PAIR.format(rail="60E1", wheel="S1002") + "wheelset.force = 1.6e5\nposition.lateral = 3\n",
    "to the left": PAIR.format(rail="60E1", wheel="S1002") + "wheelset.force = 1.6e5\nposition.lateral = -4\n",
    "at the flange": PAIR.format(rail="60E1", wheel="S1002") + "wheelset = { force = 1.6e5, force_y = 3e4 }\nposition.lateral = 5.5\nposition.yaw = 3e-3\n",
    "half-spaces": PAIR.format(rail="60E1", wheel="S1002") + 'wheelset.force = 1e5\nposition.lateral = 5\nsolver.model = "halfspace"\n',
    "another left rail": PAIR.format(rail="60E1", wheel="S1002") + 'wheelset.force = 1.6e5\nposition.lateral = -3\nleft_rail.profile = "54E1"\n'}
WHEELS = {
    "tread": PAIR.format(rail="60E1", wheel="S1002") + "load.force = 8e4\nmotion.xi = 1e-3\n",
    "gauge corner": PAIR.format(rail="60E1", wheel="S1002") + "load.force = 8e4\nposition.lateral = 5.8\n",
    "lateral force": PAIR.format(rail="60E1", wheel="S1002") + "load = { force = 8e4, force_y = 4e3 }\n",
    "left": PAIR.format(rail="54E1", wheel="S1002") + 'load.force = 6e4\nposition.side = "left"\nposition.lateral = -2\n',
    "tangent planes": PAIR.format(rail="60E1", wheel="S1002") + 'load.force = 8e4\nposition.lateral = 4\nsolver.model = "tangent_plane"\n'}


class OneAnswer(unittest.TestCase):
    def setUp(self):
        self.temporary = tempfile.TemporaryDirectory()
        self.folder = Path(self.temporary.name)
        self.scene = self.folder / "s.toml"

    def tearDown(self):
        self.temporary.cleanup()

    def call(self, *words):
        done = subprocess.run([PROGRAM, *map(str, words)], capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, f"{words}\n{done.stdout}\n{done.stderr}")
        return done.stdout

    def near(self, a, b, what, share=1e-4):
        self.assertAlmostEqual(a / b, 1, delta=share, msg=what)

    def study(self, text):
        self.scene.write_text(text + TABLES)
        said = self.call("study", self.scene, "-o", self.folder / "out")
        with h5py.File(self.folder / "out" / "study.h5") as file:
            parts = {}
            file["parts"].visititems(lambda name, one: parts.__setitem__(name, one[()]) if isinstance(one, h5py.Dataset) else None)
            parts.update({f"{name}.{key}": value.decode() if isinstance(value, bytes) else value for name, group in file["parts"].items() for key, value in group.attrs.items()})
        return said, parts

    def test_of_an_axle(self):
        for name, text in AXLES.items():
            with self.subTest(name):
                said, found = self.study(text)
                both = json.loads(self.call("wheelset", self.scene, "--json"))
                lateral = both["wheelset"]["lateral"]
                side = "left" if lateral < 0 else "right"
                self.assertEqual(found["wheelset/wheelset/lateral"], lateral)
                alone = both[side]
                for number in ("pmax", "T_gamma", "Fy"):
                    self.assertEqual(found[f"wheelset/{side}/track/{number}"], alone["track"][number])
                # what goes on from it has its model, its elements and its place
                model = alone["result"]["model"]
                self.assertIn(f"{side} wheel where wheelset has put it, by {model} on its elements", said)
                self.assertEqual(found["creep_curves.model"], model)
                self.near(max(found["fatigue/patches/pmax"]), alone["track"]["pmax"], "pmax of fatigue")
                self.near(sum(found["fatigue/patches/T_gamma"]), alone["track"]["T_gamma"], "T-gamma of fatigue")
                self.near(found["creep_curves/Fz"], alone["track"]["Fz"], "Fz of the creep curves")
                worn = json.loads(self.call("wear", self.scene, "--json"))
                for wheel in ("right", "left"):
                    self.assertEqual(found[f"wear/{wheel}/T_gamma"], worn[wheel]["T_gamma"])
                    self.near(worn[wheel]["T_gamma"], both[wheel]["track"]["T_gamma"], "T-gamma of wear", 1e-6)

    def test_of_one_wheel(self):
        for name, text in WHEELS.items():
            with self.subTest(name):
                _, found = self.study(text)
                alone = json.loads(self.call("solve", self.scene, "--json"))
                for number in ("pmax", "Fx", "Fy", "T_gamma"):
                    self.assertEqual(found[f"solve/quantities/{number}"], alone["quantities"][number])
                self.near(max(found["fatigue/patches/pmax"]), alone["quantities"]["pmax"], "pmax of fatigue", 1e-6)
                self.near(sum(found["fatigue/patches/T_gamma"]), alone["quantities"]["T_gamma"], "T-gamma of fatigue", 1e-6)
                self.assertEqual(found["creep_curves.model"], alone["model"])
                self.call("creep-curves", self.scene, "-o", self.folder / "c.h5")
                with h5py.File(self.folder / "c.h5") as file:
                    self.assertEqual(found["creep_curves/curves/xi/Fx"].tolist(), file["curves/xi/Fx"][:].tolist())


if __name__ == "__main__":
    unittest.main()
