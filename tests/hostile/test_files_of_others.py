"""What is not ours is never removed or replaced, at any command; what was changed since is noticed when it is read."""

import json
import os
import random
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import doors

SCENES, BODIES = doors.SCENES, doors.SOURCE / "data" / "bodies"
FLIPS = int(os.environ.get("HOSTILE_FLIPS", "40"))  # bits that are changed in each kind of file; 1000 takes half an hour
SCENE = """kind="wheel_rail"
rail.profile="60E1"
wheel.profile="S1002"
solver.model="halfspace"
load.force=8e4
motion.friction=0.3
grid.dx=1.0
grid.ds=0.6
"""
STUDY = SCENE + "[conicity]\nto=3\n"
SWEEP = SCENE.replace("load.force=8e4\n", "") + "[sweep]\nfields = false\nload.force = [5e4, 6e4, 7e4, 8e4, 9e4, 1e5, 1.1e5, 1.2e5]\n"
ELLIPSE = """ 3  MODULE
 200100  P-B-T-N-F-S   remark
 022020  L-D-C-M-Z-E
 0101111 H-G-I-A-O-W-R
 1000.0  0.0 0.0  0d0      FN, CKSI, CETA, CPHI
 0.3 0.3                   FSTAT, FKIN
 0.28 0.28  82000.  82000. POISS 1,2, GG 1,2
 -1                        IPOTCN
 20 20  1d-2 1d-2 1.2      MX, MY, A1, B1, SCALE
 0  MODULE
"""


