"""What bem_contact.plotting computes: limits of the shakedown diagram against closed forms and known numbers; numbers of tables in words.

Damaged files are drawn or refused.
"""

import ast
import contextlib
import io
import json
import os
import re
import runpy
import shutil
import subprocess
import sys
import tempfile
import unittest
import xml.dom.minidom
from pathlib import Path
from unittest import mock

import h5py
import numpy as np

import bem_contact
from bem_contact.plotting import bodies, command, influence, meshes, results, shakedown, style

TOOLS = Path(__file__).resolve().parents[2] / "tools"
PROGRAM = os.environ["BEM_CONTACT"]

class Doors(unittest.TestCase):
    """One picture, whoever asks for it."""

    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.folder = Path(cls.temporary.name)
        cls.result = bem_contact.solve(TOOLS.parent / "data" / "scenes" / "hertz.toml")
        cls.file = cls.folder / "hertz.h5"
        cls.result.save(cls.file)

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    def call(self, *words, **more):
        return subprocess.run([*map(str, words)], capture_output=True, text=True, cwd=self.folder,
                              env={name: value for name, value in os.environ.items() if name != "PYTHONPATH"} | more)

    def test_the_program_the_tool_and_python_draw_the_same(self):
        figure = self.result.plot(self.folder / "result.svg")
        self.assertEqual(len(figure.axes), 5)
        self.assertIsNone(bem_contact.plot(self.file).canvas.manager, "no window")
        bem_contact.plot(self.file, self.folder / "file.svg")
        for words, name in (((PROGRAM, "plot"), "program"), ((TOOLS / "plot",), "tool")):
            done = self.call(*words, self.file, "-o", f"{name}.svg", CONFORMAL_BIN=str(Path(PROGRAM).parent))
            self.assertEqual((done.returncode, done.stdout), (0, ""), done.stderr)
        done = self.call(sys.executable, "-m", "bem_contact", "plot", self.file, PYTHONPATH=os.environ["PYTHONPATH"])
        self.assertEqual((done.returncode, done.stderr), (0, "hertz.png written\n"))
        texts = {name: re.findall(r"<!-- (.*?) -->", (self.folder / f"{name}.svg").read_text()) for name in ("result", "file", "program", "tool")}
        self.assertGreater(len(texts["result"]), 40)
        for name, found in texts.items():
            self.assertEqual(found, texts["result"], name)

    def test_profiles_take_the_options_of_the_command_profile(self):
        wheel = TOOLS.parent / "data" / "bodies" / "hollow_wheel.txt"
        for words in ((wheel, "S1002", "-o", "w.png", "--kind", "wheel"), (wheel, "--kind", "wheel", "--smoothing", "8", "-o", "w.png")):
            done = self.call(PROGRAM, "plot", *words)
            self.assertEqual((done.returncode, done.stderr.splitlines()[-1]), (0, "w.png written"))
        figure = bem_contact.plot(wheel, others=["S1002"], options=["--kind", "wheel"])
        self.assertEqual(figure.axes[0].get_legend_handles_labels()[1], ["S1002", "hollow_wheel.txt"])
        with self.assertRaisesRegex(bem_contact.InputError, "--kind"):
            bem_contact.plot(wheel, options=["--kind", "sleeper"])

    def test_what_cannot_be_drawn_raises_or_ends_with_2(self):
        for words, told in (((), "no file is named"), (("none.h5",), "there is no such file"), ((self.file, "-o", "x.txt"), "is no picture")):
            done = self.call(PROGRAM, "plot", *words)
            self.assertEqual(done.returncode, 2)
            self.assertRegex(done.stderr, rf"\Aerror: .*{told}.*\n\Z")
        with self.assertRaisesRegex(bem_contact.InputError, "there is no such file"):
            bem_contact.plot(self.folder / "none.h5")
        with self.assertRaisesRegex(bem_contact.InputError, "is no picture"):
            self.result.plot(self.folder / "x.txt")
        with self.assertRaisesRegex(bem_contact.InputError, "is drawn alone"):
            bem_contact.plot(self.file, others=["S1002"])

    def test_a_missing_library_is_named_with_its_package(self):
        for module in ("matplotlib", "h5py"):
            folder = self.folder / f"without_{module}"
            folder.mkdir()
            (folder / f"{module}.py").write_text(f"raise ModuleNotFoundError(name={module!r})\n")
            done = self.call(PROGRAM, "plot", self.file, PYTHONPATH=str(folder))
            self.assertEqual(done.returncode, 2)
            self.assertRegex(done.stderr, rf"\Aerror: .* has no module {module}\) .* apt-get install python3-{module}\n\Z")

    def test_pictures_need_no_compiled_part(self):
        package = TOOLS.parent / "bem_contact" / "python"
        done = self.call(sys.executable, "-B", "-m", "bem_contact.plotting", self.file, "-o", "source.png", PYTHONPATH=str(package))
        self.assertEqual((done.returncode, done.stderr), (0, "source.png written\n"))
        done = self.call(sys.executable, "-B", "-c", "from bem_contact import solve", PYTHONPATH=str(package))
        self.assertIn("ImportError: the compiled part of bem_contact is missing", done.stderr)

    def test_help_stands_wherever_it_is_asked_for(self):
        whole = self.call(PROGRAM, "plot", "--help")
        self.assertIn("You should see", whole.stdout)
        for words in ((self.file, "--help"), ("S1002", "--kind", "wheel", "--help")):
            self.assertEqual(self.call(PROGRAM, "plot", *words).stdout, whole.stdout)

