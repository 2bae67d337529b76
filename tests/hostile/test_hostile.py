"""Bad input through every way in. It is refused with its reason: never a crash, never a number, never a lost file."""

import contextlib
import csv
import json
import math
import os
import re
import resource
import signal
import socket
import stat
import subprocess
import tempfile
import threading
import time
import unittest
from pathlib import Path

import doors
import keys

SCENES = doors.SCENES
WHEEL_RAIL = {"kind": "wheel_rail", "rail.profile": "60E1", "wheel.profile": "S1002", "load.force": 1e5,
              "solver.model": "halfspace"}
PATCH = {"kind": "patch", "load.force": 1e5, "motion.frictionless": True, "grid.dx": 0.4, "grid.ds": 0.3, "grid.mx": 40,
         "grid.ms": 40, "gap.a": 1e-3, "gap.b": 1.6e-3}
GRAMMAR = re.compile(r"\(.+\) \S", re.S)  # <problem> (<why>) <what to do>


def toml_of(values):
    return "".join(f"{key} = {json.dumps(v) if not isinstance(v, float) else repr(v)}\n" for key, v in values.items())



class Hostile(unittest.TestCase):
    count = 0

    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.folder = Path(cls.temporary.name)
        cls.c = doors.CLibrary(os.environ["CONFORMAL_LIBRARY"])

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()
        print(f"{Hostile.count} bad inputs", flush=True)

    def refused(self, answer, *words, code=2):
        Hostile.count += 1
        found, message = answer
        self.assertEqual(found, code, message)
        self.assertRegex(message, GRAMMAR)
        self.assertNotIn("did not foresee", message)
        self.assertLess(len(message), 5000)
        self.assertTrue(words and all(words), "which reason?")
        for word in words:
            self.assertIn(word, message)

    def write(self, name, text):
        (self.folder / name).write_bytes(text if isinstance(text, bytes) else text.encode())
        return self.folder / name

    def scene(self, base, **changes):
        return self.write("scene.toml", toml_of(base | {k.replace("__", "."): v for k, v in changes.items()}))


class Keys(Hostile):
    """Each key of a scene with values that it cannot have, through C and Python."""

    def each_door(self, base, key, value, *words):
        scene = self.write("base.toml", toml_of({k: v for k, v in base.items() if k != key}))
        with self.subTest(key=key, value=value):
            if doors.HAS_PYTHON:
                self.refused(doors.python(scene, {key: value}), *words)
            self.refused(self.c.change(scene, key, value), *words)

    def test_wrong_types(self):
        for key in keys.all_keys():
            base = WHEEL_RAIL if key.wheel_rail else PATCH
            self.each_door(base, key.name, 1 if key.kind == "text" else "some text", key.name)

    def test_misspelt(self):
        for key in keys.all_keys():
            self.each_door(WHEEL_RAIL if key.wheel_rail else PATCH, keys.misspelt(key.name), 1, "unknown key")

    def test_not_a_number(self):
        for key in keys.all_keys():
            if key.kind in ("number", "list of numbers"):
                base = WHEEL_RAIL if key.wheel_rail else PATCH
                for value in (math.nan, math.inf):
                    self.each_door(base, key.name, value, key.name)

    def test_out_of_range(self):
        for key in keys.all_keys():
            if key.kind in ("number", "whole number"):
                base = WHEEL_RAIL if key.wheel_rail else PATCH
                for value in key.out_of_range():
                    if not ("0: " in key.words and value == 0):
                        self.each_door(base, key.name, value, key.name)

    def test_unknown_choices(self):
        for key in keys.all_keys():
            for choice in key.choices()[:1]:
                self.each_door(WHEEL_RAIL if key.wheel_rail else PATCH, key.name, choice + "x", choice)

    def test_keys_of_the_other_kind(self):
        for key in keys.all_keys():
            if not key.patch or not key.wheel_rail:
                value = key.choices()[0] if key.choices() else {"text": "x", "true or false": 1}.get(key.kind, 1)
                self.each_door(WHEEL_RAIL if not key.wheel_rail else PATCH, key.name, value, key.name)


