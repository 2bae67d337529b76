"""data/benchmark: its tables are what the scenes give, and agree with each other. Coarse half-spaces alone are solved again, two seconds."""

import importlib.util
import os
import re
import subprocess
import tempfile
import unittest
from importlib.machinery import SourceFileLoader
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PROGRAM = os.environ["BEM_CONTACT"]
DATA = ROOT / "data" / "benchmark"
TOLERANCE = 1e-4  # relative: other machines have other last digits


def maker():
    loader = SourceFileLoader("benchmark", str(ROOT / "tools" / "makers" / "benchmark"))
    module = importlib.util.module_from_spec(importlib.util.spec_from_loader("benchmark", loader))
    loader.exec_module(module)
    return module


class Benchmark(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.maker = maker()
        cls.rows = cls.maker.table(DATA / "results.csv")

    def test_coarse_half_spaces_give_the_same_again(self):
        with tempfile.TemporaryDirectory() as folder:
            self.maker.BIN = Path(folder)
            (Path(folder) / "bem_contact").symlink_to(PROGRAM)
            usual = self.maker.scene_of
            self.maker.scene_of = lambda case: re.sub(r'(, |\w+\.)?influence = "[^"]*"(, )?', "", usual(case))
            self.maker.files_of = lambda case: []
            for case in self.maker.CASES:
                length = self.maker.LENGTH.get(case, self.maker.USUAL_LENGTH)
                found = self.maker.numbers_of(self.maker.solve(case, "halfspace", length, [], Path(folder)))
                kept = [row for row in self.rows if (row["case"], row["model"], row["length_mm"]) == (case, "halfspace", f"{length:g}")]
                self.assertGreater(len(kept), 4, case)
                for row in kept:
                    with self.subTest(case=case, quantity=row["quantity"]):
                        value = float(row["value"])
                        self.assertAlmostEqual(found[row["quantity"]][0], value, delta=TOLERANCE * abs(value))
            self.maker.scene_of = usual

    def test_tables_agree(self):
        cases = self.maker.table(DATA / "cases.csv")
        self.assertEqual([row["case"] for row in cases], list(self.maker.CASES))
        page = (DATA / "RESULTS.md").read_text()
        for row in self.rows:
            if row["model"] == "fem":
                self.assertIn(self.maker.with_bound(row), page, row)
        known = {(row["case"], row["quantity"]) for row in self.rows}
        for form in [DATA / "form.csv", *(DATA / "contributed").glob("*.csv")]:
            self.assertLessEqual({(row["case"], row["quantity"]) for row in self.maker.table(form)}, known, form)

    def test_stated_errors_hold(self):
        counted = re.search(r"Of the (\d+) errors .*?, (\d+) hold", self.maker.stated_errors(self.rows))
        self.assertGreaterEqual(int(counted[2]), 0.95 * int(counted[1]))

    def test_a_form_is_compared(self):
        done = subprocess.run([ROOT / "tools" / "makers" / "benchmark", "--compare", DATA / "contributed" / "analysis_3d.csv"],
                              capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("gauge_corner, pmax: 2010 MPa", done.stdout)

    def test_a_wrong_form_is_refused(self):
        """Each says which line, and what; nothing is compared."""
        head = "# me\n# how\ncase,quantity,unit,value,bound\n"
        wrong = {head + "tread,colour,1,3,\n": ":4: the benchmark has no 'colour'", head + "tred,pmax,MPa,3,\n": "Did you mean tread?",
                 head + "tread,pmax,GPa,1,\n": "'GPa'", head + "tread,pmax,MPa,nan,\n": "'nan'", head + "tread,pmax,MPa,inf,\n": "'inf'",
                 head + "tread,pmax,MPa,a,\n": "'a'", head + "tread,pmax,MPa,1,-1\n": "'-1'", head + "tread,pmax,MPa,1000,5,1\n": "6 cells",
                 head + "tread,pmax,MPa,1,\ntread,pmax,MPa,2,\n": "twice", head: "not filled in", head.replace(",bound", ""): "other columns",
                 head.replace(",", ";"): "other columns", head[11:]: "says nothing of who", "\xff": "says nothing"}
        with tempfile.TemporaryDirectory() as folder:
            for text, why in wrong.items():
                form = Path(folder) / "form.csv"
                form.write_text(text)
                done = subprocess.run([ROOT / "tools" / "makers" / "benchmark", "--compare", form], capture_output=True, text=True)
                self.assertEqual((done.returncode, done.stdout), (2, ""), text)
                self.assertIn(why, done.stderr)
            form.write_bytes(("\ufeff" + head + " tread , pmax ,MPa, 1000 ,\r\n").encode())  # as spreadsheets write it
            done = subprocess.run([ROOT / "tools" / "makers" / "benchmark", "--compare", form], capture_output=True, text=True)
            self.assertIn("tread, pmax: 1000 MPa", done.stdout)

    def test_the_page_is_made_without_solving(self):
        page = (DATA / "RESULTS.md").read_text()
        with tempfile.TemporaryDirectory() as folder:
            usual, self.maker.DATA = self.maker.DATA, Path(folder)
            for name in ("results.csv", "contributed", "scenes"):
                (Path(folder) / name).symlink_to(DATA / name)
            self.maker.write_page()
            self.maker.DATA = usual
            self.assertEqual((Path(folder) / "RESULTS.md").read_text(), page)


if __name__ == "__main__":
    unittest.main()
