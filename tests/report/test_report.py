"""`bem_contact report`: what is in the page is what is in the file, and a browser draws it without an error."""

import json
import os
import re
import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path
from xml.etree import ElementTree

import h5py
import numpy as np
from matplotlib.image import imread

import browser

LOOK = Path(__file__).with_name("look.js").read_text()
ROOT = Path(__file__).resolve().parents[2]
SCENES, TOOLS = ROOT / "data" / "scenes", ROOT / "tools"
PATCH = """kind = "patch"
load.force = 4000
motion = { friction = 0.3, xi = 4e-4, eta = 3e-4, phi = 1e-4 }
grid = { dx = 0.4, ds = 0.4, mx = 20, ms = 14 }
gap = { a = 1e-3, b = 2e-3 }
stresses = { x = [0.0], s = [-1.0, 0.0, 1.0], depths = [0.5, 1.0, 2.0] }
"""
WEAR = """rail.profile = "60E1"
wheel.profile = "S1002"
solver.model = "halfspace"
load.force = 8e4
motion = { xi = 2e-3, free_rolling = false }
grid = { dx = 1, ds = 0.5 }
sweep.position.lateral = [0.0, 1.0]
"""
TABLE = WEAR.replace("sweep.position.lateral = [0.0, 1.0]", "[table]\nposition.lateral = [0.0, 1.0]\nload.force = [7e4, 8e4]\nhold = ['Fx', 'pmax']")
SQUARE = """$MeshFormat
4.1 0 8
$EndMeshFormat
$PhysicalNames
3
1 1 "contact"
1 2 "held"
2 10 "body"
$EndPhysicalNames
$Entities
0 2 1 0
1 0 0 0 2 0 0 1 1 0 
2 0 1 0 2 1 0 1 2 0 
10 0 0 0 2 1 0 1 10 0 
$EndEntities
$Nodes
1 6 1 6
2 10 0 6
1
2
3
4
5
6
0 0 0
1 0 0
2 0 0
0 1 0
1.5 1 0
2 1 0
$EndNodes
$Elements
3 6 1 6
1 1 1 2
1 1 2 
2 2 3 
1 2 1 2
3 4 5 
4 5 6 
2 10 3 2
5 1 2 5 4 
6 2 3 6 5 
$EndElements
"""  # two quadrilaterals; the sharpest corner has tan = 2
STUDY = WEAR.replace("sweep.position.lateral = [0.0, 1.0]", "[fatigue]\n[wear]\n[conicity]\nto = 3")


def program(*arguments):
    return subprocess.run([os.environ["BEM_CONTACT"], *map(str, arguments)], stdout=subprocess.PIPE,
                          stderr=subprocess.PIPE, text=True)