class Texts(Hostile):
    """What is no scene, through C, or through the program where C's strings cannot hold it."""

    CASES = {
        "empty": ("", "load"), "no TOML": ("]]]", "not valid TOML"), "half a line": ("kind =", "not valid TOML"),
        "open text": ('kind = "wheel', "not valid TOML"), "twice": (toml_of(PATCH) + "load.force = 2\n", "TOML"),
        "NUL": (b"kind = \"wheel_rail\"\0", "TOML"), "no UTF-8": (b"kind = \"\xff\xfe\"", "TOML"),
        "binary": (bytes(range(256)) * 40, "TOML"), "unknown table": ("[loadd]\nforce = 1\n" + "", "loadd"),
        "table for a value": ("[kind]\na = 1\n", "kind"), "value for a table": ("load = 3\n", "load"),
        "list for a value": (toml_of(PATCH | {"load.force": 1}).replace("load.force = 1", "load.force = [1, 2]"),
                             "a list"),
        "date": (toml_of(PATCH).replace("load.force = 100000.0", "load.force = 2020-01-01"), "a date"),
        "deep": ("a" + ".a" * 300 + " = 1\n", "unknown table"), "brackets": ("a = " + "[" * 20000, "TOML"),
        "two loads": (toml_of(PATCH | {"load.approach": 0.1}), "load.force is given too"),
        "no load": (toml_of({k: v for k, v in PATCH.items() if k != "load.force"}), "neither force nor approach"),
        "no friction": (toml_of(PATCH | {"motion.frictionless": False, "motion.friction": 0}), "zero friction"),
        "no grid": (toml_of({k: v for k, v in PATCH.items() if k != "grid.mx"}), "grid.mx"),
        "no rail": (toml_of({k: v for k, v in WHEEL_RAIL.items() if k != "rail.profile"}), "rail.profile"),
        "no wheel": (toml_of({k: v for k, v in WHEEL_RAIL.items() if k != "wheel.profile"}), "wheel.profile"),
        "wheel as rail": (toml_of(WHEEL_RAIL | {"rail.profile": "S1002"}), "profile of a wheel"),
        "rail as wheel": (toml_of(WHEEL_RAIL | {"wheel.profile": "60E1"}), "profile of a rail"),
        "unknown profile": (toml_of(WHEEL_RAIL | {"rail.profile": "60E3"}), "60E1"),
        "narrow gauge": (toml_of(WHEEL_RAIL | {"position.gauge": 1000.0}), "back_to_back"),
        "far away": (toml_of(WHEEL_RAIL | {"position.lateral": 1e6}), "lateral"),
        "fem without files": (toml_of(WHEEL_RAIL | {"solver.model": "fem"}), "influence"),
        "rows backwards": (toml_of(WHEEL_RAIL | {"grid.s_from": 5.0, "grid.s_to": 1.0}), "s_to"),
        "rates without speed": (toml_of(WHEEL_RAIL | {"motion.yaw_rate": 1.0}), "motion.speed"),
        "steady steps": (toml_of(WHEEL_RAIL | {"motion.steps": 4}), "steady rolling has no steps"),
        "forces without friction": (toml_of(PATCH | {"load.force_x": 5.0}), "no shear force"),
        "beyond elasticity": (toml_of(PATCH | {"load.force": 1e12}), "far beyond elastic contact"),
        "tiny elements": (toml_of(WHEEL_RAIL | {"grid.dx": 1e-6, "grid.ds": 1e-6}), "too small for this contact"),
        "bracket alone": (toml_of(PATCH) + "[\ngap.c = 1\n", "not valid TOML"),
        "bracket in a table": (toml_of(PATCH) + "[sweep]\n[[\nload.force = [1e4]\n", "not valid TOML"),
        "long fraction": (toml_of(PATCH) + "gap.c = 1/" + "9" * 400 + "\n", "not valid TOML"),
        "fraction of a version": (toml_of(PATCH) + "gap.c = 1.2.3/40\n", "not valid TOML"),
        "digits": (toml_of(PATCH) + "gap.c = " + "1" * 1_000_000 + "/\n", "TOML"),
        "long key": ("a" * 1_000_000 + " = 1\n", "unknown key"),
        "long value": (toml_of(WHEEL_RAIL | {"rail.profile": "a" * 1_000_000}), "Unknown profile"),
        "no points": (toml_of(PATCH) + "stresses = { depths = [1.0], x = [] }\n", "stresses.x"),
        "no rows of points": (toml_of(PATCH) + "stresses = { depths = [1.0], s = [] }\n", "stresses.s"),
        "no creepage": (toml_of(WHEEL_RAIL | {"motion.speed": 1e-300, "motion.yaw_rate": 1e300}), "motion.speed"),
        "no creepage sideways": (toml_of(WHEEL_RAIL | {"motion.speed": 1e-300, "motion.lateral_velocity": 1e300}), "motion.speed"),
        "no spin": (toml_of(WHEEL_RAIL | {"motion.phi": 1.7e308}), "rigid slip"),
        "no spin of a patch": (toml_of(PATCH | {"motion.frictionless": False, "motion.phi": 1.7e308}), "rigid slip"),
        "circles without a strip": (toml_of(PATCH | {"strip.upper_radius": 100.0}), "strip.radius"),
    }

    def test_texts(self):
        for name, (text, words) in self.CASES.items():
            with self.subTest(name):
                text = text.encode() if isinstance(text, str) else text
                if b"\0" not in text and b"\xff" not in text:
                    self.refused(self.c.text(text.decode()), words)
                else:
                    self.refused(doors.program("solve", self.write("scene.toml", text)), words)

    def test_sweeps(self):
        for name, (lines, words) in {
                "single": ("load.force = 5", "a single value"), "empty": ("load.force = []", "empty"),
                "unknown": ("load.forse = [1.0]", "load.force"), "endless": (
                    "load.force = { from = 1, to = 1e9, step = 1e-9 }", "never ends"),
                "backwards": ("load.force = { from = 2, to = 1, step = 1 }", "does not lead from 2 to 1"),
                "no step": ("load.force = { from = 1, to = 2, step = 0 }", "a step of 0 does not lead"),
                "mode": ('mode = "zig"\nload.force = [1.0]', "product"),
                "unequal": ('mode = "zip"\nload.force = [1.0, 2.0]\nmotion.friction = [0.1]', "cannot be zipped"),
                "tables": ("load.force = [{}]", "no value"), "nothing": ("", "describes no sweep")}.items():
            with self.subTest(name):
                scene = self.write("sweep.toml", toml_of(PATCH) + f"[sweep]\n{lines}\n")
                self.refused(doors.program("sweep", scene, "-o", self.folder / "out.h5"), words)
                self.assertFalse((self.folder / "out.h5").exists())
        self.refused(doors.program("sweep", self.scene(PATCH), "-o", self.folder / "out.h5"), "sweep")


