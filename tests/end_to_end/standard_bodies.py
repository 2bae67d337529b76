"""Bodies of standards by their names alone: `bem_contact profile NAME --body`, and `tools/influence NAME`."""

import os
import re
import subprocess
import tempfile
import unittest
from pathlib import Path

import programs

USUAL_QUALITY = 0.3  # smallest scaled Jacobian of the bodies in data/bodies: 0.5 and more
# A program in the place of bem_contact: the same, but for stations that are five times as wide, so that influence functions take seconds.
COARSE = """#!/bin/sh
"{program}" "$@" || exit
while [ $# -gt 1 ]; do
  [ "$1" = --body ] && sed -i 's/^station_width = .*/station_width = 1/; 1i tolerance = 0.05' "$2" && printf '[harmonic]\\nshortest_dx = 1\\n' >> "$2"
  shift
done
exit 0
"""
SCENE = """rail = {{ profile = "56E1", influence = "{file}" }}
wheel.profile = "S1002"
position = {{ lateral = 6, rail_inclination = 0.025 }}
load.force = 5e4
motion.friction = 0.3
"""


def run(*words, **more):
    return subprocess.run(list(map(str, words)), capture_output=True, text=True, **more)


class StandardBodies(unittest.TestCase):
    def setUp(self):
        self.temporary = tempfile.TemporaryDirectory()
        self.folder = Path(self.temporary.name)

    def tearDown(self):
        self.temporary.cleanup()

    def test_each_kind_of_body_meshes_well(self):
        for name in ("56E1", "27E1", "60E2", "S1002", "S1002 h32 e28.5 15%", "1:40", "LMA"):
            body = self.folder / "body.toml"
            self.assertEqual(run(programs.BIN / "bem_contact", "profile", name, "--body", body).returncode, 0, name)
            done = run(programs.BIN / "mesh_body", body, "-o", self.folder / "body.msh", "--quality")
            self.assertEqual(done.returncode, 0, (name, done.stderr))
            quality = float(re.search(r"smallest scaled Jacobian (\d\.\d+)", done.stdout + done.stderr)[1])
            self.assertGreater(quality, USUAL_QUALITY, name)
            body.unlink()
        head = run(programs.BIN / "bem_contact", "profile", "60N", "--body", self.folder / "body.toml")
        self.assertEqual(head.returncode, 2)
        self.assertFalse((self.folder / "body.toml").exists())

    def test_influence_functions_by_name(self):
        bin = self.folder / "bin"
        bin.mkdir()
        for program in ("mesh_body", "fem_influence"):
            (bin / program).symlink_to(programs.BIN / program)
        coarse = bin / "bem_contact"
        coarse.write_text(COARSE.format(program=programs.BIN / "bem_contact"))
        coarse.chmod(0o755)
        file = self.folder / "rail.h5"

        def by_name(name):
            return run(programs.ROOT / "tools" / "influence", name, file, env=os.environ | {"CONFORMAL_BIN": str(bin)})

        done = by_name("56 E1")  # as people say it
        self.assertEqual(done.returncode, 0, done.stderr)
        body = file.with_suffix(".toml").read_text()
        self.assertIn('profile = "56E1"', body)
        scene = self.folder / "scene.toml"
        scene.write_text(SCENE.format(file=file))
        said = run(programs.BIN / "bem_contact", "check", scene)
        self.assertIn("rail: influence file of 'rail 56E1', strip s = -45.00 .. -20.00 mm", said.stdout)
        made = file.stat().st_mtime_ns
        again = by_name("56E1")
        self.assertIn("is up to date", again.stderr)
        self.assertEqual(file.stat().st_mtime_ns, made)
        other = by_name("60E1")  # another body lies there
        self.assertEqual(other.returncode, 2)
        self.assertIn("is not the body of 60E1", other.stderr)
        self.assertEqual(file.with_suffix(".toml").read_text(), body)
        self.assertNotEqual(by_name("61E9").returncode, 0)


if __name__ == "__main__":
    unittest.main()