class Stresses(unittest.TestCase):
    def test_equilibrium(self):
        """The divergence is zero inside, by differences."""
        rng, h = np.random.default_rng(3), 1e-4
        x, z = rng.uniform(-1.4, 1.4, 50), rng.uniform(0.1, 1.4, 50)
        for mu in (0, 0.3, 1):
            of = lambda x, z: np.array(shakedown.line_stresses(x, z, mu))
            along, down = (of(x + h, z) - of(x - h, z)) / (2 * h), (of(x, z + h) - of(x, z - h)) / (2 * h)
            np.testing.assert_allclose(along[0] + down[2], 0, atol=1e-5)
            np.testing.assert_allclose(along[2] + down[1], 0, atol=1e-5)

    def test_surface(self):
        """Hertz's pressure and mu times it within the contact, nothing beside it. A traction along +x compresses in front (x = 1) by 2 mu."""
        x, mu = np.linspace(-1.4, 1.4, 57), 0.2
        xx, zz, xz = shakedown.line_stresses(x, np.zeros_like(x), mu)
        pressure = np.sqrt(np.maximum(1 - x**2, 0))
        np.testing.assert_allclose(zz, -pressure, atol=1e-9)
        np.testing.assert_allclose(np.abs(xz), mu * pressure, atol=1e-9)
        np.testing.assert_allclose(xx[np.abs(x) < 0.99], (-pressure - 2 * mu * x)[np.abs(x) < 0.99], atol=1e-9)

    def test_below_the_middle(self):
        """Johnson 1985, eq. 4.46, on x = 0."""
        z = np.linspace(0, 1.4, 15)
        xx, zz, xz = shakedown.line_stresses(0 * z, z, 0)
        np.testing.assert_allclose(zz, -1 / np.sqrt(1 + z**2))
        np.testing.assert_allclose(xx, -((1 + 2 * z**2) / np.sqrt(1 + z**2) - 2 * z), atol=1e-12)
        np.testing.assert_allclose(xz, 0, atol=1e-12)

class Limits(unittest.TestCase):
    def test_without_friction(self):
        """The shear along the surface is p0/4 at most (x = sqrt(3)/2, z = 1/2); the elastic limit is that of Johnson 1985, section 6.1."""
        self.assertAlmostEqual(abs(shakedown.line_stresses(np.sqrt(0.75), 0.5, 0)[2]), 0.25, 12)
        self.assertAlmostEqual(shakedown.shakedown_limit(0), 4, 3)
        self.assertAlmostEqual(shakedown.elastic_limit(0), 3.1, 1)

    def test_much_friction(self):
        for mu in (0.37, 0.4, 0.6):
            self.assertAlmostEqual(shakedown.shakedown_limit(mu) * mu, 1, 9)

    def test_where_the_surface_takes_over(self):
        """mu = 0.367 (Johnson and Jefferis 1963)."""
        self.assertLess(shakedown.shakedown_limit(0.365), 0.999 / 0.365)
        self.assertAlmostEqual(shakedown.shakedown_limit(0.368) * 0.368, 1, 9)

    def test_order(self):
        """Steel flows before it ceases to shake down, and friction lowers both limits."""
        elastic, shaken = ([limit(mu) for mu in np.linspace(0, 0.6, 25)] for limit in (shakedown.elastic_limit, shakedown.shakedown_limit))
        self.assertTrue((np.array(elastic) < shaken).all())
        for limits in (elastic, shaken):
            self.assertTrue((np.diff(limits) < 0).all())