class Files(Hostile):
    """Files that are none, or that others broke."""

    def test_scenes(self):
        loop = self.folder / "loop.toml"
        loop.symlink_to("loop.toml")
        for name, words in ((self.folder / "none.toml", "no such file"), (self.folder, "folder"), ("", "no such file"),
                            (loop, "no such file"), ("x" * 5000, "no such file")):
            with self.subTest(str(name)[:50]):
                self.refused(self.c.file(name), words)
        for command in ("solve", "compare", "check"):
            self.refused(doors.program(command, loop), "no such file")

    def test_profiles(self):
        line = "".join(f"{y} {0.001 * y * y}\n" for y in range(-35, 36))
        for name, text, words in (
                ("empty", "", "has 0 points"), ("one point", "0 0\n", "has 1 point"),
                ("words", "a b\nc d\n", "'c d' is not a point"),
                ("three columns", "1 2 3\n" * 9, "3 columns"), ("nan", line + "nan nan\n", ":72: a coordinate is not a number"),
                ("infinite", "inf 0\n" + line, "not a number"), ("huge numbers", line + "1e400 0\n", "'1e400 0' is not a point"),
                ("same point", "1 1\n" * 100, "is 0 mm wide"), ("commas", line.replace(".", ","), "decimal commas"),
                ("tiny", "".join(f"{1e-3 * y} 0\n" for y in range(9)), "is 0.008 mm wide"),
                ("wide", "".join(f"{100 * y} 0\n" for y in range(9)), "is 800 mm wide"),
                ("binary", bytes(range(256)) * 9, "it is no text"), ("NUL", line + "\0\0\0\0", "it is no text"),
                ("zig-zag", "".join(f"{y} {(-1) ** y * 20}\n" for y in range(70)), "back and forth"),
                ("ten million lines", "\n" * 10_000_001, "more than 10000000 points")):
            with self.subTest(name):
                self.write("profile.txt", text)
                self.refused(self.c.file(self.scene(WHEEL_RAIL, rail__profile="profile.txt")), words)

    def test_endless_files(self):
        zeros = self.folder / "zeros"
        try:
            os.mknod(zeros, 0o600 | stat.S_IFCHR, os.makedev(1, 5))  # a node of our own, as /dev/zero
        except OSError:
            self.skipTest("only root can make a device")
        for changes in ({"rail__profile": "zeros"}, {"wheel__profile": "zeros"}, {"motion__friction_table": "zeros"},
                        {"rail__influence": "zeros", "wheel__influence": "zeros", "solver__model": "fem"}):
            with self.subTest(changes):
                self.refused(self.c.file(self.scene(WHEEL_RAIL, **changes)), "zeros")
        self.refused(doors.program("solve", zeros), "device")
        self.refused(doors.program("info", zeros), "a device")
        sparse = self.write("sparse.txt", "")
        os.truncate(sparse, 1 << 40)
        self.refused(self.c.file(self.scene(WHEEL_RAIL, rail__profile="sparse.txt")), "1000000000 bytes")

    def test_influence_files(self):
        good = (doors.SOURCE / "data" / "influence" / "small_rail.h5").read_bytes()
        for name, data, words in (
                ("empty", b"", "its first line is not"), ("text", b"hello\n" * 99, "its first line is not"),
                ("half", good[:len(good) // 2], "is truncated"), ("short", good[:-1], "is truncated"),
                ("long", good + b"x", "was altered"), ("seal", b"x" + good[1:], "its first line is not"),
                ("a byte", good[:5000] + bytes([good[5000] ^ 1]) + good[5001:], "was altered")):
            self.write("broken.h5", data)
            scene = self.write("scene.toml", (SCENES / "conformal_small.toml").read_text().replace(
                "../influence/small_rail.h5", "broken.h5").replace("../influence", str(SCENES.parent / "influence")))
            with self.subTest(name):
                self.refused(self.c.file(scene), words)
                self.refused(doors.program("info", self.folder / "broken.h5"),
                             {"empty": "not HDF5", "text": "not HDF5", "seal": "is not a file of this project"}.get(name, words))
                self.refused(doors.program("influence", "expand", self.folder / "broken.h5", "--dx", "0.5", "--ds", "0.5",
                                           "--mx", "4", "--my", "4", "-o", self.folder / "out.h5"), words)
        pipe = self.folder / "pipe.h5"
        os.mkfifo(pipe)
        self.refused(doors.program("info", pipe), "a device")

    def test_tables(self):
        for name, text in (("empty", ""), ("header", "ix,is,h\n"), ("columns", "a,b,c\n1,2,3\n"),
                           ("words", "ix,is,h\n0,0,x\n"), ("missing", "ix,is,h\n0,0,1\n"), ("nan", "ix,is,h\n0,0,nan\n"),
                           ("outside", "ix,is,h\n99,0,1\n"), ("short", "ix,is,h\n0,0\n")):
            with self.subTest(name):
                self.write("gap.csv", text)
                scene = toml_of({k: v for k, v in PATCH.items() if not k.startswith("gap")} | {"gap.table": "gap.csv"})
                self.refused(self.c.file(self.write("scene.toml", scene)), "gap")
        self.refused(self.c.file(self.scene(PATCH, motion__frictionless=False, motion__friction_table="none.csv")),
                     "no such file")


@unittest.skipUnless(doors.HAS_PYTHON, "the Python module is not built")
class Storage(Hostile):
    """HDF5 files that somebody damaged or made to do harm, all read in this process: a crash ends it."""

    LONG = "p_n"

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        import bem_contact
        import h5py
        cls.b, cls.h5py = bem_contact, h5py
        cls.result, cls.table = cls.folder / "result.h5", cls.folder / "table.h5"
        code, message = doors.program("solve", SCENES / "steady_rolling.toml", "-o", cls.result)
        assert code == 0, message
        cls.b.table(PATCH | {"grid.mx": 16, "grid.ms": 16, "solver.model": "halfspace"}, {"load.force": [1e3, 2e3]},
                    tolerance=1, output=cls.table)

    def answer(self, action):
        try:
            action()
        except self.b.InputError as error:
            return 2, str(error)
        return 0, ""

    def report(self, file):
        return self.answer(lambda: self.b.report(file, self.folder / "page.html"))

    def changed(self, how):
        file = self.write("changed.h5", self.result.read_bytes())
        with self.h5py.File(file, "r+") as h5:
            del h5[self.LONG]
            how(h5)
        return file

    def test_foreign_storage(self):
        pipe, secret = self.folder / "storage.pipe", self.write("secret", "stolen words, " * 200)
        os.mkfifo(pipe)
        (self.folder / "page.html").unlink(missing_ok=True)
        for name in (pipe, secret):
            self.refused(self.report(self.changed(lambda h5: h5.create_dataset(
                self.LONG, (100,), "f8", external=[(str(name), 0, 800)]))), "lies in another file")
            layout = self.h5py.VirtualLayout((100,), "f8")
            layout[:] = self.h5py.VirtualSource(str(name), "x", (100,))
            self.refused(self.report(self.changed(lambda h5: h5.create_virtual_dataset(self.LONG, layout))),
                         "lies in another file")
        self.assertFalse((self.folder / "page.html").exists())

    def test_bombs(self):
        for options in ({}, {"chunks": (1000,)}, {"chunks": (1000,), "compression": "gzip"},
                        {"chunks": (1000,), "fletcher32": True}):
            self.refused(self.report(self.changed(lambda h5: h5.create_dataset(
                self.LONG, (20_000_000_000,), "f8", fillvalue=1.0, **options))), self.LONG, "are stored")

    def test_short_chunks(self):
        for size in (1, 2, 3, 4, 12, 803):
            def short(h5, size=size):
                data = h5.create_dataset(self.LONG, (100,), "f8", chunks=(100,), fletcher32=True)
                data.id.write_direct_chunk((0,), b"x" * size)
            self.refused(self.report(self.changed(short)), self.LONG, "damaged")

        import zlib
        def short_deflated(h5):
            data = h5.create_dataset(self.LONG, (100_000,), "f8", chunks=(100_000,), compression="gzip")
            data.id.write_direct_chunk((0,), zlib.compress(b"12345678"))
        self.refused(self.report(self.changed(short_deflated)), self.LONG, "damaged")

    def test_a_kernel_elsewhere(self):
        import hashlib
        small = SCENES.parent / "influence" / "small_rail.h5"
        self.write("kernel.h5", small.read_bytes())
        with self.h5py.File(self.folder / "kernel.h5", "r+") as h5:
            h5["kernel"][...] *= 1.5
        linked = self.write("linked.h5", small.read_bytes())
        with self.h5py.File(linked, "r+") as h5:
            del h5["kernel"]
            h5["kernel"] = self.h5py.ExternalLink(str(self.folder / "kernel.h5"), "/kernel")
        data = linked.read_bytes()
        lines = data[:512].rstrip(b"\0").decode().splitlines()[:2]
        lines += [f"bytes {len(data)}", f"sha256 {hashlib.sha256(data[512:]).hexdigest()}"]
        linked.write_bytes("\n".join([*lines, ""]).encode().ljust(512, b"\0") + data[512:])
        text = (SCENES / "conformal_small.toml").read_text().replace("../influence/small_rail.h5", "linked.h5").replace(
            "../influence", str(SCENES.parent / "influence"))
        self.refused(doors.python(self.write("linked.toml", text), {}), "'kernel'", "a link to another place")

    def test_flipped_bits(self):
        table, result = self.table.read_bytes(), self.result.read_bytes()
        whole = self.b.read_table(self.table)
        for at in range(0, len(table), 197):
            file = self.write("flip.h5", table[:at] + bytes([table[at] ^ 1 << at % 8]) + table[at + 1:])
            try:
                read = self.b.read_table(file)
                self.assertEqual(str(read.errors), str(whole.errors))  # nan is nan
                self.assertEqual(*(str({k: v.tolist() for k, v in t.values.items()}) for t in (read, whole)))
            except self.b.InputError as error:
                self.refused((2, str(error)), "flip.h5")
        for at in range(0, len(result), 9973):  # no checksums yet: numbers may be others, and nothing crashes
            file = self.write("flip.h5", result[:at] + bytes([result[at] ^ 1 << at % 8]) + result[at + 1:])
            code, message = self.report(file)
            self.assertIn(code, (0, 2), message)


class Limits(Hostile):
    """A limit on the size of files (ulimit -f) is an error with words."""

    def test_file_size(self):
        result, page = self.folder / "whole.h5", self.folder / "page.html"
        self.assertEqual(doors.program("solve", SCENES / "hertz.toml", "-o", result)[0], 0)
        sweep = self.write("limited.toml", toml_of(PATCH) + "[sweep]\nload.force = [1e5, 2e5]\n")
        wear = self.write("wear.toml", toml_of(WHEEL_RAIL | {
            "motion.xi": 2e-3, "motion.free_rolling": False, "grid.dx": 2.0, "grid.ds": 1.0}) +
                          "[sweep]\nposition.lateral = [0.0]\n")
        limited = {"preexec_fn": lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (8192, 8192))}
        for command in (["solve", SCENES / "hertz.toml", "-o", self.folder / "limited.h5"],
                        ["sweep", sweep, "-o", self.folder / "limited.h5"],
                        ["sweep", sweep, "-o", self.folder / "limited.h5", "--cases", "0:2"], ["report", result, "-o", page],
                        ["wear", wear, "-o", self.folder / "worn", "--depth", "0.02"]):
            with self.subTest(command[0]):
                self.refused(doors.program(*command, **limited), "File too large", code=1)
        self.assertFalse((self.folder / "limited.h5").exists() or page.exists())
        self.assertEqual(doors.program("sweep", sweep, "-o", self.folder / "limited.h5")[0], 0)  # goes on


class CommandLine(Hostile):
    def test_arguments(self):
        hertz = SCENES / "hertz.toml"
        small = doors.SOURCE / "data" / "influence" / "small_rail.h5"
        grid = ["--dx", "0.5", "--ds", "0.5", "--mx", "4", "--my", "4"]
        sweep = self.write("arguments.toml", toml_of(PATCH) + "[sweep]\nload.force = [1e5]\n")
        for arguments, words in (
                (["slove", hertz], "no command 'slove'"), ([hertz], "bem_contact solve"), (["solve"], "scene is required"),
                (["solve", hertz, "--modell", "fem"], "no option '--modell'"), (["solve", hertz, "--model", "femm"], "femm"),
                (["solve", hertz, hertz], "not expected"), (["sweep", sweep], "--output is required"),
                (["info"], "file is required"), (["--jsn"], "no option '--jsn'"), (["influence"], "subcommand is required"),
                (["influence", "expnd"], "influence --help"), (["influence", "expand", small], "--dx is required"),
                (["sweep", sweep, "-o", "x.h5", "--jobs", "-1"], "--jobs"),
                (["sweep", sweep, "-o", "x.h5", "--jobs", "1e9"], "--jobs"),
                (["sweep", sweep, "-o", "x.h5", "--cases", "0:3"], "the sweep has 1 case"),
                (["sweep", sweep, "-o", "x.h5", "--cases", "x"], "3200:6400"),
                (["sweep", sweep, "-o", "x.h5", "--cases", "0:18446744073709551616"], "3200:6400"),
                (["sweep", sweep, "-o", "x.h5", "--part", "0/3"], "--cases"),
                (["sweep", sweep, "-o", "x.h5", "--join", "none.h5"], "no such file"),
                (["sweep", sweep, "-o", "x.h5", "--join", small], "no part of a sweep"),
                (["influence", "expand", small, *grid, "-o", "x.dat"], "format of 'x.dat'"),
                (["influence", "expand", small, *grid[2:], "--dx", "nan", "-o", "x.h5"], "nan is no finite number"),
                (["influence", "expand", small, *grid[2:], "--dx", "-1", "-o", "x.h5"], "dx = -1"),
                (["influence", "expand", small, *grid[:4], "--mx", "0", "--my", "4", "-o", "x.h5"], "mx = 0"),
                (["influence", "expand", small, *grid[:4], "--mx", "99999", "--my", "99999", "-o", "x.h5"], "too large"),
                (["influence", "expand", small, *grid, "--centre", "1e9", "-o", "x.h5"], "leaves the contact strip")):
            with self.subTest(arguments):
                self.refused(doors.program(*arguments, cwd=self.folder), words)
        self.assertEqual([f for f in os.listdir(self.folder) if f.startswith("x.")], [])


class LittleMemory(Hostile):
    """It ends with a reason, or without a message of ours where not even the libraries find room. It never hangs."""

    def limited(self, megabytes, *arguments, **options):
        limit = megabytes << 20
        return doors.program(*arguments, **options, preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_AS, (limit, limit)),
                             env={name: value for name, value in os.environ.items() if name != "OPENBLAS_NUM_THREADS"})

    def starts(self, megabytes):
        """Whether the libraries find room before main(). Where OpenBLAS of Debian 13 finds none it tries for ever."""
        try:
            return self.limited(megabytes, "--version", timeout=5)[0] == 0
        except subprocess.TimeoutExpired:
            return False

    @unittest.skipIf("LD_PRELOAD" in os.environ, "sanitizers need terabytes of addresses")
    def test_a_limit(self):
        large = self.scene(PATCH, grid__mx=4096, grid__ms=4096)
        sweep = self.write("sweep.toml", toml_of(PATCH) + "[sweep]\ngrid.mx = [40, 4096]\nmode = 'zip'\n")
        starts = next(m for m in (*range(40, 90, 10), *range(90, 600, 30)) if self.starts(m))
        for more in (30, 80, 130, 230):
            with self.subTest(more):
                self.assertEqual(self.limited(starts + more, "--version")[0], 0)
                self.refused(self.limited(starts + more, "solve", large), "Memory ran out", "fewer elements", code=1)
        for more in (10, 60):
            code, message = self.limited(starts + more, "sweep", sweep, "-o", self.folder / f"m{more}.h5", "--jobs", "1")
            self.assertIn(code, (0, 3), message)  # a case that found no memory has died, the others are there


