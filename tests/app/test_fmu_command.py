"""bem_contact fmu: an importer of our own, by the standard's text, finds the numbers of the table in the FMU."""

import ctypes
import io
import os
import platform
import re
import shutil
import subprocess
import tempfile
import threading
import unittest
import zipfile
from ctypes import CFUNCTYPE, POINTER, byref, c_bool, c_char, c_char_p, c_double, c_int, c_size_t, c_uint, c_void_p
from pathlib import Path
from xml.etree import ElementTree

import h5py
import numpy as np

OK, WARNING, DISCARD, ERROR = range(4)
SCENE = """kind = "patch"
gap.a = 1e-3
gap.b = 2e-3
motion.xi = 1e-3
solver.model = "halfspace"
grid = { dx = 0.25, ds = 0.25, mx = 32, ms = 32 }
[table]
motion.eta = [ 0, 1e-3, 2e-3 ]
load.force = { from = 2e3, to = 4e3, count = 3 }
"""
WINDOWS = r"""
#include <stdio.h>
#include <windows.h>
typedef void* (*make)(const char*, const char*, const char*, int, int, void*, void*);
typedef int (*set)(void*, const unsigned*, size_t, const double*, size_t);
typedef int (*get)(void*, const unsigned*, size_t, double*, size_t);
int main(int count, char** words) { /* LIBRARY TOKEN ETA FORCE */
  HMODULE library = LoadLibraryA(words[1]);
  const unsigned in[] = {1, 2}, out[] = {3, 4};
  double at[] = {atof(words[3]), atof(words[4])}, value[2];
  void* one = ((make)(void*)GetProcAddress(library, "fmi3InstantiateModelExchange"))("one", words[2], "", 0, 0, 0, 0);
  const int wrote = ((set)(void*)GetProcAddress(library, "fmi3SetFloat64"))(one, in, 2, at, 2);
  const int read = ((get)(void*)GetProcAddress(library, "fmi3GetFloat64"))(one, out, 2, value, 2);
  printf("%d %d %.17g %.17g\n", wrote, read, value[0], value[1]);
  return count != 5;
}
"""


class Fmu:
    """What an importer does: unpack, read modelDescription.xml, load the library, call by the standard's names."""

    def __init__(self, file, folder):
        with zipfile.ZipFile(file) as archive:
            self.names = archive.namelist()
            assert archive.testzip() is None
            archive.extractall(folder)
        self.folder = Path(folder)
        self.xml = ElementTree.parse(self.folder / "modelDescription.xml").getroot()
        self.version = int(self.xml.get("fmiVersion")[0])
        self.token = self.xml.get("guid") or self.xml.get("instantiationToken")
        variables = list(self.xml.find("ModelVariables"))
        self.variables = {v.get("name"): {**v.attrib, **(v.find("Real").attrib if self.version == 2 else {})} for v in variables}
        self.model = self.xml.find("CoSimulation").get("modelIdentifier")
        where = "linux64" if self.version == 2 else f"{platform.machine()}-linux"
        self.library = ctypes.CDLL(str(self.folder / "binaries" / where / f"{self.model}.so"))
        self.said = []
        if self.version == 3:
            self.logger = CFUNCTYPE(None, c_void_p, c_int, c_char_p, c_char_p)(lambda _, status, category, text: self.said.append(text.decode()))
        else:  # the text comes behind its format "%s"
            self.logger = CFUNCTYPE(None, c_void_p, c_char_p, c_int, c_char_p, c_char_p, c_char_p)(
                lambda _, name, status, category, form, text: self.said.append(text.decode()))

            class Callbacks(ctypes.Structure):
                _fields_ = [("logger", type(self.logger)), ("allocate", c_void_p), ("release", c_void_p), ("finished", c_void_p),
                            ("environment", c_void_p)]

            self.callbacks = Callbacks(self.logger)

    def call(self, name, *arguments):
        return self.library[f"fmi{self.version}{name}"](*arguments)

    def make(self, co_simulation=True, token=None):
        token = (token or self.token).encode()
        if self.version == 2:
            make = self.library.fmi2Instantiate
            make.restype = c_void_p
            one = make(b"one", c_int(co_simulation), token, b"", byref(self.callbacks), 0, 1)
        else:
            kind = "CoSimulation" if co_simulation else "ModelExchange"
            make = self.library[f"fmi3Instantiate{kind}"]
            make.restype = c_void_p
            more = (c_bool(False), c_bool(False), None, c_size_t(0)) if co_simulation else ()
            one = make(b"one", token, b"", c_bool(False), c_bool(True), *more, None, self.logger, *((None,) if co_simulation else ()))
        return one and c_void_p(one)

    def start(self, co_simulation=True):
        one = self.make(co_simulation)
        if self.version == 2:
            assert self.call("SetupExperiment", one, 0, c_double(0), c_double(0), 0, c_double(0)) == OK
            assert self.call("EnterInitializationMode", one) == OK
        else:
            assert self.call("EnterInitializationMode", one, c_bool(False), c_double(0), c_double(0), c_bool(False), c_double(0)) == OK
        assert self.call("ExitInitializationMode", one) == OK
        return one

    def references(self, names):
        return (c_uint * len(names))(*(int(self.variables[name]["valueReference"]) for name in names)), c_size_t(len(names))

    def set(self, one, **values):
        values = {name.replace("__", "."): value for name, value in values.items()}
        numbers = (c_double * len(values))(*values.values())
        name, more = ("SetReal", ()) if self.version == 2 else ("SetFloat64", (c_size_t(len(values)),))
        return self.call(name, one, *self.references(values), numbers, *more)

    def get(self, one, *names):
        out = (c_double * len(names))(*([12345.0] * len(names)))
        name, more = ("GetReal", ()) if self.version == 2 else ("GetFloat64", (c_size_t(len(names)),))
        status = self.call(name, one, *self.references(names), out, *more)
        return status, list(out)

    def derivative(self, one, unknowns, knowns, seed, kind="Directional"):
        n = len(unknowns if kind == "Directional" else knowns)
        out = (c_double * n)()
        seeds = (c_double * len(seed))(*seed)
        sizes = ((), ()) if self.version == 2 else ((c_size_t(len(seed)),), (c_size_t(n),))
        status = self.call(f"Get{kind}Derivative", one, *self.references(unknowns), *self.references(knowns), seeds, *sizes[0], out, *sizes[1])
        return status, list(out)