class Meshes(unittest.TestCase):
    """Sections and influence files: what is drawn is what the file says."""

    def test_quality_of_known_quadrilaterals(self):
        points = np.array([[0, 0], [1, 0], [1, 1], [0, 1], [2, 0.0], [1.5, np.sqrt(0.75)], [0.5, np.sqrt(0.75)]])
        mesh = meshes.Mesh("m", points, np.array([[0, 1, 2, 3], [3, 2, 1, 0], [0, 1, 5, 6]]), {})  # a square both ways, a rhombus
        np.testing.assert_allclose(mesh.scaled_jacobian(), (1, 1, np.sqrt(0.75)), atol=1e-12)
        two = meshes.Mesh("m", np.array([[0, 0], [1, 0], [1, 1], [0, 1], [2, 0], [2, 1]]), np.array([[0, 1, 2, 3], [1, 4, 5, 2]]), {})
        self.assertEqual(len(two.border()), 6)
        self.assertEqual([meshes.quality(worst).split(":")[0] for worst in (0.5, 0.2, 0.01)], ["good", "usable", "poor"])

    def test_a_mesh_is_placed_where_its_profile_lies(self):
        arc = np.linspace(0.2, 1.9, 60)
        profile = np.stack((30 * np.cos(arc), 22 * np.sin(arc)), axis=1)
        strip = np.arange(59)
        mesh = meshes.Mesh("m", profile, np.zeros((0, 4), int), {"contact": np.stack((strip, strip + 1), axis=1)})
        moved = profile @ bodies.turned(0.03).T + (700, -3)
        placed = bodies.place(mesh, moved, "rail", (700.5, -2.5))
        self.assertLess(np.abs(placed.points - moved).max(), 5e-3)  # far below a line of the picture
        with self.assertRaisesRegex(bem_contact.InputError, "mm from the profile of the rail"):
            bodies.place(mesh, np.array([[700, 0], [700, 40.0]]), "rail", (700, 0))

    def test_a_half_space_far_away_and_below_the_load(self):
        far, own = influence.on_half_space([50, 0], 0.5, 82000, 0.28)
        self.assertAlmostEqual(far / (0.72 * 0.25 / (2 * np.pi * 82000 * 50)), 1, delta=1e-4)  # Boussinesq's point force
        self.assertAlmostEqual(own / (0.72 / (2 * np.pi * 82000) * 2.9732 * 0.5), 1, delta=1e-2)  # mean of midpoints; Love's square

    def test_an_influence_file(self):
        figure = bem_contact.plot(TOOLS.parent / "data" / "influence" / "small_rail.h5")
        strip, answer = figure.axes
        self.assertEqual(len(strip.lines[0].get_xdata()), 48)
        middle, half_space = answer.lines[1].get_ydata(), answer.lines[3].get_ydata()
        self.assertEqual(middle.argmax(), half_space.argmax())
        self.assertAlmostEqual(middle.max() / half_space.max(), 1, delta=0.02)
        self.assertIn("estimated error 0.2 %", answer.get_title(loc="left"))

    @unittest.skipUnless((Path(PROGRAM).parent / "mesh_body").exists(), "needs mesh_body")
    def test_bodies_and_their_contact(self):
        data = TOOLS.parent / "data"
        with tempfile.TemporaryDirectory() as folder:
            names = {}
            for body in ("rail_60E1_gauge_corner", "wheel_S1002_flange_root"):
                names[body] = Path(folder) / f"{body}.msh"
                subprocess.run([Path(PROGRAM).parent / "mesh_body", data / "bodies" / f"{body}.toml", "-o", names[body]], check=True,
                               stderr=subprocess.DEVNULL)
            figure = bem_contact.plot(data / "bodies" / "rail_60E1_gauge_corner.toml")
            self.assertRegex(figure.axes[1].get_title(loc="left"), r"worst scaled Jacobian 0\.\d\d \(good: above 0.3\)")
            self.assertEqual([text.get_text() for text in figure.axes[0].get_legend().get_texts()],
                             ["contact strip: unit tractions act here", "held: displacement zero"])
            result = Path(folder) / "r.h5"
            r = bem_contact.solve(data / "scenes" / "conformal_small.toml")
            r.save(result)
            figure = bem_contact.plot(result, others=[*names.values()])
            self.assertIn(f"{r.pmax:.0f} MPa", figure.get_suptitle() if hasattr(figure, "get_suptitle") else figure._suptitle.get_text())
            section, space = figure.axes
            faces = sum(len(collection.get_facecolor()) for collection in space.collections)
            self.assertGreater(faces, 1500)
            bem_contact.plot(result, Path(folder) / "r.png", others=[*names.values()])
            with self.assertRaisesRegex(bem_contact.InputError, "from the profile of the rail"):
                bem_contact.plot(result, others=[*reversed(names.values())])
            with self.assertRaisesRegex(bem_contact.InputError, "it is a scene"):
                bem_contact.plot(data / "scenes" / "hertz.toml")
            with self.assertRaisesRegex(bem_contact.InputError, "a contact has two bodies"):
                bem_contact.plot(result, others=[names["rail_60E1_gauge_corner"]])
            broken = Path(folder) / "broken.msh"
            broken.write_bytes(names["rail_60E1_gauge_corner"].read_bytes()[:9000])
            with self.assertRaisesRegex(bem_contact.InputError, "no whole mesh"):
                bem_contact.plot(broken)