class InFolder(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = Path(temporary.name)

    def file(self, name, text):
        path = self.folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(text if isinstance(text, bytes) else text.encode())
        return path

    def run_program(self, *words, **options):
        return doors.program(*words, cwd=self.folder, **options)

    def done(self, *words, code=0):
        found, message = self.run_program(*words)
        self.assertEqual(found, code, message)

    def refused(self, *words, saying):
        code, message = self.run_program(*words)
        self.assertEqual(code, 2, message)
        self.assertIn(saying, message)


# A line for each command that writes: the file that it reads, and the other words. "OUT" is an output.
RESULT = "result.h5"
READS = {
    "new": ("profile.whl", ["new", "--wheel", "profile.whl", "--rail", "60E1"]),
    "solve": ("hertz.toml", ["solve", "hertz.toml"]),
    "compare": ("scene.toml", ["compare", "scene.toml", "--models", "hertz,halfspace"]),
    "influence expand": ("small.h5", ["influence", "expand", "small.h5", "--dx", "1", "--ds", "1", "--mx", "2", "--my", "2"]),
    "influence pack": ("small.h5", ["influence", "pack", "small.h5"]),
    "profile": ("profile.whl", ["profile", "profile.whl"]),
    "sweep": ("sweep.toml", ["sweep", "sweep.toml", "--jobs", "1"]),
    "replay": ("run.csv", ["replay", "run.csv", "replay.toml", "--jobs", "1"]),
    "conicity": ("profile.whl", ["conicity", "--wheel", "profile.whl", "--rail", "60E1"]),
    "creep-curves": ("scene.toml", ["creep-curves", "scene.toml", "--xi=0:1e-3:2"]),
    "fit": ("points.csv", ["fit", "scene.toml", "--measured", "points.csv", "--parameters", "motion.friction"]),
    "table": ("table.toml", ["table", "table.toml"]),
    "fmu": ("forces.h5", ["fmu", "forces.h5", "--sources-only"]),
    "wear": ("scene.toml", ["wear", "scene.toml"]),
    "fatigue": ("sweep.toml", ["fatigue", "sweep.toml"]),
    "stresses": (RESULT, ["stresses", RESULT]),
    "shakedown": ("scene.toml", ["shakedown", "scene.toml"]),
    "wheelset": ("wheelset.toml", ["wheelset", "wheelset.toml"]),
    "report": (RESULT, ["report", RESULT]),
    "plot": ("profile.whl", ["plot", "profile.whl"]),
}
NO_FILE = {"check", "info", "explore", "schema"}
FOLDERS = {"study", "from-contact"}  # tested below; wear is both
OUTPUTS = {"-o": ".h5", "--csv": ".csv", "--vtk": ".vts", "--vtu": ".vtu", "--plot": ".html", "--text": ".txt"}


class EveryCommand(InFolder):
    """The list of commands is the program's."""

    def commands(self):
        text = subprocess.run([doors.PROGRAM, "--help"], check=True, capture_output=True, text=True).stdout
        listed = text[text.index("Subcommands:"):].split("\n\n")[0]
        return re.findall(r"^  ([a-z-]+) ", listed, re.M)

    def outputs(self, command):
        text = subprocess.run([doors.PROGRAM, *command.split(), "--help"], check=True, capture_output=True, text=True).stdout
        return [option for option in OUTPUTS if re.search(rf"^ +{option}(?:,--output)? TEXT", text, re.M)]

    def put_inputs(self):
        self.file("scene.toml", SCENE)
        self.file("sweep.toml", SWEEP)
        self.file("points.csv", "xi,Fx\n1e-3,2e3\n2e-3,2.5e3\n4e-3,2.8e3\n")
        self.file("table.toml", SCENE + "[table]\nposition.lateral = { from = 0, to = 1, count = 2 }\n")
        self.file("replay.toml", SCENE + "[replay.columns]\nposition.lateral = \"y\"\n")
        self.file("run.csv", "y\n0\n1\n")
        self.file("wheelset.toml", SCENE.replace("load.force", "wheelset.force"))
        shutil.copy(SCENES / "hertz.toml", self.folder)
        shutil.copy(BODIES / "hollow_wheel.txt", self.folder / "profile.whl")
        shutil.copy(doors.SOURCE / "data" / "influence" / "small_rail.h5", self.folder / "small.h5")
        self.done("solve", "hertz.toml", "-o", RESULT)
        self.done("table", "table.toml", "--tolerance", "1", "-o", "forces.h5")

    def test_no_output_is_an_input(self):
        self.put_inputs()
        self.assertEqual(set(self.commands()), {command.split()[0] for command in READS} | NO_FILE | FOLDERS, "a new command wants a line here")
        for command, (name, words) in READS.items():
            outputs = self.outputs(command)
            self.assertTrue(outputs, command)
            for option in outputs:
                ending = {"report": ".html", "plot": ".png", "new": ".toml", "fmu": ".fmu"}.get(command, OUTPUTS[option])
                for kind, make in (("hard link", os.link), ("link", os.symlink)):
                    with self.subTest(f"{command} {option} {kind}"):
                        before, output = (self.folder / name).read_bytes(), self.folder / f"output{ending}"
                        make(self.folder / name, output)
                        more = ["-o", "other.h5"] if command in ("sweep", "replay") and option != "-o" else []
                        code, message = self.run_program(*words, *more, option, output)
                        output.unlink()
                        self.assertEqual(code, 2, message)
                        self.assertRegex(message, "would overwrite|exists")
                        self.assertEqual((self.folder / name).read_bytes(), before)

    def test_no_foreign_hdf5_is_replaced(self):
        self.put_inputs()
        for command, (_, words) in READS.items():
            if "-o" not in self.outputs(command) or command in ("report", "plot", "new", "influence expand", "fmu"):
                continue
            with self.subTest(command):
                foreign = self.file("foreign.h5", "mine")
                self.refused(*words, "-o", foreign, saying="exists")
                self.assertEqual(foreign.read_text(), "mine")

    def test_no_empty_value(self):
        for command in self.commands():
            if command in ("influence", "plot"):  # their options are of another program, or below
                continue
            text = subprocess.run([doors.PROGRAM, command, "--help"], check=True, capture_output=True, text=True).stdout
            for option in re.findall(r"^ +(?:-\w,)?(--[a-z-]+)(?:,--[a-z-]+)* (?:TEXT|FLOAT|INT)", text, re.M):
                with self.subTest(f"{command} {option}"):
                    code, message = self.run_program(command, option, "")
                    self.assertEqual(code, 2, message)
                    self.assertRegex(message, rf"empty value|names no file|{option}: ")
        for words in (["plot", "r.h5", "-o", ""], ["conicity", "--wheel", "S1002", "--rail", "60E1", "--rail-inclination", ""]):
            self.assertEqual(self.run_program(*words)[0], 2)


class Studies(InFolder):
    def test_a_scene_among_the_parts(self):
        scene = self.file("d/parts/solve.toml", STUDY)
        self.refused("study", scene, "-o", "d", saying="not one of bem_contact study")
        self.assertEqual(scene.read_text(), STUDY)

    def test_files_of_others(self):
        scene = self.file("s.toml", STUDY)
        files = [self.file(name, "mine") for name in ("d/parts/solve/a.txt", "d/parts/conicity.step")]
        self.refused("study", scene, "-o", "d", saying="not one of bem_contact study")
        self.done("study", scene, "-o", "e")
        files += [self.file(name, "mine") for name in ("e/parts/solve.notes", "e/parts/solve/a.txt", "e/parts/.solve.swp")]
        scene.write_text(STUDY.replace("8e4", "5e4"))
        self.done("study", scene, "-o", "e")
        for file in files:
            self.assertEqual(file.read_text(), "mine")

    def test_inputs_with_the_names_of_answers(self):
        shutil.copy(BODIES / "hollow_wheel.txt", self.file("d/study.csv", ""))
        scene = self.file("d/s.toml", STUDY.replace('"S1002"', '"study.csv"'))
        self.refused("study", scene, "-o", "d", saying="would overwrite")
        self.assertEqual((self.folder / "d/study.csv").read_bytes(), (BODIES / "hollow_wheel.txt").read_bytes())
        for name in ("study.csv", "study.h5", "study.html"):
            scene = self.file(f"{name}.d/{name}", STUDY)
            self.refused("study", scene, "-o", scene.parent, saying="would overwrite")
            mine = self.file(f"{name}.e/{name}", "mine")
            self.refused("study", scene, "-o", mine.parent, saying="has not made it")
            self.assertEqual((scene.read_text(), mine.read_text()), (STUDY, "mine"))

    def test_links_are_not_followed(self):
        scene, mine = self.file("s.toml", STUDY), self.file("mine", "mine")
        self.done("study", scene, "-o", "d")
        for name in ("parts/solve.txt", "study.csv", "conicity_conicity.csv"):
            (self.folder / "d" / name).unlink()
            (self.folder / "d" / name).symlink_to(mine)
            scene.write_text(STUDY.replace("8e4", "5e4"))
            self.refused("study", scene, "-o", "d", saying="link")
            self.assertEqual(mine.read_text(), "mine")
            (self.folder / "d" / name).unlink()

    def test_a_state_that_a_person_has_changed(self):
        scene = self.file("s.toml", STUDY)
        self.done("study", scene, "-o", "d")
        state = self.folder / "d/parts/solve.json"
        whole = json.loads(state.read_text())
        for name in whole:
            for value in (5, "text", None, [], {"a": 1}, [1], True):
                with self.subTest(f"{name} = {value}"):
                    state.write_text(json.dumps(whole | {name: value}))
                    self.done("study", scene, "-o", "d")
        state.write_text("[" * 100000)
        self.done("study", scene, "-o", "d")

    def test_a_part_of_another_scene(self):
        scene, other = self.file("s.toml", STUDY), self.file("o.toml", STUDY.replace("8e4", "5e4"))
        self.done("study", scene, "-o", "d")
        self.done("solve", other, "-o", "d/parts/solve.h5")
        self.refused("study", scene, "-o", "d", saying="it has changed since it was written")

    def test_tables_of_parts_that_nobody_asks_for(self):
        scene = self.file("s.toml", STUDY)
        self.done("study", scene, "-o", "d")
        self.assertTrue(list((self.folder / "d").glob("conicity_*.csv")))
        scene.write_text(SCENE)
        self.done("study", scene, "-o", "d")
        self.assertEqual(list((self.folder / "d").glob("conicity*")) + list((self.folder / "d/parts").glob("conicity*")), [])

    def test_no_program_of_a_scene(self):
        for table, key in (("influence", "program"), ("wear", "influence")):
            mark = self.folder / "started"
            program = self.file("evil", f"#!/bin/sh\ntouch {mark}\n")
            program.chmod(0o755)
            scene = self.file("s.toml", SCENE + f'rail.influence = "r.h5"\n[influence]\nrail = "{BODIES}/small_rail.toml"\n')
            text = scene.read_text()
            scene.write_text(text + f'program = "{program}"\n' if table == "influence" else text + f'[wear]\n{key} = "{program}"\n')
            self.refused("study", scene, "-o", "d", saying="names the program")
            self.assertFalse(mark.exists())


class Folders(InFolder):
    def test_wear(self):
        collective = SCENES / "wear_collective.toml"
        mine = self.file("w/rail_0000.txt", (BODIES / "worn_rail.txt").read_bytes())
        self.refused("wear", collective, "-o", "w", "--depth", "0.02", saying="not one of bem_contact wear")
        self.assertEqual(mine.read_bytes(), (BODIES / "worn_rail.txt").read_bytes())
        self.done("wear", collective, "-o", "v", "--depth", "0.02")
        last = sorted((self.folder / "v").glob("rail_*.txt"))[-1]
        following = self.file(f"v/rail_{int(last.stem[-4:]) + 1:04}.txt", "mine")
        self.refused("wear", collective, "-o", "v", "--depth", "0.06", saying="would be replaced")
        self.assertEqual(following.read_text(), "mine")
        following.unlink()
        for name in ("wear.h5", "wear.csv", last.name):
            whole = (self.folder / "v" / name).read_bytes()
            (self.folder / "v" / name).write_bytes(whole[:-1] + bytes([whole[-1] ^ 1]))
            self.refused("wear", collective, "-o", "v", "--depth", "0.02", saying="has changed since it was written")
            (self.folder / "v" / name).write_bytes(whole)
        self.done("wear", collective, "-o", "v", "--depth", "0.02")

    def test_from_contact(self):
        cases = self.file("c.inp", ELLIPSE)
        self.done("from-contact", cases, "-o", "scenes")
        self.done("from-contact", cases, "-o", "scenes")  # ours, as it was
        scene = self.folder / "scenes/c_001.toml"
        scene.write_text(scene.read_text() + "# edited\n")
        self.refused("from-contact", cases, "-o", "scenes", saying="it has changed since it was written")
        self.assertTrue(scene.read_text().endswith("# edited\n"))
        mine = self.file("other/c_001.toml", "mine")
        self.refused("from-contact", cases, "-o", "other", saying="has not made it")
        self.assertEqual(mine.read_text(), "mine")

    def test_sweep(self):
        scene = self.file("s.toml", SWEEP)
        self.done("sweep", scene, "-o", "p/0.h5", "--cases", "0:3") if (self.folder / "p").mkdir() is None else None
        self.done("sweep", scene, "-o", "p/3.h5", "--cases", "3:6")
        part = (self.folder / "p/3.h5").read_bytes()
        for parts in (["p"], ["p/0.h5", "p/3.h5"]):
            self.refused("sweep", scene, "--join", *parts, "-o", "p/3.h5", saying="would overwrite")
        self.done("sweep", scene, "-o", "other.h5", "--cases", "6:8")
        self.refused("sweep", scene, "--join", "p", "-o", "other.h5", saying="does not hold the cases of a sweep")
        self.assertEqual((self.folder / "p/3.h5").read_bytes(), part)
        self.done("sweep", scene, "-o", "whole.h5", "--jobs", "1")
        whole = (self.folder / "whole.h5").read_bytes()
        self.refused("sweep", scene, "-o", "whole.h5", "--cases", "0:3", saying="does not hold a part of a sweep")
        self.assertEqual((self.folder / "whole.h5").read_bytes(), whole)
        for name in ("t_patches.csv", "t_units.csv"):
            mine = self.file(name, "mine")
            self.refused("sweep", scene, "-o", "whole.h5", "--csv", "t.csv", saying="exists and would be replaced")
            self.assertEqual(mine.read_text(), "mine")
            mine.unlink()
        self.done("sweep", scene, "-o", "whole.h5", "--csv", "t.csv")
        self.done("sweep", scene, "-o", "whole.h5", "--csv", "t.csv")  # ours

    def test_the_folder_of_parts(self):
        scene = self.file("s.toml", SWEEP)
        mine = self.file("s.h5.parts/2024.h5.tmp-backup", "mine")
        os.mkfifo(self.folder / "s.h5.parts/size")  # nobody opens it
        lock = self.file("s.h5.parts/lock", "mine")
        self.refused("sweep", scene, "-o", "s.h5", "--jobs", "2", saying="is no lock")
        self.assertEqual(lock.read_text(), "mine")
        lock.unlink()
        self.done("sweep", scene, "-o", "s.h5", "--jobs", "2")
        self.assertEqual(mine.read_text(), "mine")
        self.assertTrue((self.folder / "s.h5.parts/size").exists())

    def test_surfaces(self):
        mine = self.file("p_right.vts", "mine")
        scene = self.file("s.toml", SCENE.replace("load.force", "wheelset.force"))
        self.refused("wheelset", scene, "--vtk-prefix", "p", saying="exists and would be replaced")
        self.assertEqual(mine.read_text(), "mine")


@unittest.skipUnless("MESH_BODY" in os.environ, "mesh_body is not built")
class Bodies(InFolder):
    BODY = BODIES / "small_wheel.toml"

    def mesh(self, output):
        return doors.run(os.environ["MESH_BODY"], self.BODY, "-o", output, cwd=self.folder)

    def influence(self, mesh, output):
        return doors.run(os.environ["FEM_INFLUENCE"], self.BODY, mesh, "-o", output, cwd=self.folder)

    def test_programs(self):
        mine = self.file("o.msh", "mine")
        self.assertEqual(self.mesh(mine)[0], 2)
        self.assertEqual(self.mesh("m.msh")[0], 0)
        self.assertEqual(self.mesh("m.msh")[0], 0)  # ours
        foreign = self.file("p.h5", "mine")
        self.assertEqual(self.influence("m.msh", foreign)[0], 2)
        self.assertEqual((mine.read_text(), foreign.read_text()), ("mine", "mine"))

    def test_tool(self):
        tool = doors.SOURCE / "tools" / "influence"
        options = {"cwd": self.folder, "env": os.environ | {"CONFORMAL_BIN": str(Path(doors.PROGRAM).parent)}}
        for name, output in (("o.msh", "o.h5"), ("p.h5", "p.h5")):
            mine = self.file(name, "mine")
            self.assertEqual(doors.run(tool, BODIES / "small_rail.toml", output, **options)[0], 2)
            self.assertEqual(mine.read_text(), "mine")

    def test_a_changed_mesh(self):
        self.assertEqual(self.mesh("m.msh")[0], 0)
        whole = (self.folder / "m.msh").read_bytes()
        head = whole.index(b"curved edges")
        begin = whole.index(b"\n", head) + 1
        without_edges = whole[:begin] + whole[whole.index(b"$EndComments", head):]
        one_less = whole[:begin] + whole[whole.index(b"\n", begin) + 1:]
        changed = [without_edges, one_less]
        draws = random.Random(1)
        for _ in range(max(4, FLIPS // 4)):
            at = draws.randrange(len(whole))
            changed.append(whole[:at] + bytes([whole[at] ^ 1 << draws.randrange(8)]) + whole[at + 1:])
        for mesh in changed:
            code, message = self.influence(self.file("n.msh", mesh), "n.h5")
            self.assertEqual(code, 2, message)
            self.assertFalse((self.folder / "n.h5").exists())


class BitFlips(InFolder):
    """Each bit that changes is refused, or nothing changes."""

    def flips(self, file, count=FLIPS):
        whole, draws = file.read_bytes(), random.Random(file.name)
        for _ in range(count):
            at, bit = draws.randrange(len(whole)), draws.randrange(8)
            file.write_bytes(whole[:at] + bytes([whole[at] ^ 1 << bit]) + whole[at + 1:])
            yield f"{file.name}, byte {at}, bit {bit}"
        file.write_bytes(whole)

    def outcome(self, *words):
        done = subprocess.run([doors.PROGRAM, *map(str, words)], cwd=self.folder, capture_output=True, timeout=120)
        return done.returncode, done.stdout

    def test_influence_file(self):
        file = self.folder / "small.h5"
        shutil.copy(doors.SOURCE / "data" / "influence" / "small_rail.h5", file)
        for which in self.flips(file):
            self.assertEqual(self.outcome("info", file)[0], 2, which)

    @unittest.skipUnless(doors.HAS_PYTHON, "no Python module")
    def test_results_and_tables(self):
        scene = self.file("s.toml", SCENE)
        self.done("solve", scene, "-o", "r.h5")
        self.done("creep-curves", scene, "--xi=0:1e-3:2", "-o", "c.h5")
        self.done("table", self.file("t.toml", SCENE + "[table]\nposition.lateral = { from = 0, to = 1, count = 2 }\ntolerance = 1\n"),
                  "-o", "t.h5")
        self.done("study", self.file("st.toml", STUDY), "-o", "d")
        script = ("import sys, json, bem_contact, bem_contact._core as core\n"
                  "file, count = sys.argv[1], int(sys.argv[2])\n"
                  "import random\n"
                  "whole, draws = open(file, 'rb').read(), random.Random(file)\n"
                  "read = lambda: repr(core._read_record(file))\n"
                  "before = read()\n"
                  "for k in range(count):\n"
                  "    at, bit = draws.randrange(len(whole)), draws.randrange(8)\n"
                  "    open(file, 'wb').write(whole[:at] + bytes([whole[at] ^ 1 << bit]) + whole[at + 1:])\n"
                  "    try:\n"
                  "        assert read() == before, f'byte {at}, bit {bit} changes the answer'\n"
                  "    except bem_contact.InputError:\n"
                  "        pass\n")
        for name in ("r.h5", "c.h5", "t.h5", "d/study.h5"):
            with self.subTest(name):
                code, message = doors.run(sys.executable, "-c", script, name, max(FLIPS, 100), cwd=self.folder, timeout=3000)
                self.assertEqual(code, 0, message)

    def test_wear_state(self):
        words = ("wear", SCENES / "wear_collective.toml", "-o", "w", "--depth", "0.02")
        self.done(*words)
        kept = {file.name: file.read_bytes() for file in (self.folder / "w").iterdir()}
        for name in kept:
            for which in self.flips(self.folder / "w" / name, max(2, FLIPS // len(kept))):
                code, _ = self.outcome(*words)
                now = {file.name: file.read_bytes() for file in (self.folder / "w").iterdir() if file.name != name}
                self.assertIn(code, (0, 2), which)
                self.assertEqual(now, {other: kept[other] for other in kept if other != name}, which)

    def test_study_state(self):
        scene = self.file("s.toml", SCENE)
        words = ("study", scene, "-o", "d")
        self.done(*words)
        table = (self.folder / "d/study.csv").read_bytes()
        for file in sorted(self.folder.glob("d/parts/*")) + sorted(self.folder.glob("d/parts/.made*")):
            if file.is_file() and file.stat().st_size > 0:
                for which in self.flips(file, max(2, FLIPS // 20)):
                    code, _ = self.outcome(*words)
                    self.assertIn(code, (0, 2), which)
                    if code == 0:
                        self.assertEqual((self.folder / "d/study.csv").read_bytes(), table, which)


if __name__ == "__main__":
    unittest.main()
