"""Bodies of revolution on each other: the ring and roller of data/scenes, and a roller rig, whose roller has its axle below.

A file serves a roller above the contact. That it serves one below as well, turned by half a turn about x, is shown by
turning the whole rig: lower and upper body change places, and with s and n reversed xi and Fx change their signs, while
eta, phi, Fs and Mz keep theirs. Coarse influence functions (1 %, 20 stations) in a few seconds.
"""

import re
import tempfile
import unittest
from pathlib import Path

import programs


def coarse(body):
    """The text of data/bodies/<body>.toml for a strip of 8 mm and an error of 1 %."""
    text = (programs.ROOT / f"data/bodies/{body}.toml").read_text()
    return "tolerance = 0.01\n" + text[:text.index("[strip]")] + "[strip]\nfrom = -4\nto = 4\nstation_width = 0.4\n"


class Rollers(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.folder = Path(cls.temporary.name)
        roller = coarse("roller")
        larger = roller.replace("roller R 50 crown 28", "roller R 80 crown 40").replace("reference_radius = 50", "reference_radius = 80")
        larger = larger.replace("radius = 28", "radius = 40").replace("-8.404082058", "-5.358983849")
        for name, text in {"ring": coarse("ring"), "roller": roller, "larger": larger}.items():
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


if __name__ == "__main__":
    unittest.main()
