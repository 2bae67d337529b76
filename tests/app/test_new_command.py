"""What `bem_contact new` writes: it is accepted without a warning, and each of its tables works as soon as its # is gone."""

import csv
import os
import re
import subprocess
import tempfile
import unittest
from pathlib import Path

PROGRAM = os.environ["BEM_CONTACT"]
CURVE, STRAIGHT = ["--curve", "300"], []


def points_of(profile, turn=0.0):
    """A standard as a file of points, turned towards the track's centre (rad)."""
    with tempfile.TemporaryDirectory() as folder:
        table = Path(folder, "p.csv")
        subprocess.run([PROGRAM, "profile", profile, "--step", "0.5", "--csv", table], check=True, stdout=subprocess.DEVNULL)
        rows = [line.split(",") for line in table.read_text().splitlines()[1:]]
    return "".join(f"{float(y) + turn * float(z):.6f} {float(z) - turn * float(y):.6f}\n" for _, y, z, *_ in rows)


class New(unittest.TestCase):
    def setUp(self):
        self.temporary = tempfile.TemporaryDirectory()
        self.folder = Path(self.temporary.name)

    def tearDown(self):
        self.temporary.cleanup()

    def call(self, *words, code=0):
        done = subprocess.run([PROGRAM, *map(str, words)], capture_output=True, text=True, cwd=self.folder)
        self.assertEqual(done.returncode, code, f"{words}\n{done.stdout}\n{done.stderr}")
        return done.stdout + done.stderr

    def new(self, *options, rail="60E1", wheel="S1002", coarse=True):
        file = self.folder / "case.toml"
        file.unlink(missing_ok=True)
        self.call("new", "--wheel", wheel, "--rail", rail, *options, "-o", file)
        if coarse:  # the tests need no accuracy
            text = file.read_text()
            self.assertIn("accuracy = 0.02 ", text)
            file.write_text(text.replace("accuracy = 0.02 ", "accuracy = 0.2 "))
        return file

    def test_its_options_are_in_the_scene(self):
        file = self.new(*CURVE, "--superelevation", 60, "--load", 9e4, "--force-y", 1.5e4, "--yaw", 2e-3, "--inner-rail", "54E1")
        text = file.read_text()
        for line in ("superelevation = 60 ", "force = 180000 ", "force_y = 15000 ", "yaw = 0.002 ", 'left_rail.profile = "54E1"'):
            self.assertIn(line, text)
        self.call("check", "--strict", file)
        for option in (["--superelevation", "60"], ["--inner-rail", "54E1"]):
            self.assertIn("Give --curve", self.call("new", "--wheel", "S1002", "--rail", "60E1", *option, code=2))

    def test_a_rail_is_not_inclined_twice(self):
        """What `profile` finds: a rail that was measured as it lies in the track has its inclination already."""
        (self.folder / "lying.txt").write_text(points_of("60E1", 0.025))
        (self.folder / "upright.txt").write_text(points_of("60E1"))
        for rail, inclination in (("lying.txt", "0"), ("upright.txt", "0.025"), ("60E1", "0.025")):
            file = self.new(rail=rail)
            self.assertRegex(file.read_text(), rf"(?m)^rail_inclination = {re.escape(inclination)} ")
            self.assertNotIn("warning", self.call("check", file))
        both = self.new(*CURVE, "--inner-rail", "60E1", rail="lying.txt").read_text()
        self.assertRegex(both, r"(?m)^rail_inclination = 0 ")
        self.assertRegex(both, r"(?m)^left_rail.inclination = 0.025 ")

    def test_a_name_may_have_quotes(self):
        for name in ('it is a "wheel".txt', "back\\slash.txt"):
            (self.folder / name).write_text(points_of("S1002"))
            self.call("check", self.new("--curve", "300", wheel=name, coarse=False))
            self.call("new", "--crossing", "9", "--wheel", name, "--rail", "60E1", "-o", f"crossing of {name}.toml")

    def test_a_crossing_by_its_angle(self):
        """Plain rail, a wing that leads away, a nose: the wheel sinks between the two and rises again, and each place is certified."""
        file = self.folder / "crossing.toml"
        asked = ("new", "--crossing", 9, "--wheel", "S1002", "--rail", "60E1")
        self.call(*asked, "-o", file)
        self.assertIn("rail.sections", self.call("check", "--strict", file) + file.read_text())
        text = re.sub(r"(?m)^position.along = .*", "position.along = [-430, -200, 0, 60, 120, 200, 300, 400]", file.read_text())
        file.write_text(text)
        self.call("sweep", file, "-o", "passage.h5", "--csv", "passage.csv")
        with open(self.folder / "passage.csv", newline="") as table:
            rows = list(csv.DictReader(table))
        self.assertEqual({row["status"] for row in rows}, {"certified"})
        height = {float(row["position.along"]): float(row["vertical"]) - float(row["approach"]) for row in rows}
        self.assertGreater(height[0], height[-200])
        self.assertGreater(height[60], height[0])
        self.assertGreater(height[120] - height[-430], 0.5)  # it has sunk
        self.assertAlmostEqual(height[400], height[-430], delta=0.3)  # and stands on the nose as on the rail
        slope = {float(row["position.along"]): float(row["Fx_slope"]) for row in rows}
        self.assertGreater(slope[200], 500)  # the nose rises 4 mm in 270 mm and pushes against the wheel
        for words, options in (("exists", ["-o", file]), ("needs a name", []), ("--curve", ["--curve", "300", "-o", "other.toml"]),
                               ("--nose-width", ["--nose-width", "90", "-o", "other.toml"])):
            self.assertIn(words, self.call(*asked, *options, code=2))
        self.assertIn("--crossing", self.call("new", "--wheel", "S1002", "--rail", "60E1", "--flangeway", 50, code=2))

    def commented_tables(self, text):
        """The tables behind the #, by name."""
        tables, name = {}, None
        for line in text[text.index("# More of them"):].splitlines()[1:]:
            line = line.removeprefix("# ")
            if head := re.match(r"\[(\w+)\]", line):
                name = head[1]
            tables[name] = tables.get(name, "") + line + "\n"
        return tables

    def test_each_table_works_without_its_mark(self):
        for options in (CURVE, STRAIGHT):
            text = self.new(*options).read_text()
            tables = self.commented_tables(text)
            self.assertEqual(set(tables), {"sweep", "table", "compare", "influence", "uncertainty"})
            for name, table in tables.items():
                with self.subTest(name, options=options):
                    file = self.folder / f"{name}.toml"
                    if name == "influence":
                        self.influence(file, text, table)
                        continue
                    file.write_text(text.replace("# More of them", table + "\n# More of them"))
                    self.call("check", "--strict", file)
                    only = {"uncertainty": "draws/0001"}.get(name, name)
                    if name == "uncertainty":  # one part of a draw will do
                        file.write_text(file.read_text().replace("draws = 10", 'draws = 10\nparts = "conicity"', 1))
                    out = self.folder / f"out_{name}{len(options)}"
                    if name in ("table", "compare"):
                        self.call("study", file, "-o", out, "--only", "wheelset")
                    said = self.call("study", file, "-o", out, "--only", only)
                    self.assertNotIn("without effect", said)

    def influence(self, file, text, table):
        """Its program is called with the names and the files of the scene."""
        made = self.folder / "made.sh"
        made.write_text('#!/bin/sh\necho "$@" >> called.txt\ntouch "$2"\n')
        made.chmod(0o755)
        (self.folder / "called.txt").unlink(missing_ok=True)
        for body in ("rail.h5", "wheel.h5"):
            (self.folder / body).unlink(missing_ok=True)
        keys = 'rail.influence = "rail.h5"\nwheel.influence = "wheel.h5"\n'
        self.assertIn('rail.influence = "rail.h5" and wheel.influence = "wheel.h5"', text)
        file.write_text(keys + text + table + f'program = "{made}"\n')
        self.call("study", file, "-o", self.folder / "out_influence", "--only", "influence", "--influence", made)
        called = (self.folder / "called.txt").read_text().splitlines()
        self.assertEqual([line.split()[0] for line in called], ["60E1", "S1002"])
        self.assertEqual([Path(line.split()[1]).name for line in called], ["rail.h5", "wheel.h5"])

    def test_wear_with_a_sweep_of_wheelsets(self):
        """A load collective is of one wheel: the study takes the wheelset without [sweep], and says so; wear alone names both tables."""
        text = self.new().read_text()
        file = self.folder / "swept.toml"
        file.write_text(text + self.commented_tables(text)["sweep"])
        said = self.call("wear", file, "-o", self.folder / "worn", code=2)
        self.assertIn("[sweep]", said)
        self.assertIn("[wheelset]", said)
        out = self.folder / "out"
        self.assertIn("without [sweep]", self.call("study", file, "-o", out, "--only", "wear"))

    def test_a_swept_key_that_another_overrules(self):
        text = self.new(*CURVE).read_text()
        file = self.folder / "swept.toml"
        file.write_text(text + "[sweep]\nposition.lateral = [1, 2]\n")
        self.assertIn("wheelset.force_y is given", self.call("sweep", file, "-o", self.folder / "s.h5", code=2))


if __name__ == "__main__":
    unittest.main()