class Numbers(unittest.TestCase):
    def test_digits_follow_the_error(self):
        for value, error, wanted in ((1858.23, 3.2, "1858 ± 3"), (-0.0281, 4.0, "0 ± 4"), (100000, np.nan, "100000"), (1e-9, 1e-11, "0"),
                                     (np.nan, 1, "–"), (-1.785, 5.9e-3, "-1.785 ± 0.006")):
            self.assertEqual(results.with_error(value, error), wanted)

    def test_differences(self):
        """Relative of pressures and areas, else in the unit, with the digits that the errors leave; none of approaches."""
        for name, unit, values, errors, wanted in (
                ("pmax", "MPa", (1881.64, 1858.23), (3.3, 3.2), "-1.24 %"), ("area", "mm2", (50, 51), (np.nan, np.nan), "+2.00 %"),
                ("Fy", "N", (38188.44, 38188.40), (75, 64), "0"), ("Mz", "N mm", (-59223.99, -57020.28), (266, 224), "+2204"),
                ("approach", "mm", (0.137, 0.124), (1e-4, 1e-4), "–"), ("lateral", "mm", (6.62167, 6.6), (3.8e-4, np.nan), "-0.0217"),
                ("Fz", "N", (1e5, 1e5), (np.nan, np.nan), "0")):
            self.assertEqual(results.difference(name, unit, values, errors), wanted, name)

    def test_words_and_degrees(self):
        self.assertEqual(style.titled("pmax", "MPa"), "largest pressure, MPa")
        self.assertEqual(style.titled("free_rolling_xi", "1"), "creepage of free rolling")
        self.assertEqual(style.valued(0.0025, "rad"), "0.0025 rad (0.143°)")
        self.assertEqual(style.valued(60000, "N"), "60000 N")

    def test_pages_say_what_pictures_say(self):
        with tempfile.TemporaryDirectory() as folder:
            page = Path(folder) / "page.html"
            subprocess.run([os.environ["BEM_CONTACT"], "profile", "60E1", "--plot", page], check=True, stdout=subprocess.PIPE)
            text = page.read_text()
        shared = json.loads((TOOLS.parent / "bem_contact" / "record" / "words.json").read_text())
        self.assertIn(shared["words"]["pmax"], text)
        self.assertEqual(shared["words"], style.WORDS)
        self.assertEqual({name: (words["title"], words["short"]) for name, words in shared["models"].items()},
                         {name: found[:2] for name, found in style.MODELS.items()})
        self.assertEqual(list(style.LINES), list(style.MODELS), "a model without a line of its own")