class Report(unittest.TestCase):
    warned = ("result", "comparison", "wheelset")  # pages of these have warnings

    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.folder = Path(cls.temporary.name)
        (cls.folder / "patch.toml").write_text(PATCH + "# </script><!--\n")
        (cls.folder / "wear.toml").write_text(WEAR)
        (cls.folder / "wheelset.toml").write_text((SCENES / "wheelset.toml").read_text().replace("[wheelset]", "[wheelset]\nleft_wheel_radius = 459.5"))
        patch = cls.folder / "patch.toml"
        cls.files = {kind: cls.folder / f"{kind}.h5" for kind in ("result", "stresses", "cylinder", "comparison", "curves", "sweep", "cases", "along",
                                                                   "conicity", "wheelset")}
        cls.files["wear"] = cls.folder / "worn" / "wear.h5"
        cls.files |= {kind: cls.folder / f"{kind}.h5" for kind in ("fatigue", "inside", "shakedown", "collective", "rates", "table", "map", "axle_rates", "fit")}
        cls.files["study"] = cls.folder / "study" / "study.h5"
        cls.files["influence"] = ROOT / "data" / "influence" / "small_rail.h5"
        (cls.folder / "points.csv").write_text("xi,Fx,scatter\n1e-3,500,40\n2e-3,700,50\n3e-3,900,60\n")
        (cls.folder / "table.toml").write_text(TABLE)
        (cls.folder / "study.toml").write_text(STUDY)
        for command in (("solve", SCENES / "conformal_small.toml", "-o", cls.files["result"]),
                        ("compare", SCENES / "conformal_small.toml", "--models", "halfspace", "tangent_plane", "fem", "-o",
                         cls.files["comparison"]),
                        ("solve", patch, "-o", cls.files["stresses"]),
                        ("solve", SCENES / "cattaneo_to_carter.toml", "-o", cls.files["cylinder"]),
                        ("creep-curves", patch, "--xi=0:4e-3:5", "--phi=0:1e-3:3", "--measured", cls.folder / "points.csv", "-o", cls.files["curves"]),
                        ("fit", patch, "--measured", cls.folder / "points.csv", "--parameters", "motion.friction", "-o", cls.files["fit"]),
                        ("sweep", SCENES / "cases_two_areas.toml", "-o", cls.files["sweep"]),
                        ("sweep", cls.folder / "wear.toml", "-o", cls.files["cases"]),
                        ("sweep", SCENES / "rail_sections.toml", "-o", cls.files["along"]),
                        ("conicity", SCENES / "wheelset.toml", "-o", cls.files["conicity"]),
                        ("wheelset", cls.folder / "wheelset.toml", "-o", cls.files["wheelset"]),
                        ("fatigue", cls.folder / "wear.toml", "-o", cls.files["fatigue"]),
                        ("shakedown", SCENES / "steady_rolling.toml", "-o", cls.files["shakedown"]),
                        ("shakedown", cls.folder / "wear.toml", "--steel", "R260", "-o", cls.files["collective"]),
                        ("stresses", cls.files["result"], "-o", cls.files["inside"]),
                        ("wear", cls.folder / "study.toml", "-o", cls.files["rates"]),
                        ("wear", SCENES / "wheelset.toml", "-o", cls.files["axle_rates"]),
                        ("table", cls.folder / "table.toml", "--tolerance", "0.2", "-o", cls.files["table"]),
                        ("conicity", "--wheels", "S1002", "LMA", "--rails", "60E1", "--rail-inclination", "0.025", "--gauges", "1434:1436:3",
                         "--noise", "0.005", "--draws", "3", "-o", cls.files["map"]),
                        ("study", cls.folder / "study.toml", "-o", cls.folder / "study"),
                        ("wear", cls.folder / "wear.toml", "-o", cls.folder / "worn", "--depth", "0.03")):
            done = program(*command)
            assert done.returncode in (0, 3), (command, done.stderr)
        cls.pages = {}
        for kind, file in cls.files.items():
            cls.pages[kind] = cls.folder / f"{kind}.html"
            done = program("report", file, "-o", cls.pages[kind])
            assert done.returncode == 0, (kind, done.stderr)
        cls.pages["mesh"] = cls.folder / "mesh.html"
        (cls.folder / "square.msh").write_text(SQUARE)
        done = program("report", cls.folder / "square.msh", "-o", cls.pages["mesh"])
        assert done.returncode == 0, done.stderr
        cls.pages["profile"] = cls.folder / "profile.html"
        cls.profile = program("profile", ROOT / "data" / "bodies" / "hollow_wheel.txt", "--kind", "wheel", "--smoothing", 8, "--plot",
                              cls.pages["profile"])
        assert cls.profile.returncode == 0, cls.profile.stderr
        cls.pages["sections"] = cls.folder / "sections.html"
        done = program("profile", SCENES / "rail_sections.toml", "--plot", cls.pages["sections"])
        assert done.returncode == 0, done.stderr

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    def report_of(self, kind):
        text = self.pages[kind].read_text()
        return json.loads(re.search(r'<script type="application/json" id="data">(.*?)</script>', text, re.DOTALL)[1])

    def test_the_page_has_the_numbers_of_the_file(self):
        for kind, file in self.files.items():
            data, compared = self.report_of(kind)["data"], 0
            with h5py.File(file) as h5:
                def compare(name, item):
                    nonlocal compared
                    at = data
                    for part in name.split("/"):
                        at = at.get(part, {}) if isinstance(at, dict) else {}
                    if isinstance(item, h5py.Dataset) and item.dtype.kind == "f" and "values" in at:
                        values = np.array(at["values"], dtype=float).reshape(at["shape"])
                        self.assertTrue(np.array_equal(values, item[()], equal_nan=True), (kind, name))
                        self.assertEqual(at["unit"], item.attrs["unit"].decode(), (kind, name))
                        compared += 1
                h5.visititems(compare)
            self.assertGreater(compared, 0 if kind == "influence" else 10, kind)  # of influence functions the stations alone
        self.assertEqual(set(self.report_of("result")["data"]) & {"p_n", "u_x", "quantities"}, {"p_n", "quantities"})
        self.assertIn("</script><!--", self.report_of("stresses")["data"]["scene_text"]["text"])
        step, worn = max(self.report_of("wear")["steps"].items(), key=lambda one: int(one[0]))
        rail = np.reshape(worn["rail"]["values"], worn["rail"]["shape"])
        np.testing.assert_array_equal(rail, np.loadtxt(self.folder / "worn" / f"rail_{int(step):04}.txt"))

    def test_a_page_of_a_profile_has_its_points_and_the_standard(self):
        page = self.report_of("profile")["data"]
        self.assertEqual(page["attributes"]["words"], self.profile.stdout)
        profiles = list(page["profiles"].values())
        self.assertEqual([p["attributes"]["name"] for p in profiles], ["hollow_wheel.txt", "hollow_wheel.txt, as measured", "S1002"])
        table = self.folder / "profile.csv"
        self.assertEqual(program("profile", "S1002", "--on", ROOT / "data" / "bodies" / "hollow_wheel.txt", "--smoothing", 8,
                                 "--csv", table, "--plot", self.folder / "standard.html").returncode, 0)
        _, y, z, _, curvature, _ = np.loadtxt(table, delimiter=",", skiprows=1, unpack=True)
        for name, column in (("y", y), ("z", z), ("curvature", curvature)):
            np.testing.assert_allclose(profiles[2][name]["values"], column, rtol=1e-7, atol=1e-6)
        depth = np.subtract(profiles[0]["z"]["values"], profiles[1]["z"]["values"])
        self.assertTrue(0 < np.abs(depth).max() < 0.05)  # mm that smoothing moved
        refused = program("profile", "S1002", "--plot", self.folder / "none" / "page.html")
        self.assertEqual(refused.returncode, 2)
        self.assertIn("none", refused.stderr)

    def test_pages_of_sections_have_the_points_that_correspond(self):
        """The page of the sections and that of a sweep over them have the same lines, which are those of the CSV table."""
        table = self.folder / "lines.csv"
        self.assertEqual(program("profile", SCENES / "rail_sections.toml", "--csv", table).returncode, 0)
        columns = np.loadtxt(table, delimiter=",", skiprows=1, unpack=True)
        for kind in ("sections", "along"):
            lines = self.report_of(kind)["data"]["section_lines"]
            for name, column in zip(("body", "t", "line", "section", "u", "y", "z"), columns):
                np.testing.assert_allclose(lines[name]["values"], column, rtol=1e-5, atol=1e-6)
        self.assertNotIn("section_lines", self.report_of("cases")["data"])

    def test_python_writes_the_same_page(self):
        import bem_contact
        page = self.folder / "python.html"
        bem_contact.report(self.files["result"], page)
        self.assertEqual(page.read_bytes(), self.pages["result"].read_bytes())
        with self.assertRaisesRegex(bem_contact.InputError, "no_such.h5"):
            bem_contact.report(self.folder / "no_such.h5", page)

    def test_the_files_for_paraview(self):
        vtm = self.folder / "in_space.vtm"
        subprocess.run([TOOLS / "paraview", self.files["result"], "-o", vtm], check=True)
        parts = [block.attrib["file"] for block in ElementTree.parse(vtm).iter("DataSet")]
        self.assertEqual(parts, [f"in_space/{part}.vts" for part in ("contact", "rail", "wheel")])
        arrays = {a.attrib["Name"]: np.array(a.text.split(), dtype=float)
                  for a in ElementTree.parse(self.folder / parts[0]).iter("DataArray")}
        with h5py.File(self.files["result"]) as h5:
            pressure = h5["p_n"][()]
            np.testing.assert_allclose(arrays["pressure"], pressure.ravel(), rtol=1e-8)
            corners = arrays["points"].reshape(pressure.shape[0] + 1, pressure.shape[1] + 1, 3)
            # The elements' centres are the file's, but for the sag of a row's arc.
            centres = (corners[1:, 1:] + corners[:-1, :-1]) / 2
            np.testing.assert_allclose(centres[..., 0], np.tile(h5["x"][()], (len(pressure), 1)), atol=1e-9)
            for k, name in ((1, "y"), (2, "z")):
                np.testing.assert_allclose(centres[:, 0, k], h5[name][()], atol=0.01)
        compile(vtm.with_suffix(".py").read_text(), "state", "exec")

    def test_what_cannot_be_reported_is_refused(self):
        numbers = self.folder / "numbers.h5"
        with h5py.File(numbers, "w") as h5:
            h5.attrs["format"] = "something else"
        page = self.folder / "refused.html"
        damaged = self.folder / "damaged_influence.h5"
        damaged.write_bytes(self.files["influence"].read_bytes()[:-100])
        half = self.folder / "half.msh"
        half.write_text(SQUARE[:-60])
        for file, output, words in ((numbers, page, "is HDF5, but no file of answers"),
                                    (self.folder / "patch.toml", page, "patch.toml"), (half, page, "no whole mesh of a section"), (damaged, page, "truncated"),
                                    (self.files["result"], self.files["result"], "result.h5"),
                                    (self.files["result"], self.folder / "none" / "page.html", "none")):
            done = program("report", file, "-o", output)
            self.assertEqual(done.returncode, 2, done.stderr)
            self.assertIn(words, done.stderr)
            self.assertFalse(page.exists())
        self.assertTrue(h5py.is_hdf5(self.files["result"]))

    def look_at_the_screenshot(self, show, kind):
        """Each figure has paper and something on it, in several shades; the whole page prints."""
        picture = self.folder / f"{kind}.png"
        show.screenshot(picture)
        pixels = imread(picture)[..., :3]
        for name, x, y, width, height in show.value("""[...document.querySelectorAll(".figure")].map(figure => {
                const at = figure.getBoundingClientRect();
                return [figure.id, at.x + scrollX, at.y + scrollY, at.width, at.height].map((v, k) => k ? Math.round(v) : v); })"""):
            figure = pixels[y:y + height, x:x + width].reshape(-1, 3)
            drawn = np.mean(np.any(figure < 0.9, axis=1))
            self.assertTrue(0.005 < drawn < 0.95, (kind, name, drawn))
            self.assertGreater(len(np.unique(figure.round(2), axis=0)), 20, (kind, name))
        printed = self.folder / f"{kind}.pdf"
        show.pdf(printed)
        self.assertIn(printed.read_bytes().count(b"/Type /Page\n"), range(1, 5), kind)  # sheets of A4

    def look_at_the_first_screen(self, show, kind):
        """What was found, one picture, the first warning and what to do next stand on a laptop's screen, side by side."""
        wide, high = browser.USUAL
        box = ("(id => (at => at && [at.left, at.top, at.right, at.bottom])(document.querySelector(id)?.getBoundingClientRect()))")
        shown = {id: show.value(f"{box}('{id}')") for id in ("#found", "#first .figure", "#warnings .warning", "#next")}
        words, picture = shown["#found"], shown["#first .figure"]
        for id, at in shown.items():
            if at:
                self.assertTrue(0 <= at[0] and at[2] <= wide and at[3] <= high, (kind, id, at))
        self.assertLess(words[2], picture[0] + 1, kind)  # the words beside the picture
        self.assertEqual(bool(shown["#warnings .warning"]), kind in self.warned, kind)
        # The sentences are those of every other door.
        sentences = show.value("[...document.querySelectorAll('#found li')].map(line => line.textContent)")
        page, stored = self.report_of(kind), self.files.get(kind)
        if kind in ("profile", "sections", "mesh", "influence"):
            self.assertIsNone(shown["#next"], kind)
        else:
            plain = [one.replace("±\u00a0", "+- ").replace("²", "2").replace("³", "3").replace("\u00a0", " ") for one in sentences]
            self.assertEqual(plain, page["found"]["text"].split("\n"), kind)
            self.assertIn(len(plain), range(2, 6), kind)
            self.assertIsNotNone(shown["#next"], (kind, stored))
        # Tables come after all figures, and are folded; what was asked comes last.
        self.assertEqual(show.value("[...document.querySelectorAll('table')].filter(t => !t.closest('details')).length"), 0, kind)
        self.assertEqual(show.value("document.querySelector('main').lastElementChild.id"), "question" if kind not in ("profile", "sections") else "downloads", kind)

    def printed_by(self, module, calls, before=""):
        """What functions of a module of the page return, by Node."""
        if not shutil.which("node") or not shutil.which("esbuild"):
            self.skipTest("node or esbuild is not installed")
        words = ["esbuild", ROOT / "bem_contact" / "report" / module, "--bundle", "--format=iife", "--global-name=it", "--charset=utf8"]
        script = before + subprocess.run(words, capture_output=True, text=True, check=True).stdout
        script += "".join(f"console.log(it.{call}.trimEnd());" for call in calls)
        return subprocess.run([shutil.which("node"), "-e", script], capture_output=True, text=True, check=True).stdout.splitlines()

    def test_digits_are_those_of_the_error(self):
        """As the program rounds (record/error_text.hpp)."""
        texts = {"2627.6, 32.1": "2628 ± 32", "34793, 221": "34790 ± 220", "12790572, 19723973": "13000000 ± 20000000",
                 "-9.2714e-4, 5.1e-6": "(-9.271 ± 0.051)e-4", "1e-5, 0.034": "0.000 ± 0.034", "462.51234": "462.51",
                 "null": "–", "1e-12, 0.5": "0.00 ± 0.50"}
        printed = self.printed_by("numbers.js", [f"number({call})" for call in texts])
        self.assertEqual([text.replace("\u00a0", " ") for text in printed], list(texts.values()))

    def test_no_cell_of_a_table_is_a_formula(self):
        """As record::csv_text(): a spreadsheet would compute what begins with one of these."""
        page = "const document = {getElementById: () => ({})}, window = {addEventListener: () => {}};"
        printed = self.printed_by("drawing.js", ["csvOf([['=1+1', '@a', '-1.5', '+2', 'a, b', 7]])"], page)
        self.assertEqual(printed, ['" =1+1"," @a",-1.5," +2","a, b",7'])

    def look_at_differences(self, show):
        """Of each model, what it has more than the first one; each kind of warning once."""
        rows = show.value("[...document.querySelectorAll('#quantities-at_equal_forces tr')].map(r => [...r.cells].map(c => c.textContent))")
        self.assertEqual(rows[0][4:6], ["tangent plane less FEM", "half-space less FEM"])
        pressures = next(row for row in rows if row[0] == "largest pressure")
        data = self.report_of("comparison")["data"]["at_equal_forces"]
        values = [data[model]["quantities"]["pmax"]["values"][0] for model in ("fem", "tangent_plane", "halfspace")]
        for text, value in zip(pressures[4:6], values[1:], strict=True):
            self.assertAlmostEqual(float(text.split(" ")[0]), value - values[0], delta=1e-3 * abs(value - values[0]))
        warnings = show.value("[...document.querySelectorAll('.warning')].map(w => w.textContent.replace(/[\\d.]+/g, '#').split('(')[0])")
        self.assertEqual(len(warnings), len(set(warnings)))
        self.assertGreater(len(warnings), 0)

    def look_at_linear_theory(self, show):
        """The straight line has Kalker's slope, and its value where the scene is: with the parts of the other two creepages."""
        data = self.report_of("curves")["data"]
        slopes, rigid = (np.reshape(data[name]["values"], data[name]["shape"]) for name in ("kalker", "rigid_creepages"))
        np.testing.assert_allclose(rigid, [4e-4, 3e-4, 1e-4], rtol=1e-9)  # of PATCH
        x, y = show.value("(line => [line.x, line.y])(document.querySelector('#curve-xi .drawing').data.find(t => t.name === 'Fx by linear theory'))")
        self.assertAlmostEqual((y[1] - y[0]) / (x[1] - x[0]) / slopes[0, 0], 1, delta=1e-9)
        self.assertAlmostEqual(y[0] + slopes[0, 0] * (4e-4 - x[0]), slopes[0] @ rigid, delta=1e-6)

    def look_at_measured_forces(self, show):
        """Points with their scatter, and each difference."""
        points = self.report_of("curves")["data"]["measured"]["points"]
        drawn = show.value("(t => [t.x, t.y, t.error_y.array])(document.querySelector('#curve-xi .drawing').data.find(t => t.name === 'Fx as measured'))")
        self.assertEqual(drawn, [[1e-3, 2e-3, 3e-3], [500, 700, 900], [40, 50, 60]])
        self.assertFalse(show.value("document.querySelector('#curve-phi .drawing').data.some(t => t.name === 'Fx as measured')"))
        rows = show.value("[...document.querySelectorAll('#measured tbody tr')].map(row => [...row.cells].map(cell => cell.textContent))")
        for row, computed, difference in zip(rows, points["computed"]["values"], points["difference"]["values"], strict=True):
            self.assertAlmostEqual(float(row[3].split(" ")[0]), computed, delta=2e-3 * abs(computed))
            self.assertAlmostEqual(float(row[4].replace("−", "-")), difference, delta=2e-3 * abs(computed))

    def look_at_a_case(self, show):
        """A click on a mark of a sweep shows the patch of its case."""
        data = self.report_of("cases")["data"]
        show.value("(figure => void figure.emit('plotly_click', {points: [{customdata: figure.data[0].customdata[1]}]}))"
                   "(document.querySelector('#over-pmax .drawing'))")
        show.value("new Promise(done => { const look = () => document.querySelector('#case-patch svg.main-svg') ? done() : setTimeout(look, 50); look(); })")
        case, words = show.value("(figure => [figure.data[0].customdata[1], document.querySelector('#case .caption').textContent])"
                                 "(document.querySelector('#over-pmax .drawing'))")
        self.assertIn(f"Case {case}: ", words)
        largest = show.value("Math.max(...document.querySelector('#case-patch .drawing').data[0].z.flat())")
        self.assertAlmostEqual(largest, data["pmax"]["values"][case], delta=1e-9 * largest)

    def look_at_downloads(self, show):
        """CSV of the file's numbers, all digits."""
        names = show.value("[...document.querySelectorAll('#downloads button')].map(b => b.textContent)")
        self.assertIn("quantities", names)
        text = show.value("csvOf(tablesIn(data).find(([name]) => name === 'quantities')[1])")
        pmax = next(line.split(",") for line in text.splitlines() if line.startswith("pmax,"))
        self.assertEqual(float(pmax[1]), self.report_of("result")["data"]["quantities"]["pmax"]["values"][0])

    def look_at_width(self, show, width):
        """At most 1200 px on a wide screen; on a narrow one nothing is wider than the screen."""
        self.assertLessEqual(show.value("document.documentElement.scrollWidth"), width)
        self.assertLessEqual(show.value("Math.max(0, ...[...document.querySelectorAll('.figure')].map(f => f.getBoundingClientRect().width))"), 1200)
        on_words = [line for line in show.value(LOOK).splitlines() if " lies on " in line or "cut off" in line]
        self.assertEqual(on_words, [], width)

    @unittest.skipUnless(browser.PROGRAM, "chromium is not installed")
    def test_a_browser_draws_it(self):
        contact = ["patch", "cut-x", "cut-s"]
        wanted = {"result": ["place", "quantities", "patches-fem", "solid-fem", "section-fem", *(f"{c}-fem" for c in contact)],
                  "stresses": ["stresses-halfspace"], "cylinder": ["patch-halfspace", "cut-x-halfspace", "history"],
                  "comparison": ["pressures", "quantities-at_equal_forces", "creep-forces", *(f"{c}-{m}" for c in contact
                                                                          for m in ("halfspace", "tangent_plane", "fem"))],
                  "curves": ["slopes", "kalker", "sensitivities", "curve-xi", "curve-phi", "measured"],
                  "fit": ["parameters", "slopes", "curve-xi", "measured"],
                  "sweep": ["patches-over-y", "over-pmax", "over-Fx-Fy", "cases"],
                  "cases": ["patches-over-y", "over-pmax", "over-T_gamma", "cases"],
                  "conicity": ["conicities", "tan-gamma", "radius-difference", "touch-wheel", "touch-rail"],
                  "wheelset": ["place", "track", *(f"{c}-{side}" for c in (*contact, "solid", "quantities") for side in ("left", "right"))],
                  "wear": ["film-rail", "film-wheel", "worn-rail", "worn-wheel", "wear-depth", "wear-area", "steps"],
                  "profile": ["outline", "curvature"], "sections": ["sections-above", "sections-side"],
                  "along": ["sections-above", "sections-side", "passage-above", "cases"],
                  "fatigue": ["shakedown", "stress-depth", "fatigue-patches"],
                  "inside": ["von_mises-1", "depth-1", "stresses-patches"], "collective": ["envelope", "shakedown-patches"],
                  "shakedown": ["limits-1", "dang_van-1", "residual_xx-1", "shakedown-patches"],
                  "rates": ["worn-rows", "rates"], "axle_rates": ["worn-rows-left", "worn-rows-right", "rates-left", "rates-right"],
                  "table": ["table-errors", "table-Fx", "table-pmax", "table-columns", "table-axes"],
                  "mesh": ["mesh", "mesh-strip"], "map": ["map", "map-entries"], "influence": ["strip", "influence-attributes"],
                  "study": ["taken", "parts", "headline", "solve-place", "solve-patch-halfspace", "fatigue-shakedown", "wear-worn-rows",
                            "conicity-tan-gamma"]}
        show = browser.Browser()
        try:
            for kind, page in self.pages.items():
                show.open(page)
                self.assertEqual(show.value("document.getElementById('script-errors').innerText"), "", kind)
                self.assertEqual([r for r in show.requests if not r.startswith(("file:", "data:", "blob:"))], [], kind)
                for name in wanted[kind]:
                    drawn = f"!!document.getElementById('{name}')?.matches('table, :has(svg.main-svg)')"
                    self.assertTrue(show.value(drawn), (kind, name))
                self.assertGreater(len(show.value("document.getElementById('words').textContent")), 40, kind)
                self.look_at_the_first_screen(show, kind)
                self.assertEqual(show.value(LOOK), "", kind)
                self.look_at_the_screenshot(show, kind)
                if kind == "wear":
                    moved = """(async film => { await Plotly.animate(film, ["step 1"], {mode: "immediate", frame: {duration: 0}});
                        return Math.max(...film.data[1].y.map((z, i) => Math.abs(z - film.data[0].y[i]))); })
                        (document.querySelector("#film-rail .drawing"))"""
                    last = "Math.max(...data.rail_depth.values)"
                    self.assertLess(show.value(moved), 5)  # mm, drawn; the last step is the deepest
                    self.assertGreater(show.value(last), 0.02)
                if kind == "mesh":
                    self.assertIn("good: the worst scaled Jacobian is 0.89", show.value("document.getElementById('words').textContent"))
                if kind in ("fatigue", "inside", "shakedown", "collective", "rates", "table", "map", "influence", "mesh"):
                    self.assertEqual(show.value("document.querySelectorAll('.six dd').length"), 6, kind)
                    self.assertEqual(show.value("[...document.querySelectorAll('.six dd')].filter(d => /NaN|undefined|null/.test(d.textContent)).length"), 0, kind)
                if kind == "map":
                    entries = self.report_of(kind)["data"]["map"]
                    cells = show.value("[...document.querySelectorAll('#map-entries tbody tr')].map(row => [...row.cells].map(c => c.textContent))")
                    self.assertEqual([row[0] for row in cells], 3 * ["S1002"] + 3 * ["LMA"])
                    np.testing.assert_allclose([float(row[3]) for row in cells], entries["tan_gamma"]["values"], rtol=1e-4)
                if kind == "table":
                    data = self.report_of(kind)["data"]
                    drawn = show.value("document.querySelector('#table-pmax .drawing').data[0].y")
                    values = np.reshape(data["values"]["pmax"]["values"], data["values"]["pmax"]["shape"])
                    np.testing.assert_array_equal(drawn, values[:, 0])  # over the first axis, the first point of the second
                if kind == "wheelset":
                    row = show.value("[...document.querySelectorAll('#track tbody tr')].find(r => r.textContent.startsWith('inclination')).textContent")
                    right = self.report_of(kind)["data"]["right"]["track"]["delta"]["values"][0]
                    radian, degrees = re.search(r"(-\d\S*) \((-\d\S*)°\)", row).groups()
                    self.assertAlmostEqual(float(radian), right, delta=1e-5)
                    self.assertAlmostEqual(float(degrees), np.degrees(right), delta=0.06)
                    for left, radius, depth in show.value("contactsOf(data).map(c => [c.left, radiusOf(c), c.group.patches.wheel_z.values[0]])"):
                        self.assertAlmostEqual(radius, (459.5 if left else 460) + depth, delta=1e-9)  # of the wheel in the picture
                if kind == "comparison":
                    self.look_at_differences(show)
                if kind == "curves":
                    self.look_at_linear_theory(show)
                    self.look_at_measured_forces(show)
                if kind == "cases":
                    self.look_at_a_case(show)
                if kind == "sweep":
                    titles = show.value("[...document.querySelectorAll('#over-pmax .ytitle')].map(t => t.textContent).join()")
                    self.assertEqual(titles, "largest pressure, MPa")
                if kind == "comparison":
                    cells = show.value("[...document.querySelectorAll('#creep-forces tbody tr')].map(row => [...row.cells].map(cell => cell.textContent))")
                    creep = self.report_of(kind)["data"]["creep_forces"]
                    for k, (xi, *forces) in enumerate(cells):
                        self.assertEqual(float(xi), creep["xi_from_free_rolling"]["values"][k])
                        for text, model in zip(forces, ("fem", "tangent_plane", "halfspace"), strict=True):
                            force, error = (float(part) for part in text.split("±"))
                            stated = creep["Fx_error"][model]["values"][k]  # both are rounded to two digits of it
                            self.assertAlmostEqual(force, creep["Fx"][model]["values"][k], delta=0.051 * stated)
                            self.assertAlmostEqual(error, stated, delta=0.051 * stated)
                    self.assertEqual(len(cells), 3)
                if kind == "result":
                    pixels = show.value("document.querySelector('#solid-fem .paper').src.length")
                    self.assertGreater(pixels, 20000)  # a picture of the bodies for paper, not an empty one
                    certificate = show.value("document.querySelector('.certificate').textContent")
                    self.assertIn("Certified: the worst violation", certificate)
                    tops = show.value("['#place', '.six', '#solid-fem', '#patch-fem', '#numbers', '#question'].map(e => "
                                      "document.querySelector(e).getBoundingClientRect().top + scrollY)")
                    self.assertEqual(tops, sorted(tops))  # where it touches, six numbers and bodies first; tables and the question last
                    self.assertEqual(show.value("document.querySelectorAll('.six dd').length"), 6)
                    self.look_at_downloads(show)
                if kind in ("result", "sweep"):
                    for width in (1400, 400):
                        show.of_width(width)
                        show.open(page)
                        self.look_at_width(show, width)
                    show.of_width(*browser.USUAL)
            # What was found nowhere so far can be found: words on words, wide tables, script errors.
            show.open(self.pages["wear"])
            show.value("(word => word.after(word.cloneNode(true)))(document.querySelector('#worn-rail svg .xtick text'))")
            show.value("document.getElementById('steps').closest('details')?.setAttribute('open', '')")
            show.value("document.getElementById('steps').style.width = '1500px'")
            self.assertRegex(show.value(LOOK), "worn-rail: '.*' lies on '.*'")
            self.assertIn("steps is wider than the page", show.value(LOOK))
            page = self.folder / "damaged.html"
            page.write_text(self.pages["curves"].read_text().replace('"kind":"creep curves"', '"kind":"unheard of"'))
            show.open(page)
            self.assertIn("not drawn to its end", show.value("document.getElementById('script-errors').innerText"))
        finally:
            show.close()


if __name__ == "__main__":
    unittest.main()
