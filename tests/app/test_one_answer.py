"""A study, its parts and the separate commands say the same numbers of one scene."""

import csv
import json
import os
import subprocess
import tempfile
import unittest
from pathlib import Path

import h5py
import numpy as np

PROGRAM = os.environ["BEM_CONTACT"]
TABLES = '[fatigue]\nyield_shear = 350\n[creep_curves]\nxi = "-1e-3:1e-3:3"\n[wear]\n'
PAIR = 'rail.profile = "{rail}"\nwheel.profile = "{wheel}"\nposition.rail_inclination = 0.025\nmotion.friction = 0.3\ngrid.accuracy = 0.2\n'
LIMIT = 1100  # MPa, of "steel flows"
AXLES = {  # where the wheelset is displaced, each wheel has a model and elements that a part must not choose again
    "to the right": PAIR.format(rail="60E1", wheel="S1002") + "wheelset.force = 1.6e5\nposition.lateral = 3\n",
    "to the left": PAIR.format(rail="60E1", wheel="S1002") + "wheelset.force = 1.6e5\nposition.lateral = -4\n",
    "at the flange": PAIR.format(rail="60E1", wheel="S1002") + "wheelset = { force = 1.6e5, force_y = 3e4 }\nposition.lateral = 5.5\nposition.yaw = 3e-3\n",
    "half-spaces": PAIR.format(rail="60E1", wheel="S1002") + 'wheelset.force = 1e5\nposition.lateral = 5\nsolver.model = "halfspace"\n',
    "steel flows": PAIR.format(rail="60E1", wheel="S1002") + f"wheelset.force = 1.6e5\nposition.lateral = 5.8\nwheel.material.limit_pressure = {LIMIT}\n",
    "another left rail": PAIR.format(rail="60E1", wheel="S1002") + 'wheelset.force = 1.6e5\nposition.lateral = -3\nleft_rail.profile = "54E1"\n'}
WHEELS = {
    "tread": PAIR.format(rail="60E1", wheel="S1002") + "load.force = 8e4\nmotion.xi = 1e-3\n",
    "gauge corner": PAIR.format(rail="60E1", wheel="S1002") + "load.force = 8e4\nposition.lateral = 5.8\n",
    "lateral force": PAIR.format(rail="60E1", wheel="S1002") + "load = { force = 8e4, force_y = 4e3 }\n",
    "left": PAIR.format(rail="54E1", wheel="S1002") + 'load.force = 6e4\nposition.side = "left"\nposition.lateral = -2\n',
    "steel flows": PAIR.format(rail="60E1", wheel="S1002") + f"load.force = 8e4\nposition.lateral = 5.8\nrail.material.limit_pressure = {LIMIT}\n",
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
                self.near(sum(found["fatigue/patches/T_gamma"]), alone["track"]["T_gamma"], "T-gamma of fatigue", 1e-3)
                self.near(found["creep_curves/Fz"], alone["track"]["Fz"], "Fz of the creep curves")
                if name == "steel flows":
                    self.near(alone["track"]["pmax"], LIMIT, "limit of the pressure", 1e-6)
                worn = json.loads(self.call("wear", self.scene, "--json"))
                for wheel in ("right", "left"):
                    self.assertEqual(found[f"wear/{wheel}/T_gamma"], worn[wheel]["T_gamma"])
                    self.near(worn[wheel]["T_gamma"], both[wheel]["track"]["T_gamma"], "T-gamma of wear", 1e-6)

    def test_of_one_wheel(self):
        for name, text in WHEELS.items():
            with self.subTest(name):
                _, found = self.study(text)
                alone = json.loads(self.call("solve", self.scene, "--json"))
                if name == "steel flows":
                    self.near(alone["quantities"]["pmax"], LIMIT, "limit of the pressure", 1e-6)
                for number in ("pmax", "Fx", "Fy", "T_gamma"):
                    self.assertEqual(found[f"solve/quantities/{number}"], alone["quantities"][number])
                self.near(max(found["fatigue/patches/pmax"]), alone["quantities"]["pmax"], "pmax of fatigue", 1e-6)
                self.near(sum(found["fatigue/patches/T_gamma"]), alone["quantities"]["T_gamma"], "T-gamma of fatigue", 1e-6)
                self.assertEqual(found["creep_curves.model"], alone["model"])
                self.call("creep-curves", self.scene, "-o", self.folder / "c.h5")
                with h5py.File(self.folder / "c.h5") as file:
                    self.assertEqual(found["creep_curves/curves/xi/Fx"].tolist(), file["curves/xi/Fx"][:].tolist())

    def test_of_other_states_of_the_surfaces(self):
        """Each number of a state is that of the scene with this layer.state."""
        states = ["clean", "rig", "MoS2"]
        text = WHEELS["tread"]
        self.scene.write_text(text + '[wear]\n[uncertainty]\nstates = "clean, rig, MoS2"\nparts = "solve"\n')
        self.assertEqual(self.call("study", self.scene, "--list", "-o", self.folder / "out").split(),
                         ["solve", "wear", *(f"states/{state}" for state in states)])
        said = self.call("study", self.scene, "-o", self.folder / "out")
        self.assertIn("by state", said)
        with h5py.File(self.folder / "out" / "study.h5") as file:
            names, parts, found = (file[name][()].decode().split("\n") for name in ("headline_names", "headline_parts", "states"))
            values, given = file["headline_states"][:], file["headline/value"][:]
        self.assertEqual(found[:3], states)
        with open(self.folder / "out" / "states.csv", newline="") as lines:
            table = list(csv.DictReader(lines))
        for k, state in enumerate(states):
            self.scene.write_text(text + f'layer.state = "{state}"\n')
            alone = json.loads(self.call("solve", self.scene, "--json"))["quantities"]
            for row, (part, name, value) in enumerate(zip(parts, names, given)):
                if part == "solve":
                    found = values[row, k]
                    for other in (alone[name.split("/")[-1]], float(table[row][state]), *([value] if state == "clean" else [])):
                        self.assertAlmostEqual(found, other, delta=1e-6 * abs(found), msg=(state, name))  # clean: without a layer
                elif part == "wear":
                    self.assertTrue(np.isnan(values[row, k]) and table[row][state] == "", name)
        force = values[names.index("quantities/Fx")]
        self.assertTrue(force[0] > 1.1 * force[1] > 1.5 * force[2], force)
        self.assertIn('"states"', (self.folder / "out" / "study.html").read_text())
        for wrong, word in (("clean, mud", "'mud' is unknown; known are none, clean, rig, locomotive"), ("rig, rig", "'rig' is named twice")):
            self.scene.write_text(text + f'[uncertainty]\nstates = "{wrong}"\n')
            done = subprocess.run([PROGRAM, "study", self.scene, "-o", self.folder / "wrong"], capture_output=True, text=True)
            self.assertEqual(done.returncode, 2)
            self.assertIn(word, done.stderr)


if __name__ == "__main__":
    unittest.main()