def tool(name, *arguments, told=None):
    """The exit code of a tool, or of `bem_contact plot`, in this process: a start takes a second. A traceback is an error of the test."""
    told = told or io.StringIO()
    with mock.patch.object(sys, "argv", [name, *map(str, arguments)]), contextlib.redirect_stderr(told):
        try:
            command.main() if name == "plot" else runpy.run_path(str(TOOLS / name), run_name="__main__")
        except SystemExit as end:
            return end.code
    return 0

class DamagedFiles(unittest.TestCase):
    SWEEP = """kind = "patch"
motion = { friction = 0.3, xi = 1e-3 }
solver.model = "halfspace"
gap = { a = 1e-3, b = 2e-3 }
grid = { dx = 0.8, ds = 0.8, mx = 12, ms = 12 }
sweep.load.force = [1e3, 2e3]
"""

    def test_a_sweep_of_which_a_dataset_is_too_short_or_gone(self):
        with tempfile.TemporaryDirectory() as temporary:
            folder = Path(temporary)
            whole, file, picture = folder / "whole.h5", folder / "sweep.h5", folder / "s.png"
            (folder / "sweep.toml").write_text(self.SWEEP)
            subprocess.run([PROGRAM, "sweep", folder / "sweep.toml", "-o", whole], check=True, capture_output=True)
            self.assertEqual(tool("plot", whole, "-o", picture), 0)
            for name in ("status", "load.force", "Fx", "patches/y"):
                for gone in (False, True):
                    with self.subTest(dataset=name, gone=gone):
                        shutil.copy(whole, file)
                        with h5py.File(file, "r+") as opened:
                            data, attributes = opened[name][()], dict(opened[name].attrs)
                            del opened[name]
                            if not gone:
                                opened[name] = data[:-1]
                                opened[name].attrs.update(attributes)
                        self.assertIn(tool("plot", file, "-o", picture), (0, 2))

    def test_numbers_that_lie_elsewhere_or_are_not_whole(self):
        with tempfile.TemporaryDirectory() as temporary:
            whole, file, picture, pipe = (Path(temporary) / name for name in ("whole.h5", "c.h5", "c.png", "pipe"))
            os.mkfifo(pipe)  # to open it would wait

            def short(opened):
                data = opened.create_dataset("lateral", (9,), "f8", chunks=(9,), fletcher32=True)
                data.id.write_direct_chunk((0,), b"xy")

            with h5py.File(whole, "w") as opened:
                opened.attrs["format"] = "bem_contact sweep 2"
                opened["itself"] = opened["/"]
            for how in (lambda h5: h5.create_dataset("lateral", (9,), "f8", external=[(str(pipe), 0, 72)]),
                        lambda h5: h5.create_dataset("lateral", (10**10,), "f8", fillvalue=1.0),
                        lambda h5: h5.create_dataset("lateral", (10**10,), "f8", chunks=(1000,), compression="gzip"), short,
                        lambda h5: h5.__setitem__("lateral", h5py.ExternalLink(str(pipe), "x"))):
                shutil.copy(whole, file)
                with h5py.File(file, "r+") as opened:
                    how(opened)
                self.assertEqual(tool("plot", file, "-o", picture), 2)
                self.assertFalse(picture.exists())

