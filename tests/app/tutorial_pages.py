"""data/tutorial and data/scenes/README.md: the commands of the pages run, and print what the pages print.

A page is read as its reader does: a toml block is saved under the name that the text before it gives, a python block runs,
indented lines that begin with a program are called in the project's folder, and other indented lines must be in what the commands
of their page have printed. Numbers may differ a little, `...` stands for anything. Tables are compared with the CSV files that they come
from (page_tables.py). In pictures no word may lie on another.
Commands that the page says to take seconds are left out, unless TUTORIAL_LONG is set.
"""

import contextlib
import io
import json
import os
import re
import resource
import runpy
import shlex
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import h5py
from PIL import Image

import bem_contact
import picture_faults
sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
import page_tables
from bem_contact.plotting import command

ROOT = Path(__file__).resolve().parents[2]
PAGES = ROOT / "data" / "tutorial"
PROGRAM = Path(os.environ["BEM_CONTACT"])
TOLERANCE = 5e-3  # of numbers, relative: other machines choose other last digits
LONG = re.compile(r"#.* s on one core")
NUMBER = re.compile(r"[-+]?(\d+\.?\d*|\.\d+)(e[-+]?\d+)?")


def kind_of(line, inside):
    if line.lstrip().startswith("```"):
        return "fence"
    if inside:
        return "file"
    if not line.startswith("    "):
        return "text"
    return "commands" if line[4:].startswith(("bem_contact ", "tools/", "mkdir ")) else "output"


def blocks_of(text):
    """(kind, lines) in the order of the page: python and file (between fences), commands and output (indented), text."""
    blocks, inside = [("text", [])], False
    for line in text.splitlines():
        kind = kind_of(line, inside)
        if kind == "fence":
            inside = not inside
            if inside:
                blocks.append(("python" if line.strip() == "```python" else "file", []))
        elif kind == blocks[-1][0] or inside:
            blocks[-1][1].append(line)
        else:
            blocks.append((kind, [line]))
    return blocks


def same_word(wanted, found):
    if wanted == found:
        return True
    a, b = (NUMBER.fullmatch(word.rstrip(",;%:")) for word in (wanted, found))
    if not (a and b):
        return False
    a, b = float(a[0]), float(b[0])
    return abs(a - b) <= TOLERANCE * max(abs(a), abs(b)) + 1e-9


def same_line(wanted, found):
    """Word for word; `...` at the end or in the middle stands for anything."""
    pieces = [piece.split() for piece in wanted.split("...")]
    words, at = found.split(), 0
    for k, piece in enumerate(pieces):
        places = range(at, len(words) - len(piece) + 1) if k else [0]
        at = next((p + len(piece) for p in places if p + len(piece) <= len(words) and all(map(same_word, piece, words[p:]))), None)
        if at is None:
            return False
    return at == len(words) or wanted.rstrip().endswith("...")


def seconds():
    """Of processor time so far: of the programs, and of this process, which draws the pictures."""
    return [sum(resource.getrusage(who)[:2]) for who in (resource.RUSAGE_CHILDREN, resource.RUSAGE_SELF)]


