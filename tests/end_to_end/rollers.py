"""Bodies of revolution on each other: the ring and roller of data/scenes, and roller rigs, whose rollers have their axle below.

A roller below is the roller above, turned by half a turn about x. In the surface's own frame both have the same influence
functions; and if the whole rig is turned, lower and upper body change places, and with s and n reversed xi and Fx change
their signs, while eta, phi, Fs and Mz keep theirs. Coarse influence functions (1 %, 20 stations) in a few seconds.
"""

import re
import subprocess
import tempfile
import unittest
from pathlib import Path

import h5py
import numpy as np
import programs


def coarse(body):
    """The text of data/bodies/<body>.toml for a strip of 8 mm and an error of 1 %."""
    text = (programs.ROOT / f"data/bodies/{body}.toml").read_text()
    return "tolerance = 0.01\n" + text[:text.index("[strip]")] + "[strip]\nfrom = -4\nto = 4\nstation_width = 0.4\n"


def turned(text):
    """The body file of an outline turned by half a turn about x, its axle below."""
    text = re.sub(r"to = \[(.*?), (.*?)\]", lambda m: f"to = [{-float(m[1])!r}, {-float(m[2])!r}]", text)
    return text.replace("reference_radius = ", "reference_radius = -").replace("roller R", "turned R")


def straight_rail(roller_radius=0):
    """The body of data/influence/small_rail.h5, or the roller that has its section."""
    text = (programs.ROOT / "data/bodies/small_rail.toml").read_text()
    return text.replace('profile = "60E1"', f'profile = "60E1"\nroller_radius = {roller_radius}')


