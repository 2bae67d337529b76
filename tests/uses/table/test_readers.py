"""The readers of tools/examples give what the table's own evaluation gives."""

import os
import re
import sys
import tempfile
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2]))
from run_command import run  # noqa: E402

EXAMPLES, LIBRARY = Path(os.environ["EXAMPLES"]), Path(os.environ["LIBRARY"])
C_INTERFACE = EXAMPLES.parents[1] / "bem_contact" / "c"
SCENE = """rail.profile = "60E1"
wheel.profile = "S1002"
solver.model = "halfspace"
motion.xi = 1e-3
motion.free_rolling = false
grid.dx = 1.5
grid.ds = 1.5
[table]
position.lateral = [ -3, -2 ]
load.force = [ 5e4, 8e4 ]
"""


FORTRAN_FORCE = """program force
  use conformal_contact
  implicit none
  character(kind=c_char) :: message(1000)
  character(500) :: file
  real(c_double) :: at(2), values(4), slopes(2, 4), errors(4)
  integer(c_int) :: code, beyond
  type(c_ptr) :: table
  call get_command_argument(1, file)
  code = conformal_table_open(trim(file) // c_null_char, table, message, 1000)
  at = [-2.3d0, 6.6d4]
  code = conformal_table_force(table, at, 4, values, slopes, errors, beyond)
  print '(2i3, 16es25.16)', code, beyond, values, slopes, errors
  code = conformal_table_force(table, [-2.3d0, 9d4], 4, values, slopes, errors, beyond)
  print '(2i3)', code, beyond
end program
"""


class Readers(unittest.TestCase):
    def test_fortran_and_python_give_the_same_derivatives(self):
        import bem_contact

        folder = Path(self.temporary.name)
        (folder / "force.f90").write_text(FORTRAN_FORCE)
        run("gfortran", "-Wall", "-Werror", os.environ["FORTRAN"], folder / "force.f90", "-o", folder / "force", LIBRARY,
            f"-Wl,-rpath,{LIBRARY.parent}", cwd=folder)
        first, second = run(folder / "force", self.tables["forces"]).splitlines()
        found = [float(word) for word in first.split()]
        own = bem_contact.read_table(self.tables["forces"]).force([-2.3, 6.6e4])
        self.assertEqual(found[:2], [0, 0])
        for i, name in enumerate(("Fx", "Fy", "Fz", "Mz")):
            self.assertAlmostEqual(found[2 + i], own["values"][name], delta=1e-9 * (1 + abs(own["values"][name])))
            slopes = list(own["derivatives"][name].values())
            for a in range(2):
                self.assertAlmostEqual(found[6 + 2 * i + a], slopes[a], delta=1e-9 * (1 + abs(slopes[a])))
        self.assertEqual(second.split(), ["5", "2"])
        with self.assertRaises(bem_contact.InputError):
            bem_contact.read_table(self.tables["forces"]).force([-2.3, 9e4])

    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        folder = Path(cls.temporary.name)
        (folder / "scene.toml").write_text(SCENE)
        cls.tables = {"creep": folder / "creep.h5", "forces": folder / "forces.h5"}
        table = os.environ["BEM_CONTACT"], "table", "--tolerance"
        run(*table, "0.28", "--creep-forces", "--elements", "6", "--ratio", "0.5:2", "-o", folder / "creep.h5")
        run(*table, "0.5", folder / "scene.toml", "-o", folder / "forces.h5")
        flags = LIBRARY, f"-Wl,-rpath,{LIBRARY.parent}"
        run("gcc", "-std=c99", "-Wall", "-Werror", "-I", C_INTERFACE, EXAMPLES / "table_reader.c", "-o", folder / "c", *flags)
        run("gfortran", "-Wall", "-Werror", os.environ["FORTRAN"], EXAMPLES / "table_reader.f90", "-o",
            folder / "fortran", *flags, cwd=folder)
        cls.readers = {"Python": [sys.executable, EXAMPLES / "table_reader.py"], "C": [folder / "c"],
                       "Fortran": [folder / "fortran"]}

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    @staticmethod
    def numbers_of(text):
        """name: value, error"""
        found = re.findall(r"^\s*(\S+)\s+(\S+) \+-\s*([-+.\w]+)", text, re.M)
        return {name: (float(value), float(error)) for name, value, error in found}

    def check(self, kind, point):
        expected = self.numbers_of(run(os.environ["BEM_CONTACT"], "table", self.tables[kind], f"--at={','.join(point)}"))
        for language, command in self.readers.items():
            found = self.numbers_of(run(*command, self.tables[kind], *point))
            for name in ("Fx", "Fy", "Mz"):
                with self.subTest(language=language, name=name, point=point):
                    (value, error), (own_value, own_error) = found[name], expected[name]
                    self.assertAlmostEqual(value, own_value, delta=1e-9 * max(1, abs(own_value)))
                    self.assertAlmostEqual(error, own_error, delta=0.1 * own_error)
        return expected

    def test_creep_forces(self):
        for creepages in (("0.001", "0", "0"), ("-0.001", "0.0005", "0.0002"), ("0.002", "-0.0005", "0.0003"),
                          ("0", "0", "-0.001"), ("0", "0", "0")):
            self.check("creep", ("5", "4", "82000", "30000", *creepages))
        self.assertGreater(self.check("creep", ("6", "3", "82000", "30000", "0.001", "0", "0"))["Fx"][0], 0)  # a/b at an end

    def test_forces_of_a_scene(self):
        for point in (("-3", "50000"), ("-2.3", "66000"), ("-2", "80000")):
            self.assertGreater(self.check("forces", point)["Fx"][0], 1000)

    def test_outside_nothing_is_looked_up(self):
        for kind, point, words in (("creep", ("50", "4", "82000", "30000", "0.001", "0", "0"), "log10_a_over_b = 1.09691001 is outside"),
                                   ("forces", ("-9", "6e4"), "its axis goes from -3 to -2 mm"),
                                   ("forces", ("-2.5",), "it has 2 axes")):
            for language, command in (*self.readers.items(), ("program", None)):
                own = [os.environ["BEM_CONTACT"], "table", self.tables[kind], f"--at={','.join(point)}"]
                called = [*command, self.tables[kind], *point] if command else own
                if language == "Fortran" and len(point) == 1:
                    continue  # its point has as many coordinates as the table has axes
                with self.subTest(language=language, point=point), self.assertRaisesRegex(AssertionError, words):
                    run(*called)

    def test_without_the_library(self):
        """The function on the tutorial's page."""
        page = (EXAMPLES.parents[1] / "data" / "tutorial" / "table.md").read_text().split("## Without this library")[1]
        names = {}
        exec(page.split("```python\n")[1].split("```")[0], names)
        for point in ("-3", "50000"), ("-2.3", "66000"), ("-2", "80000"):
            own = self.numbers_of(run(os.environ["BEM_CONTACT"], "table", self.tables["forces"], f"--at={','.join(point)}"))
            found = names["value"](self.tables["forces"], "Fy", [float(word) for word in point])
            self.assertAlmostEqual(found, own["Fy"][0], delta=1e-9 * abs(own["Fy"][0]))

    def test_they_are_short(self):
        for ending in ("py", "c", "f90"):
            self.assertLessEqual(len((EXAMPLES / f"table_reader.{ending}").read_text().splitlines()), 30)


if __name__ == "__main__":
    unittest.main()