class FmuCommand(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.kept = tempfile.TemporaryDirectory()
        cls.folder = Path(cls.kept.name)
        (cls.folder / "scene.toml").write_text(SCENE)
        cls.table = cls.folder / "table.h5"
        made = cls.program("table", cls.folder / "scene.toml", "-o", cls.table, "--tolerance", 0.05)
        assert made.returncode == 0, made.stderr
        cls.made = {}

    @classmethod
    def tearDownClass(cls):
        cls.kept.cleanup()

    @staticmethod
    def program(*arguments, **more):
        return subprocess.run([os.environ["BEM_CONTACT"], *map(str, arguments)], capture_output=True, text=True, **more)

    def fmu(self, *options):
        """Each is compiled once."""
        if options not in self.made:
            file = self.folder / f"contact{len(self.made)}.fmu"
            done = self.program("fmu", self.table, "-o", file, "--columns", "Fx,Fy,pmax", *options)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.made[options] = Fmu(file, self.folder / file.stem)
        return self.made[options]

    def looked_up(self, *at):
        said = self.program("table", self.table, f"--at={','.join(map(repr, at))}").stdout.splitlines()
        return {line.split()[0]: float(line.split()[1]) for line in said}

    def test_numbers_are_those_of_the_table(self):
        own = self.looked_up(7e-4, 2345.0)
        for options in (("--fmi", "3.0"), ("--fmi", "2.0")):
            for co_simulation in (True, False):
                fmu = self.fmu(*options)
                one = fmu.start(co_simulation)
                self.assertEqual(fmu.set(one, motion__eta=7e-4, load__force=2345.0), OK)
                status, found = fmu.get(one, "Fx", "pmax", "Fy")
                self.assertEqual(status, OK)
                np.testing.assert_allclose(found, [own[name] for name in ("Fx", "pmax", "Fy")], rtol=1e-9)
                status, (margin, error, eta) = fmu.get(one, "margin", "Fx_error", "motion.eta")
                self.assertEqual((status, eta), (OK, 7e-4))
                self.assertAlmostEqual(margin, 345 / 2000)
                with h5py.File(self.table) as stored:
                    self.assertAlmostEqual(error, stored["interpolation_error/Fx"][()] + stored["element_error/Fx"][()], delta=1e-9 * error)
                    self.assertEqual(float(fmu.variables["Fx_error"]["start"]), error)
                    self.assertEqual(float(fmu.variables["load.force"]["max"]), stored["axes/load.force"][-1])
                fmu.call("FreeInstance", one)

    def test_outside_of_the_table_there_is_no_number(self):
        for version in ("3.0", "2.0"):
            fmu = self.fmu("--fmi", version)
            one = fmu.start()
            for wrong in (-1e-3, 1.0, float("nan"), float("inf")):
                fmu.said.clear()
                self.assertEqual(fmu.set(one, motion__eta=wrong, load__force=3000.0), OK)
                self.assertEqual(fmu.get(one, "Fx", "Fy"), (DISCARD, [12345.0, 12345.0]))
                self.assertRegex(fmu.said[0], "motion.eta, 1: .* is outside of the table .from 0 to 0.002")
                self.assertEqual(fmu.derivative(one, ["Fx"], ["load.force"], [1.0]), (DISCARD, [0.0]))
                more = (c_bool(False), byref(c_bool()), byref(c_bool()), byref(c_bool()), byref(c_double())) if version == "3.0" else (0,)
                self.assertEqual(fmu.call("DoStep", one, c_double(0), c_double(0.1), *more), DISCARD)
                self.assertEqual(fmu.get(one, "time"), (OK, [0.0]))
                status, (margin,) = fmu.get(one, "margin")
                self.assertFalse(margin >= 0)
            self.assertEqual(fmu.set(one, motion__eta=1e-3), OK)  # and it goes on
            self.assertEqual(fmu.get(one, "Fx")[0], OK)
            self.assertEqual(fmu.call("DoStep", one, c_double(0), c_double(0.1), *more), OK)
            self.assertEqual(fmu.get(one, "time"), (OK, [0.1]))

    def test_derivatives_are_those_of_the_values(self):
        for version in ("3.0", "2.0"):
            fmu = self.fmu("--fmi", version)
            one = fmu.start(False)

            def at(eta, force):
                fmu.set(one, motion__eta=eta, load__force=force)
                return np.array(fmu.get(one, "Fx", "Fy", "pmax", "margin")[1])

            eta, force, seed = 6.3e-4, 2345.0, [2e-4, 100.0]
            step = 1e-4
            differences = (at(eta + step * seed[0], force + step * seed[1]) - at(eta - step * seed[0], force - step * seed[1])) / (2 * step)
            at(eta, force)
            status, found = fmu.derivative(one, ["Fx", "Fy", "pmax", "margin"], ["motion.eta", "load.force"], seed)
            self.assertEqual(status, OK)
            np.testing.assert_allclose(found, differences, rtol=1e-6)
            if version == "3.0":  # the adjoint has the same product with a seed
                weights = [0.3, -2.0, 5.0, 7.0]
                status, adjoint = fmu.derivative(one, ["Fx", "Fy", "pmax", "margin"], ["motion.eta", "load.force"], weights, "Adjoint")
                self.assertEqual(status, OK)
                self.assertAlmostEqual(np.dot(adjoint, seed), np.dot(weights, found), delta=1e-9 * abs(np.dot(weights, found)))
            self.assertEqual(fmu.derivative(one, ["Fx_error"], ["motion.eta"], [1.0])[0], ERROR)
            self.assertEqual(fmu.derivative(one, ["Fx"], ["Fy"], [1.0])[0], ERROR)

    def test_a_state_comes_back_also_as_bytes(self):
        for version, state, out, into in (("3.0", "FMUState", "Serialize", "Deserialize"), ("2.0", "FMUstate", "Serialize", "DeSerialize")):
            fmu = self.fmu("--fmi", version)
            one, kept, copy, size = fmu.start(), c_void_p(), c_void_p(), c_size_t()
            fmu.set(one, motion__eta=1e-3, load__force=2500.0)
            _, before = fmu.get(one, "Fx", "Fy")
            self.assertEqual(fmu.call(f"Get{state}", one, byref(kept)), OK)
            self.assertEqual(fmu.call(f"Serialized{state}Size", one, kept, byref(size)), OK)
            text = (c_char * size.value)()
            self.assertEqual(fmu.call(f"{out}{state}", one, kept, text, size), OK)
            self.assertEqual(fmu.call(f"{out}{state}", one, kept, text, c_size_t(size.value - 1)), ERROR)
            fmu.set(one, motion__eta=0.0, load__force=4000.0)
            self.assertNotEqual(fmu.get(one, "Fx", "Fy")[1], before)
            self.assertEqual(fmu.call(f"Set{state}", one, kept), OK)
            self.assertEqual(fmu.get(one, "Fx", "Fy"), (OK, before))
            other = fmu.start()
            self.assertEqual(fmu.call(f"{into}{state}", other, text, size, byref(copy)), OK)
            self.assertEqual(fmu.call(f"{into}{state}", other, text, c_size_t(7), byref(c_void_p())), ERROR)
            self.assertEqual(fmu.call(f"Set{state}", other, copy), OK)
            self.assertEqual(fmu.get(other, "Fx", "Fy"), (OK, before))
            for pointer in (kept, copy):
                self.assertEqual(fmu.call(f"Free{state}", one, byref(pointer)), OK)
                self.assertIsNone(pointer.value)
            self.assertEqual(fmu.call("Reset", one), OK)
            self.assertEqual(fmu.get(one, "motion.eta"), (OK, [float(fmu.variables["motion.eta"]["start"])]))

    def test_wrong_calls_are_errors(self):
        for version in ("3.0", "2.0"):
            fmu = self.fmu("--fmi", version)
            self.assertIsNone(fmu.make(token="another"))
            self.assertIn("another instantiation token", fmu.said[-1])
            one = fmu.start()
            self.assertEqual(fmu.set(one, Fx=1.0), ERROR)
            self.assertEqual(fmu.set(one, time=1.0), ERROR)
            self.assertEqual(fmu.call("EnterInitializationMode", *((one,) if version == "2.0" else (
                one, c_bool(False), c_double(0), c_double(0), c_bool(False), c_double(0)))), ERROR)
            name = "GetReal" if version == "2.0" else "GetFloat64"
            self.assertEqual(fmu.call(name, one, (c_uint * 1)(999), c_size_t(1), (c_double * 1)(), c_size_t(1)), ERROR)
            self.assertEqual(fmu.call(name, one, None, c_size_t(1), None, c_size_t(1)), ERROR)
            self.assertEqual(fmu.call(name, None, (c_uint * 1)(1), c_size_t(1), (c_double * 1)(), c_size_t(1)), ERROR)
            self.assertEqual(fmu.call("GetString", one, (c_uint * 1)(1), c_size_t(1), (c_char_p * 1)(), c_size_t(1)), ERROR)
            self.assertEqual(fmu.call("GetString", one, None, c_size_t(0), None, c_size_t(0)), OK)
            self.assertEqual(fmu.call("Terminate", one), OK)
            self.assertEqual(fmu.set(one, motion__eta=1e-3), ERROR)

    def test_instances_do_not_know_each_other(self):
        """Each of eight threads has its own, and finds what it finds alone."""
        fmu = self.fmu("--fmi", "3.0")
        wanted, found = {}, {}

        def work(k, into):
            one, out = fmu.start(), []
            for i in range(300):
                fmu.set(one, motion__eta=2e-3 * ((k + i * 7) % 40) / 40, load__force=2000.0 + 2000 * ((3 * k + i) % 50) / 50)
                out.append(fmu.get(one, "Fx", "Fy"))
            into[k] = out

        for k in range(8):
            work(k, wanted)
        threads = [threading.Thread(target=work, args=(k, found)) for k in range(8)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(found, wanted)

    def test_units_of_si(self):
        own, si = self.fmu("--fmi", "3.0"), self.fmu("--si")
        self.assertEqual([si.variables[name]["unit"] for name in ("load.force", "Fx", "pmax")], ["N", "N", "Pa"])
        self.assertEqual(own.variables["pmax"]["unit"], "MPa")
        found = []
        for fmu in (own, si):
            one = fmu.start()
            fmu.set(one, motion__eta=1.5e-3, load__force=3456.0)
            found.append(fmu.get(one, "Fx", "pmax")[1] + fmu.derivative(one, ["Fx", "pmax"], ["load.force"], [1.0])[1])
        np.testing.assert_allclose(found[1], np.multiply(found[0], [1, 1e6, 1, 1e6]), rtol=1e-12)
        base = {unit.get("name"): unit.find("BaseUnit").attrib for unit in own.xml.find("UnitDefinitions")}
        self.assertEqual(base["MPa"], {"kg": "1", "m": "-1", "s": "-2", "factor": "1000000"})

    def test_what_the_description_says(self):
        """Outputs and their dependencies are those of the table, by value references (3.0) or places (2.0)."""
        for version in ("3.0", "2.0"):
            fmu = self.fmu("--fmi", version)
            order = list(fmu.variables)
            structure = fmu.xml.find("ModelStructure")
            outputs = structure.find("Outputs") if version == "2.0" else structure.findall("Output")
            by_reference = {v["valueReference"]: name for name, v in fmu.variables.items()}

            def name(number):
                return order[int(number) - 1] if version == "2.0" else by_reference[number]

            self.assertEqual([name(o.get("index") or o.get("valueReference")) for o in outputs], ["Fx", "Fy", "pmax", "margin"])
            for output in outputs:
                self.assertEqual([name(number) for number in output.get("dependencies").split()], ["motion.eta", "load.force"])
            self.assertIn(f"sources/{fmu.model}.c", fmu.names)
            units = {unit.get("name") for unit in fmu.xml.find("UnitDefinitions")}
            self.assertLessEqual({v["unit"] for v in fmu.variables.values() if "unit" in v}, units)

    def test_the_source_inside_is_clean_c(self):
        """All that a compiler can say is an error, also for a program that takes it in with a prefix."""
        fmu = self.fmu("--fmi", "3.0")
        source = fmu.folder / "sources" / f"{fmu.model}.c"
        strict = ["cc", "-std=c99", "-pedantic", "-Wall", "-Wextra", "-Wno-unused-function", "-Wno-unused-const-variable", "-Werror", "-c"]
        subprocess.run([*strict, source, "-o", self.folder / "plain.o"], check=True)
        subprocess.run([*strict, "-DFMI3_FUNCTION_PREFIX=contact_", source, "-o", self.folder / "prefixed.o"], check=True)
        names = subprocess.run(["nm", self.folder / "prefixed.o"], capture_output=True, text=True, check=True).stdout
        self.assertIn("T contact_fmi3DoStep", names)
        self.assertIn("T contact_fmi2DoStep", names)
        needs = subprocess.run(["nm", "-D", "--undefined-only", fmu.library._name], capture_output=True, text=True, check=True).stdout
        needed = set(re.findall(r"U (\w+)", needs))
        self.assertLessEqual(needed, {"free", "malloc", "memcpy", "memset", "snprintf", "strcmp", "strlen", "__stack_chk_fail", "__memcpy_chk", "__snprintf_chk"})

    def test_windows(self):
        compiler, wine = shutil.which("x86_64-w64-mingw32-gcc"), shutil.which("wine")
        if not compiler or not wine:
            self.skipTest("no mingw-w64 or no wine")
        fmu = self.fmu("--fmi", "3.0")
        self.assertIn(f"binaries/x86_64-windows/{fmu.model}.dll", fmu.names)
        (self.folder / "import.c").write_text(WINDOWS)
        subprocess.run([compiler, self.folder / "import.c", "-o", self.folder / "import.exe"], check=True)
        done = subprocess.run([wine, self.folder / "import.exe", fmu.folder / "binaries/x86_64-windows" / f"{fmu.model}.dll", fmu.token, "7e-4", "2345"],
                              capture_output=True, text=True, timeout=300,
                              env={**os.environ, "WINEDEBUG": "-all", "WINEDLLOVERRIDES": "mscoree,mshtml=", "WINEPREFIX": str(self.folder / "wine"), "DISPLAY": ""})
        own = self.looked_up(7e-4, 2345.0)
        wrote, read, fx, fy = done.stdout.split()
        self.assertEqual((wrote, read), ("0", "0"), done.stderr)
        np.testing.assert_allclose([float(fx), float(fy)], [own["Fx"], own["Fy"]], rtol=1e-9)

    def test_input_that_makes_no_fmu(self):
        def refused(word, *arguments, code=2, **more):
            done = self.program("fmu", *arguments, **more)
            self.assertEqual(done.returncode, code, done.stderr)
            self.assertIn(word, done.stderr)

        out = self.folder / "none.fmu"
        refused("'2fast' cannot name an FMU", self.table, "-o", out, "--name", "2fast")
        refused("The table has no 'Fq'", self.table, "-o", out, "--columns", "Fq")
        refused("cannot be read", self.folder / "scene.toml", "-o", out)
        refused("has no binary", self.table, "-o", out, env={**os.environ, "PATH": "/nowhere"})
        refused("table.h5", self.table, "-o", self.table)
        self.assertFalse(out.exists())
        sources = self.program("fmu", self.table, "-o", out, "--sources-only", env={**os.environ, "PATH": "/nowhere"})
        self.assertEqual(sources.returncode, 0, sources.stderr)
        with zipfile.ZipFile(io.BytesIO(out.read_bytes())) as archive:
            self.assertEqual(archive.namelist(), ["modelDescription.xml", "sources/buildDescription.xml", "sources/none.c"])
        first = out.read_bytes()
        self.program("fmu", self.table, "-o", out, "--sources-only")
        self.assertEqual(out.read_bytes(), first)


if __name__ == "__main__":
    unittest.main()