class Rollers(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.folder = Path(cls.temporary.name)
        roller = coarse("roller")
        larger = roller.replace("roller R 50 crown 28", "roller R 80 crown 40").replace("reference_radius = 50", "reference_radius = 80")
        larger = larger.replace("radius = 28", "radius = 40").replace("-8.404082058", "-5.358983849")
        for name, text in {"ring": coarse("ring"), "roller": roller, "larger": larger, "below": turned(roller),
                           "bent": straight_rail(2e5), "tight": straight_rail(500)}.items():
            (cls.folder / f"{name}.toml").write_text(text)
            programs.influence(cls.folder / f"{name}.toml", cls.folder / f"{name}.h5")

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    def test_the_scene_gives_what_it_says(self):
        text = (programs.ROOT / "data/scenes/ring_and_roller.toml").read_text().replace("../../demo/", "")
        scene = self.folder / "ring_and_roller.toml"
        scene.write_text(re.sub(r"ms = 50", "ms = 34", text))  # rows on the coarse strips
        for model, force in ("fem", 840), ("halfspace", 909):
            result = programs.solve(scene, "--model", model)
            print(f"{model}: pmax {result['quantities']['pmax']:.1f} MPa, Fx {result['quantities']['Fx']:.1f} N")
            self.assertTrue(result["certified"])
            self.assertAlmostEqual(result["quantities"]["pmax"], 629, delta=0.005 * 629)
            self.assertAlmostEqual(result["quantities"]["Fx"], force, delta=0.01 * force)

    def rig(self, lower, upper, lower_crown, upper_crown, xi):
        scene = self.folder / "rig.toml"
        scene.write_text(f"""kind = "patch"
rail.influence = "{lower}.h5"
wheel.influence = "{upper}.h5"
load.force = 5000
motion.xi = {xi}
motion.eta = 4e-4
motion.phi = 1e-3
motion.friction = 0.3
gap.a = {0.5 / 50 + 0.5 / 80}
grid.mx = 20
grid.ms = 24
grid.dx = 0.2
grid.ds = 0.2
strip.radius = {lower_crown}
strip.upper_radius = {upper_crown}
""")
        return programs.solve(scene, "--model", "fem")

    def test_a_rig_turned_by_half_a_turn_is_the_same(self):
        one, turned = self.rig("larger", "roller", 40, 28, 6e-4), self.rig("roller", "larger", 28, 40, -6e-4)
        for result in one, turned:
            self.assertTrue(result["certified"])
        self.assertAlmostEqual(one["quantities"]["pmax"], turned["quantities"]["pmax"], delta=2e-3 * one["quantities"]["pmax"])
        self.assertAlmostEqual(one["quantities"]["approach"], turned["quantities"]["approach"], delta=2e-3 * one["quantities"]["approach"])
        for key, sign in ("Fx", -1), ("Fs", 1), ("Mz", 1):
            a, b = one["quantities"][key], sign * turned["quantities"][key]
            print(f"{key}: {a:.2f}, turned {b:.2f}")
            self.assertAlmostEqual(a, b, delta=5e-3 * abs(a))
        # What a wrong sign would change: the bodies' numbers differ.
        other = self.rig("larger", "roller", 40, 28, -6e-4)
        self.assertGreater(abs(other["quantities"]["Mz"] / one["quantities"]["Mz"] - 1), 0.02)

    def kernel(self, name):
        with h5py.File(self.folder / f"{name}.h5") as f:
            return f["wavenumber"][:], f["kernel"][:], f.attrs["reference_radius"]

    def test_a_roller_turned_by_half_a_turn_has_the_same_influence_functions(self):
        (k, above, radius), (turned_k, below, turned_radius) = self.kernel("roller"), self.kernel("below")
        self.assertEqual(turned_radius, -radius)
        np.testing.assert_allclose(turned_k, k, rtol=1e-12)
        long = k < 5  # waves of three stations and more, which both meshes of so coarse a body resolve
        difference = np.abs(below - above)[long] / np.abs(above[long]).max(axis=1, keepdims=True)
        print("largest difference of the kernels", difference.max())
        self.assertLess(difference.max(), 1e-3)

    def test_two_equal_rollers_roll_freely(self):
        place = 'place = "absolute", y = 700, z = 0'
        scene = self.folder / "equal.toml"

        scene.write_text(f"""rail = {{ profile = "below.toml", influence = "below.h5", roller_radius = 50, {place} }}
wheel = {{ profile = "roller.toml", influence = "roller.h5", {place} }}
position.wheel_radius = 50
load.force = 3000
grid = {{ dx = 0.25, ds = 0.4 }}
motion.friction = 0.3
""")
        # Each surface is pressed towards its axle and so is slower; where both are equal, neither drives the other, and
        # the creepage of free rolling is that of the half-space, which knows no radial displacement.
        fem, half = (programs.solve(scene, "--model", model)["quantities"] for model in ("fem", "halfspace"))
        print(f"free rolling at xi = {fem['free_rolling_xi']:.4e}, half-space {half['free_rolling_xi']:.4e}")
        self.assertAlmostEqual(fem["free_rolling_xi"], half["free_rolling_xi"], delta=2e-6)
        self.assertAlmostEqual(fem["pmax"], half["pmax"], delta=5e-3 * half["pmax"])

    def flange_root(self, rail, more=""):
        """data/scenes/conformal_small.toml with another rail."""
        text = (programs.ROOT / "data/scenes/conformal_small.toml").read_text()
        text = text.replace("../influence/small_rail.h5", str(rail))
        text = text.replace("../influence", str(programs.ROOT / "data/influence"))
        scene = self.folder / "flange_root.toml"
        scene.write_text(text.replace('profile = "60E1"', f'profile = "60E1"\n{more}'))
        return scene

    def test_a_large_roller_is_the_rail(self):
        straight = programs.solve(self.flange_root(programs.ROOT / "data/influence/small_rail.h5"), "--model", "fem")
        bent = programs.solve(self.flange_root("bent.h5", "roller_radius = 2e5"), "--model", "fem")
        mirrored = self.flange_root("bent.h5", "roller_radius = 2e5")
        mirrored.write_text(mirrored.read_text().replace("lateral = 6.6", 'lateral = -6.6\nside = "left"'))
        left = programs.solve(mirrored, "--model", "fem")
        tight = programs.solve(self.flange_root("tight.h5", "roller_radius = 500"), "--model", "fem")
        for result in straight, bent, left, tight:
            self.assertTrue(result["certified"])
        for key in "pmax", "Fx", "Fy", "Mz":
            values = [r["quantities"][key] for r in (straight, bent, left, tight)]
            print(key, *(f"{v:.4g}" for v in values))
            self.assertAlmostEqual(values[1], values[0], delta=0.003 * abs(values[0]))
        self.assertAlmostEqual(left["quantities"]["pmax"], bent["quantities"]["pmax"], delta=1e-6 * bent["quantities"]["pmax"])
        self.assertAlmostEqual(left["quantities"]["Fx"], bent["quantities"]["Fx"], delta=1e-5 * abs(bent["quantities"]["Fx"]))
        # A small roller is more curved: the contact is shorter and the pressure higher.
        self.assertGreater(tight["quantities"]["pmax"], 1.1 * straight["quantities"]["pmax"])

    def test_the_files_of_another_roller_are_refused(self):
        def refusal(scene):
            done = subprocess.run([programs.BIN / "bem_contact", "solve", scene, "--model", "fem"], text=True, capture_output=True)
            self.assertEqual(done.returncode, 2, done.stderr)
            return done.stderr
        other = refusal(self.flange_root("bent.h5", "roller_radius = 500"))
        self.assertIn("200000 mm below", other)
        self.assertIn("500 mm below", other)
        self.assertIn("a straight rail", refusal(self.flange_root("bent.h5")))
        small = programs.ROOT / "data/influence/small_rail.h5"
        self.assertIn("they are for a straight rail", refusal(self.flange_root(small, "roller_radius = 500")))
        (self.folder / "as_profile.toml").write_text(straight_rail(500))
        named = self.flange_root("tight.h5")
        named.write_text(named.read_text().replace('profile = "60E1"', 'profile = "as_profile.toml"'))
        self.assertIn("Give rail.roller_radius = 500", refusal(named))


if __name__ == "__main__":
    unittest.main()