class Names(Hostile):
    """Names of files that are long, or that a table cannot hold."""

    def test_a_sweep_whose_names_no_table_holds(self):
        points = (doors.SOURCE / "data" / "bodies" / "hollow_wheel.txt").read_bytes()
        for name in ("=cmd|calc!A1.txt", "@SUM(1).txt", "+1.txt", "-1.txt", "new\nline.txt", "cr\rx.txt", "tab\tx.txt"):
            with self.subTest(name):
                self.write(name, points)
                sweep = self.write("names.toml", toml_of(WHEEL_RAIL) + f"[sweep]\nwheel.profile = ['S1002', {json.dumps(name)}]\n")
                self.refused(doors.program("sweep", sweep, "-o", self.folder / "n.h5", "--csv", self.folder / "n.csv"),
                             "cannot be a cell of --csv")
                self.assertFalse((self.folder / "n.h5").exists())

    def test_a_table_reads_back_what_a_sweep_wrote(self):
        name = 'worn, "left".txt'
        self.write(name, (doors.SOURCE / "data" / "bodies" / "hollow_wheel.txt").read_bytes())
        base = toml_of(WHEEL_RAIL | {"wheel.smoothing": 8.0})
        sweep = self.write("names.toml", base + f"[sweep]\nfields = false\nwheel.profile = ['S1002', {json.dumps(name)}]\n")
        table = self.folder / "n.csv"
        code, message = doors.program("sweep", sweep, "-o", self.folder / "n1.h5", "--csv", table, "--jobs", "1")
        self.assertEqual(code, 0, message)
        with open(table, newline="") as lines:
            self.assertEqual([row["wheel.profile"] for row in csv.DictReader(lines)], ["S1002", name])

    def test_long(self):
        hertz = SCENES / "hertz.toml"
        self.assertEqual(doors.program("solve", hertz, "-o", self.folder / ("a" * 250 + ".h5"))[0], 0)
        self.refused(doors.program("solve", hertz, "-o", self.folder / ("a" * 300 + ".h5")), "the name is too long")
        self.refused(doors.program("solve", self.folder / ("a" * 300 + ".toml")), "no such file")
        sweep = self.write("s.toml", toml_of(PATCH) + "[sweep]\nload.force = [1e5]\n")
        self.refused(doors.program("sweep", sweep, "-o", self.folder / ("a" * 250 + ".h5")), "the name is too long")

    @unittest.skipUnless("MESH_BODY" in os.environ, "mesh_body is not built")
    def test_a_mesh_that_was_cut_off(self):
        body, mesh = doors.SOURCE / "data" / "bodies" / "small_wheel.toml", self.folder / "wheel.msh"
        self.assertEqual(doors.run(os.environ["MESH_BODY"], body, "-o", mesh)[0], 0)
        whole = mesh.read_bytes()
        elements = whole.index(b"$EndElements\n") + len(b"$EndElements\n")
        for length in (elements, (elements + len(whole)) // 2, whole.rindex(b"$Comments")):
            mesh.write_bytes(whole[:length])
            self.refused(doors.run(os.environ["FEM_INFLUENCE"], body, mesh, "-o", self.folder / "w.h5"), "cut off")
        self.assertFalse((self.folder / "w.h5").exists())


class Outputs(Hostile):
    """Nothing that an output's name leads to is lost."""

    OUTPUTS = (("-o", "h5"), ("--vtk", "vts"))

    def solve(self, option, output):
        return doors.program("solve", SCENES / "hertz.toml", option, output)

    def nodes(self):
        null, full = self.folder / "null", self.folder / "full"
        try:
            os.mknod(null, 0o600 | stat.S_IFCHR, os.makedev(1, 3))
            os.mknod(full, 0o600 | stat.S_IFCHR, os.makedev(1, 7))
        except FileExistsError:
            pass
        except OSError:
            self.skipTest("only root can make a device")
        return null, full

    def test_refused(self):
        read_only = self.write("read-only", "mine")
        read_only.chmod(0o444)
        link, loop = self.folder / "to-read-only", self.folder / "loop"
        link.symlink_to("read-only")
        loop.symlink_to("loop")
        (self.folder / "server").unlink(missing_ok=True)
        with contextlib.closing(socket.socket(socket.AF_UNIX)) as server:
            server.bind(str(self.folder / "server"))
            for output, words in ((read_only, "protected"), (link, "protected"), (loop, "itself"),
                                  (self.folder, "folder"), (self.folder / "none" / "x", "no folder"),
                                  (read_only / "x", "no folder"), (self.folder / "server", "socket"),
                                  (SCENES / "hertz.toml", "overwrite")):
                for option, _ in self.OUTPUTS:
                    with self.subTest(f"{option} {output}"):
                        self.refused(self.solve(option, output), words)
        self.assertEqual(read_only.read_text(), "mine")
        self.assertTrue(link.is_symlink() and loop.is_symlink() and (self.folder / "server").is_socket())

    def test_devices(self):
        null, full = self.nodes()
        self.refused(self.solve("-o", null), "device")
        self.assertEqual(self.solve("--vtk", null)[0], 0)
        self.refused(self.solve("--vtk", full), "No space left", code=1)
        self.assertTrue(null.is_char_device() and full.is_char_device())

    def test_pipes(self):
        pipe = self.folder / "pipe"
        os.mkfifo(pipe)
        self.refused(self.solve("-o", pipe), "a pipe")
        found = []
        reader = threading.Thread(target=lambda: found.append(pipe.read_text()))
        reader.start()
        self.assertEqual(self.solve("--vtk", pipe)[0], 0)
        reader.join()
        self.assertTrue(found[0].startswith("<?xml") and found[0].endswith("</VTKFile>\n"))
        self.assertTrue(pipe.is_fifo())

    def test_links(self):
        (self.folder / "far").mkdir()
        for option, ending in self.OUTPUTS:
            target, link = self.folder / "far" / f"target.{ending}", self.folder / f"link.{ending}"
            target.write_text("")
            link.symlink_to(target)
            self.assertEqual(self.solve(option, link)[0], 0)
            self.assertTrue(link.is_symlink() and not target.is_symlink())
            self.assertGreater(target.stat().st_size, 1000)
        self.assertEqual(sorted(os.listdir(self.folder / "far")), ["target.h5", "target.vts"])

    def test_where_standard_output_goes(self):
        out = self.folder / "both"
        with open(out, "wb") as file:
            self.refused(doors.program("solve", SCENES / "hertz.toml", "-o", out, stdout=file), "standard output")
        with open(out, "wb") as file:
            code, _ = doors.program("solve", SCENES / "hertz.toml", "--vtk", "/dev/stdout", stdout=file)
        text = out.read_text()
        self.assertEqual(code, 0)
        self.assertTrue(text.startswith("<?xml") and "</VTKFile>" in text and "certificate" in text)

    def test_full_standard_output(self):
        _, full = self.nodes()
        hertz, small = SCENES / "hertz.toml", doors.SOURCE / "data" / "influence" / "small_rail.h5"
        sweep = self.write("full_sweep.toml", toml_of(PATCH) + "[sweep]\nload.force = [1e5]\n")
        commands = [[doors.PROGRAM, *c] for c in (
            ["--help"], ["--version"], ["--print-default"], ["solve", hertz], ["solve", hertz, "--json"],
            ["solve", "--help"], ["check", hertz], ["info", small], ["compare", SCENES / "conformal_small.toml"],
            ["compare", SCENES / "conformal_small.toml", "--json"],
            ["influence", "expand", small, "--dx", "0.5", "--ds", "0.5", "--mx", "2", "--my", "2", "-o",
             self.folder / "numbers.h5"], ["sweep", sweep, "-o", self.folder / "full.h5"])]
        if "MESH_BODY" in os.environ:
            commands += [[os.environ["MESH_BODY"], o] for o in ("--help", "--version", "--print-default")]
            commands += [[os.environ["FEM_INFLUENCE"], o] for o in ("--help", "--version")]
        for command in commands:
            with self.subTest(command), open(full, "wb") as out:
                self.refused(doors.run(*command, stdout=out), "Standard output cannot be written", code=1)

    def test_closed_standard_streams(self):
        for closed in (">&-", "2>&-", "<&- >&- 2>&-"):
            output = self.folder / "closed.h5"
            done = subprocess.run(f"exec {doors.PROGRAM} solve {SCENES}/hertz.toml -o {output} {closed}", shell=True,
                                  stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
            self.assertEqual(done.returncode, 0 if closed == "2>&-" else 1)
            self.assertEqual(doors.program("info", output)[0], 0, closed)  # nothing was printed into it

    @unittest.skipUnless("MESH_BODY" in os.environ, "mesh_body is not built")
    def test_meshes(self):
        mesh_body, body = os.environ["MESH_BODY"], doors.SOURCE / "data" / "bodies" / "small_rail.toml"
        read_only = self.write("old.msh", "mine")
        read_only.chmod(0o444)
        pipe, link = self.folder / "mesh.pipe", self.folder / "mesh.link"
        os.mkfifo(pipe)
        link.symlink_to("mesh.target")
        self.refused(doors.run(mesh_body, body, "-o", read_only), "protected")
        self.refused(doors.run(mesh_body, body, "-o", self.folder), "folder")
        self.refused(doors.run(mesh_body, body, "-o", body), "overwrite")
        found = []
        reader = threading.Thread(target=lambda: found.append(pipe.read_text()))
        reader.start()
        self.assertEqual(doors.run(mesh_body, body, "-o", pipe)[0], 0)
        reader.join()
        self.assertEqual(doors.run(mesh_body, body, "-o", link)[0], 0)
        self.assertTrue(pipe.is_fifo() and link.is_symlink())
        self.assertEqual((self.folder / "mesh.target").read_text(), found[0])
        self.refused(doors.run(os.environ["FEM_INFLUENCE"], body, self.folder / "mesh.target", "-o", pipe), "a pipe")
        self.refused(doors.run(os.environ["FEM_INFLUENCE"], body, pipe, "-o", self.folder / "x.h5"), "regular")


class Interrupted(Hostile):
    def test_a_sweep_says_how_to_go_on(self):
        forces = ", ".join(str(1e5 + i) for i in range(400))
        scene = self.write("long.toml", (SCENES / "steady_rolling.toml").read_text() +
                           f"\n[sweep]\nload.force = [{forces}]\nfields = false\n")
        output = self.folder / "long.h5"
        run = subprocess.Popen([doors.PROGRAM, "sweep", scene, "-o", output, "--jobs", "2"], stdout=subprocess.DEVNULL,
                               stderr=subprocess.PIPE, text=True)
        parts = Path(f"{output}.parts")
        while run.poll() is None and len([*parts.glob("0*.h5")]) < 3:  # the third is begun when the first is counted
            time.sleep(0.01)
        run.send_signal(signal.SIGINT)
        message = run.communicate()[1]
        self.assertEqual(run.returncode, -signal.SIGINT)
        self.assertRegex(message, r"interrupted: [1-9]\d* of 400 cases are done\. Give the same command again")
        self.assertFalse(output.exists())


if __name__ == "__main__":
    unittest.main()