class Pages(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.folder = Path(cls.temporary.name)
        for name in ("data", "tools"):
            (cls.folder / name).symlink_to(ROOT / name)
        (cls.folder / "demo").mkdir()
        from bem_contact.plotting import style
        cls.pictures, save = {}, style.save

        def save_and_look(figure, output):
            save(figure, output)
            cls.pictures[str(output)] = picture_faults.faults(figure)

        style.save = save_and_look
        os.environ["CONFORMAL_BIN"] = str(PROGRAM.parent)
        cls.before = os.getcwd()
        os.chdir(cls.folder)
        order = re.findall(r"\| \[[\w-]+\]\(([\w-]+\.md)\)", (PAGES / "README.md").read_text())
        cls.pages = sorted(PAGES.glob("*.md"), key=lambda page: order.index(page.name) if page.name in order else -1)
        cls.ordered = order

    @classmethod
    def tearDownClass(cls):
        for name in cls.pictures if "KEEP_PICTURES" in os.environ else ():
            if name.endswith(".png"):
                shutil.copy(name, os.environ["KEEP_PICTURES"])
        os.chdir(cls.before)
        cls.temporary.cleanup()

    def call(self, line):
        """The program in a process of its own; pictures and tools in this one, which has their libraries already."""
        words = shlex.split(line, comments=True)
        if words[0] == "mkdir":
            Path(words[-1]).mkdir(parents=True, exist_ok=True)
            return ""
        if words[:2] == ["bem_contact", "plot"]:
            with contextlib.redirect_stderr(io.StringIO()) as said:
                command.main(words[2:])
            return said.getvalue()
        if words[0] == "bem_contact":
            done = subprocess.run([PROGRAM, *words[1:]], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
            self.assertEqual(done.returncode, 0, f"{line}:\n{done.stdout}")
            return done.stdout
        said, sys.argv = io.StringIO(), words
        with contextlib.redirect_stderr(said):
            try:
                runpy.run_path(words[0], run_name="__main__")
            except SystemExit as end:
                self.assertIn(end.code, (None, 0), f"{line}:\n{said.getvalue()}")
        return said.getvalue()

    def run_page(self, page, checked=True):
        self.run_text(page.name, page.read_text(), checked)

    def run_text(self, name, page, checked=True):
        printed, left_out, text, waiting, prose = [], set(), "", False, ""
        for kind, content in blocks_of(page):
            if kind == "text":
                text = " ".join(content)
                prose += "" if waiting else "\n\n" + "\n".join(content)
            elif kind == "file":
                for file in re.findall(r"[Ss]ave this as `(demo/\S+)`", text)[-1:]:
                    Path(file).write_text("\n".join(content) + "\n")
            elif kind == "python":
                with contextlib.redirect_stdout(io.StringIO()):
                    exec("\n".join(content), {"bem_contact": bem_contact})
            elif kind == "commands":
                for line in map(str.strip, content):
                    files = set(re.findall(r"demo/\S+", line))
                    waiting = "TUTORIAL_LONG" not in os.environ and bool(LONG.search(line) or files & left_out)
                    if waiting:
                        left_out |= files
                        continue
                    printed += self.call(line).splitlines()
                    for output in re.findall(r"(?:-o|--csv) (demo/\S+)", line):
                        self.assertTrue(Path(output).exists(), line)
            elif not waiting and checked:
                for line in content:
                    if line.strip() != "..." and not any(same_line(line, found) for found in printed):
                        self.fail(f"{name}: no command has printed\n{line}\nbut\n" + "\n".join(printed))
        self.assertEqual(page_tables.faults_of(page, self.folder, left_out) + page_tables.prose_faults(prose, printed), [], name)

    def test_every_page_is_as_it_says(self):
        for page in self.pages:
            with self.subTest(page.name):
                before = seconds()
                self.run_page(page, checked=page.name in self.ordered)
                commands, pictures = (now - then for now, then in zip(seconds(), before))
                self.assertEqual({name: found for name, found in self.pictures.items() if found}, {})
                print(f"{page.stem:14} {commands:5.1f} s and {pictures:.1f} s for pictures")
        if "KEEP_PICTURES" not in os.environ:
            self.check_the_gallery()

    def check_the_gallery(self):
        """What its pictures say is what the pages draw now."""
        shown = re.findall(r"!\[[^\]]+\]\(\.\./pictures/gallery/(\S+)\)", (PAGES / "gallery.md").read_text())
        self.assertGreaterEqual(len(shown), 10)
        for name in shown:
            # The violation is rounding, which differs from processor to processor.
            stored, now = (re.sub(r"certified: \S+,", "certified: rounding,", Image.open(file).text["Description"]).splitlines()
                           for file in (ROOT / "data/pictures/gallery" / name, Path("demo", name)))
            self.assertEqual(len(stored), len(now), name)
            for before, after in zip(stored, now):
                self.assertTrue(same_line(before, after), f"{name}: '{after}' is drawn, and the gallery has '{before}': tools/makers/gallery makes it again")

    def test_the_notebook_runs_and_prints_what_it_says(self):
        cells = json.loads((PAGES / "first_steps.ipynb").read_text())["cells"]
        names, printed, before = {}, io.StringIO(), os.getcwd()
        os.chdir(PAGES)
        try:
            for cell in cells:
                if cell["cell_type"] == "code":
                    self.assertEqual(cell["outputs"], [], "a stored output grows old")
                    with contextlib.redirect_stdout(printed):
                        exec("".join(cell["source"]), names)
        finally:
            os.chdir(before)
        for words in ("1237.6 MPa, certified: True", "halfspace", "motion.friction"):
            self.assertIn(words, printed.getvalue())

    def test_the_tutorial_up_to_influence_files_is_as_it_says(self):
        page = (ROOT / "data" / "TUTORIAL.md").read_text()
        steps = page[page.index("## 2 "):page.index("## 4 ")]
        self.run_text("TUTORIAL.md", steps.replace("../../data", str(ROOT / "data")).replace("scene.toml", "demo/tutorial.toml"))

    def test_the_scenes_are_as_their_page_says(self):
        self.run_page(ROOT / "data" / "scenes" / "README.md")

    def test_the_page_for_users_of_contact_is_as_it_says(self):
        self.run_page(PAGES / "contact.md")

    def test_every_command_has_a_page(self):
        said = subprocess.run([PROGRAM, "--help"], stdout=subprocess.PIPE, text=True, check=True).stdout
        commands = re.findall(r"^  ([a-z-]+) ", said.split("Subcommands:")[1], re.M)
        self.assertEqual(sorted(commands), sorted(Path(name).stem for name in self.ordered))

    def test_what_the_matlab_page_names_is_there(self):
        """Without Matlab: files, datasets, their numbers and shapes; functions of the header and how many arguments they have."""
        page = (PAGES / "matlab.md").read_text()
        self.run_page(PAGES / "matlab.md")
        code = "".join(re.findall(r"```matlab\n(.*?)```", page, re.S))
        file, read = None, 0
        for line in code.splitlines():
            file = (re.match(r"file = '(.*)'", line) or [None, file])[1]
            for function, group, name in re.findall(r"(h5read|h5readatt)\(file, '(/[\w./]*)'(?:, '(\w+)')?", line):
                read += 1
                with h5py.File(file) as h5:
                    value = h5[group].attrs[name] if function == "h5readatt" else h5[group][()]
                    comment = line.split("%")[1].strip() if "%" in line else ""
                    if indices := re.search(r"\w\((\w+(, \w+)+)\)", comment):  # Matlab's, the other way round
                        of = {"ix": "/x", "is": "/s"} | {name.split(".")[-1]: f"/axes/{name}" for name in h5.get("axes", ())}
                        self.assertEqual(value.shape, tuple(len(h5[of[k]]) for k in reversed(indices[1].split(", "))), line)
                    elif function == "h5readatt" and " " in comment and ":" not in comment:
                        self.assertEqual(value.decode() if isinstance(value, bytes) else value, comment)
                    elif number := re.match(r"\d+", comment):
                        self.assertAlmostEqual(float(value), float(number[0]), delta=1)
        self.assertEqual(read, 11)
        header = re.sub(r"/\*.*?\*/", "", (ROOT / "bem_contact/c/conformal_contact.h").read_text(), flags=re.S)
        calls = re.findall(r"calllib\('conformal', '(\w+)', (.*?)\)(?:\s|$|;)", code)
        self.assertEqual(len(calls), 7)
        for name, arguments in calls:
            declared = re.search(rf"\b{name}\(([^)]*)\)", header)
            self.assertIsNotNone(declared, name)
            self.assertEqual(len(re.sub(r"\([^)]*\)", "", arguments).split(",")), len(declared[1].split(",")), name)
        self.assertIn("#define CONFORMAL_TOTALS 13", header)
        self.assertIn("#define CONFORMAL_PMAX 8", header)

    def test_what_cannot_be_drawn_is_refused(self):
        for line, words in (("bem_contact plot no_such.h5", "there is no such file"), ("bem_contact plot demo", "has no wear.csv"),
                            ("bem_contact plot data/influence/small_rail.h5 demo", "is drawn alone"),
                            ("bem_contact plot data/scenes/wear_in_a_curve.csv", "Draw the HDF5 file"),
                            ("bem_contact plot S1002 -o S1002.txt", "is no picture"), ("bem_contact plot no_such#2", "there is no such file")):
            done = subprocess.run([PROGRAM, *shlex.split(line)[1:]], stderr=subprocess.PIPE, text=True)
            self.assertEqual(done.returncode, 2, line)
            self.assertIn(words, done.stderr)

    def test_pictures_beside_the_pages(self):
        """Kinds of results that no page draws: stresses below, a cylinder that starts to roll, hot friction ..."""
        scenes = ROOT / "data/scenes"
        for name, command in (("stresses", "solve"), ("cattaneo_to_carter", "solve"), ("falling_friction", "solve"),
                              ("persson", "solve"), ("rolling_over_a_grid", "solve"),
                              ("conformal_small", "compare")):
            more = "--models halfspace tangent_plane fem" if command == "compare" else ""
            self.call(f"bem_contact {command} {scenes / name}.toml {more} -o demo/{name}.h5")
            self.call(f"bem_contact plot demo/{name}.h5 -o demo/{name}.png")
            self.assertEqual(self.pictures[f"demo/{name}.png"], [])

    def test_a_picture_that_cannot_be_read_is_found(self):
        from bem_contact.plotting import style
        figure, axes = style.panels(1, 1, (4, 3))
        axes[0, 0].plot([0, 1], [0, 1], "o", label="under")
        axes[0, 0].legend(loc="lower left")
        axes[0, 0].text(0.5, 0.5, "words on")
        self.assertEqual(picture_faults.faults(figure), ["1 marks under the legend of ''"])
        axes[0, 0].text(0.52, 0.52, "words")
        self.assertIn("'words on' lies on 'words'", picture_faults.faults(figure))
        axes[0, 0].set(xlabel="largest pressure of hollow_wheel.txt, MPa", ylabel="free_rolling_xi")
        self.assertIn("'free_rolling_xi' has a name of the files", picture_faults.faults(figure))
        self.assertFalse(any("largest pressure" in fault for fault in picture_faults.faults(figure)))

    def test_a_wrong_number_is_found(self):
        self.assertTrue(same_line("pmax 12.25 MPa, ... holds", "pmax 12.26 MPa, worst 3e-9, it holds"))
        for other in ("pmax 12.4 MPa, it holds", "pmax 12.25 N, it holds", "pmax 12.25 MPa, it fails"):
            self.assertFalse(same_line("pmax 12.25 MPa, ... holds", other))

    def test_a_wrong_number_in_prose_is_found(self):
        printed = ["pmax 1237.55 MPa, 0.1740 of it"]
        self.assertEqual(page_tables.prose_faults("Run it. You should see 1238 MPa in 2 patches and .174, as `99.99` says. Not 555 MPa.", printed), [])
        self.assertEqual(len(page_tables.prose_faults("You should see a pressure of 1257 MPa,\nand 0.174.", printed)), 1)

    def test_a_wrong_number_in_a_table_is_found(self):
        Path("demo/right.csv").write_text("lateral,pmax,low,high\n0.5,1756.1,3,7\n1,2000,4,4\n")
        table = "| lateral | pmax | patches |\n|---|---|---|\n| 0.50 | 1756 MPa | 3 to 7 |\n| 1 | 2000 | 4 |\n"
        say = "<!-- numbers of demo/right.csv: lateral, pmax, low/high -->\n"
        self.assertEqual(page_tables.faults_of(say + table, self.folder), [])
        for wrong in (("1756", "1856"), ("3 to 7", "3 to 8"), ("| 1 |", "| 2 |"), ("| 2000 |", "| - |")):
            self.assertEqual(len(page_tables.faults_of(say + table.replace(*wrong), self.folder)) > 0, True, wrong)
        self.assertIn("no comment", page_tables.faults_of(table, self.folder)[0])
        self.assertEqual(page_tables.faults_of("<!-- not compared: measured -->\n" + table, self.folder), [])


if __name__ == "__main__":
    unittest.main()