class Results(unittest.TestCase):
    """tools/paraview and bem_contact plot on a result: what they write over, names, and damaged files."""

    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.folder = Path(cls.temporary.name)
        cls.result = cls.folder / "r.h5"
        scene = TOOLS.parent / "data" / "scenes" / "stresses.toml"
        subprocess.run([PROGRAM, "solve", scene, "-o", cls.result], check=True, capture_output=True)

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    def refused(self, words, *arguments):
        told = io.StringIO()
        self.assertEqual(tool(*arguments, told=told), 2, told.getvalue())
        self.assertRegex(told.getvalue(), r"^error: .+ \(.+\) \S.*\n$")
        self.assertIn(words, told.getvalue())
        return told.getvalue()

    def copy(self, name):
        return Path(shutil.copy(self.result, self.folder / name))

    def test_nothing_of_the_user_is_overwritten(self):
        script = self.folder / "analysis.py"
        script.write_text("# my own script\n")
        self.refused("no state of ParaView", "paraview", self.result, "-o", self.folder / "analysis.vtm")
        self.assertEqual(script.read_text(), "# my own script\n")
        self.assertFalse((self.folder / "analysis.vtm").exists())
        state, picture, surface = self.copy("pw.py"), self.copy("pp.png"), self.folder / "in" / "contact.vts"
        surface.parent.mkdir()
        shutil.copy(self.result, surface)
        link = self.folder / "link.h5"
        link.symlink_to(picture)
        self.refused("", "paraview", state, "-o", self.folder / "pw.vtm")
        self.refused("would overwrite", "paraview", surface, "-o", self.folder / "in.vtm")
        self.refused("would overwrite", "plot", picture, "-o", picture)
        self.refused("would overwrite", "plot", link, "-o", picture)
        for file in (state, picture, surface):
            self.assertEqual(file.read_bytes(), self.result.read_bytes())
        again = self.folder / "again.vtm"
        self.assertEqual([tool("paraview", self.result, "-o", again) for _ in range(2)], [0, 0])  # its own state it replaces

    def test_any_name_is_a_name(self):
        for name in ('a"b', "a<&b", "it's", "{x}", "back\\slash", "weiß"):
            with self.subTest(name):
                self.assertEqual(tool("paraview", self.result, "-o", self.folder / f"{name}.vtm"), 0)
                state = (self.folder / f"{name}.py").read_text(encoding="utf-8")
                texts = [node.value for node in ast.walk(ast.parse(state)) if isinstance(node, ast.Constant)]
                self.assertIn(name, texts)
                parts = xml.dom.minidom.parse(str(self.folder / f"{name}.vtm")).getElementsByTagName("DataSet")
                self.assertEqual(parts[0].getAttribute("file"), f"{name}/contact.vts")
        self.refused("no such characters", "paraview", self.result, "-o", self.folder / "a\nimport os.vtm")
        message = self.refused("too long", "paraview", self.result, "-o", self.folder / ("a" * 300 + ".vtm"))
        self.assertLess(len(message), 400)
        self.refused("too long", "plot", self.result, "-o", self.folder / ("a" * 300 + ".png"))
        self.refused("No such file", "paraview", self.result, "-o", self.folder / "none" / "a.vtm")

    def damaged(self, file, change):
        shutil.copy(self.result, file)
        with h5py.File(file, "r+") as opened:
            change(opened, opened)

    def test_a_damaged_result_is_refused(self):
        def put(group, name, value):
            del group[name]
            group[name] = value

        def remove(group, name):
            del group[name]

        file, whole = self.folder / "damaged.h5", self.result.read_bytes()
        both, one = (("paraview", "w.vtm"), ("plot", "w.png")), (("paraview", "w.vtm"),)
        for change, tools in (
                (lambda f, m: put(m, "p_n", np.ones((3, 3))), both), (lambda f, m: put(m, "p_n", "text"), both),
                (lambda f, m: remove(f, "state"), both), (lambda f, m: put(f, "quantities", np.ones(7)), both),
                (lambda f, m: put(f, "x", 3.0), both), (lambda f, m: remove(f, "s"), both),
                (lambda f, m: put(f, "s", np.zeros(0)), both), (lambda f, m: remove(f, "quantities/dx"), both),
                (lambda f, m: put(f, "quantities/dx", "x"), both), (lambda f, m: f.attrs.update(format=3), both),
                (lambda f, m: put(m, "stresses/stress", np.ones(7)), one), (lambda f, m: put(f, "rail_profile", np.ones(7)), one),
                (lambda f, m: put(m, "patches", np.ones(3)), one), (lambda f, m: put(f, "scene_with_defaults", np.ones(3)), one)):
            self.damaged(file, change)
            for name, output in tools:
                with self.subTest(name):
                    self.refused("damaged.h5", name, file, "-o", self.folder / output)
        for length in (100, len(whole) // 2):
            file.write_bytes(whole[:length])
            for name, output in both:
                self.refused("damaged.h5", name, file, "-o", self.folder / output)

if __name__ == "__main__":
    unittest.main()
