"""A 3-D mesh of a block through solid3d: its numbers are those of the harmonic method, its contact is Hertz's."""

import math
import re
import subprocess
import tempfile
import unittest
from pathlib import Path

import programs

RADIUS, FORCE = 100.0, 2600.0
BODY = """
[body]
kind = "block"
size = 40
[strip]
from = -3
to = 3
station_width = 0.5
[harmonic]
half_period = 120
shortest_dx = 0.5
[solid]
offsets = 13
elements_per_load = 6
grading = 0.5
loads_at_once = 12
"""
SCENE = f"""
kind = "patch"
[rail]
influence = "solid.h5"
structural = "included"
[wheel]
influence = "solid.h5"
structural = "included"
[load]
force = {FORCE}
[motion]
frictionless = true
[gap]
a = {1 / (2 * RADIUS)}
b = {1 / (2 * RADIUS)}
[grid]
dx = 0.5
ds = 0.5
mx = 8
ms = 8
[solver]
model = "fem"
"""


def run(program, *arguments):
    return subprocess.run([programs.BIN / program, *arguments], check=True, stdout=subprocess.PIPE, text=True).stdout


class OwnMesh(unittest.TestCase):
    def test_numbers_and_contact(self):
        with tempfile.TemporaryDirectory() as name:
            folder = Path(name)
            body = folder / "block.toml"
            body.write_text(BODY)
            run("mesh_body", body, "-o", folder / "section.msh")
            run("fem_influence", body, folder / "section.msh", "-o", folder / "harmonic.h5")
            run("mesh_body", body, "--solid", "-o", folder / "solid.msh")
            check = run("fem_influence", body, folder / "solid.msh", "--solid", "-o", folder / "solid.h5",
                        "--check", folder / "harmonic.h5")
            info = run("bem_contact", "info", folder / "solid.h5")
            scene = folder / "hertz.toml"
            scene.write_text(SCENE)
            fem = programs.solve(scene)
            halfspace = programs.solve(scene, "--model", "halfspace")
            scene.write_text(SCENE.replace("dx = 0.5", "dx = 0.4"))
            refused = subprocess.run([programs.BIN / "bem_contact", "solve", scene], stderr=subprocess.PIPE, text=True)
        print(check)
        bands = re.findall(r"^(?:loaded element|to \S+ mm)\s+\d+\s+(\S+)\s+(\S+)", check.split("removed:")[1], flags=re.M)
        self.assertGreaterEqual(len(bands), 3)
        self.assertLess(max(float(b[0]) for b in bands), 0.4)  # % of self: six elements a side
        self.assertLess(max(float(b[1]) for b in bands), 1.0)  # % of local
        self.assertIn("table of 13 influence numbers along x, elements of 0.5 mm", info)
        contact_modulus = 2 * 82000 * 1.28 / (2 * (1 - 0.28**2))
        a = (0.75 * FORCE * RADIUS / contact_modulus) ** (1 / 3)
        pmax = 1.5 * FORCE / (math.pi * a**2)
        print(f"pmax: Hertz {pmax:.1f}, own mesh {fem['quantities']['pmax']:.1f}, half-space {halfspace['quantities']['pmax']:.1f} MPa")
        self.assertTrue(fem["certified"])
        self.assertAlmostEqual(fem["quantities"]["pmax"], halfspace["quantities"]["pmax"], delta=0.005 * pmax)
        self.assertAlmostEqual(fem["quantities"]["pmax"], pmax, delta=0.05 * pmax)
        self.assertEqual(refused.returncode, 2)
        self.assertIn("Use that length or a whole multiple of it", refused.stderr)


if __name__ == "__main__":
    unittest.main()
