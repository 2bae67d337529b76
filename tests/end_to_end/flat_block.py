"""A sphere on a flat block: with the block's influence functions the result is Hertz's within 1 %."""

import math
import tempfile
import unittest
from pathlib import Path

import programs

RADIUS, FORCE = 400.0, 20000.0
SCENE = f"""
kind = "patch"
[rail]
influence = "block.h5"
[wheel]
influence = "block.h5"
[load]
force = {FORCE}
[motion]
frictionless = true
[gap]
a = {1 / (2 * RADIUS)}
b = {1 / (2 * RADIUS)}
[grid]
dx = 0.25
ds = 0.25
mx = 40
ms = 40
[solver]
model = "fem"
"""


class FlatBlock(unittest.TestCase):
    def test_hertz(self):
        with tempfile.TemporaryDirectory() as name:
            folder = Path(name)
            programs.influence("flat_block", folder / "block.h5")
            (folder / "hertz.toml").write_text(SCENE)
            fem = programs.solve(folder / "hertz.toml")
            halfspace = programs.solve(folder / "hertz.toml", "--model", "halfspace")
        young, poisson = 2 * 82000 * 1.28, 0.28
        contact_modulus = young / (2 * (1 - poisson**2))
        a = (0.75 * FORCE * RADIUS / contact_modulus) ** (1 / 3)
        pmax = 1.5 * FORCE / (math.pi * a**2)
        print(f"pmax: Hertz {pmax:.1f}, flat block {fem['quantities']['pmax']:.1f}, half-space {halfspace['quantities']['pmax']:.1f} MPa; "
              f"a = {a:.2f} mm, area {math.pi * a * a:.2f}, {fem['quantities']['area']:.2f}, {halfspace['quantities']['area']:.2f} mm2")
        self.assertTrue(fem["certified"])
        self.assertAlmostEqual(fem["quantities"]["pmax"], pmax, delta=0.01 * pmax)
        self.assertAlmostEqual(fem["quantities"]["pmax"], halfspace["quantities"]["pmax"], delta=0.005 * pmax)
        self.assertAlmostEqual(fem["quantities"]["area"], math.pi * a * a, delta=0.03 * math.pi * a * a)


if __name__ == "__main__":
    unittest.main()
