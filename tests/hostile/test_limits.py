"""Depth, size and time: nothing that is nested, slow, full, closed or not to be entered ends the program, or holds it."""

import contextlib
import http.client
import json
import os
import re
import signal
import socket
import subprocess
import sys
import time
import unittest
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import doors
from test_files_of_others import BODIES, SCENE, SCENES, STUDY, SWEEP, InFolder

FULL = Path("/dev/full")


class Depth(InFolder):
    def test_dotted_keys(self):
        for text in ("a." * 100000 + "b = 1", "[" + "a." * 100000 + "b]", "a = { " + "b." * 100000 + "c = 1 }",
                     SCENE + "[sweep]\n" + "a." * 100000 + "b = 1", "a." * 900 + "a = [{" + "b." * 900 + "c = 1}]"):
            scene = self.file("k.toml", text)
            for command in (["check"], ["solve"], ["sweep", "-o", "s.h5"], ["study", "-o", "d"], ["table", "-o", "t.h5"]):
                with self.subTest(f"{command[0]} {text[:20]}"):
                    self.refused(command[0], scene, *command[1:], saying="1000 levels deep")

    @unittest.skipUnless(doors.HAS_PYTHON, "no Python module")
    def test_dotted_keys_in_python(self):
        code, message = doors.run(sys.executable, "-c", "import bem_contact as b\ntry:\n    b.solve('a.' * 300000 + 'b = 1\\n')\n"
                                  "except b.InputError as error:\n    print(error); raise SystemExit(7)")
        self.assertEqual(code, 7, message)

    def test_nested_groups(self):
        h5py = self.h5py()
        self.done("solve", SCENES / "steady_rolling.toml", "-o", "r.h5")
        with h5py.File(self.folder / "r.h5", "r+") as group:
            for _ in range(2000):
                group = group.create_group("a")
        for words in (["info", "r.h5"], ["report", "r.h5", "-o", "r.html"], ["solve", "r.h5"]):
            began = time.process_time()
            self.refused(*words, saying="cannot be read", timeout=20)
            self.assertLess(time.process_time() - began, 5)

    def test_a_bomb(self):
        self.h5py()
        self.done("solve", SCENES / "hertz.toml", "-o", "r.h5")
        subprocess.run([sys.executable, "-c", "import h5py\nset = h5py.File('r.h5', 'r+').create_dataset('bomb', (134_000_000,), 'f8', "
                        "chunks=(6_700_000,), compression=9)\nfor k in range(20): set[k * 6_700_000:(k + 1) * 6_700_000] = 0"],
                       cwd=self.folder, check=True)
        self.assertLess((self.folder / "r.h5").stat().st_size, 2_000_000)
        self.refused("info", "r.h5", saying="of memory")

    def h5py(self):
        try:
            import h5py
        except ImportError:
            self.skipTest("no h5py")
        return h5py

    def refused(self, *words, saying, **options):
        code, message = self.run_program(*words, **options)
        self.assertEqual(code, 2, message)
        self.assertIn(saying, message)

    def test_a_tiny_load(self):
        base = SCENE.replace("load.force=8e4\n", "").replace("grid.dx=1.0\ngrid.ds=0.6\n", "grid.accuracy=0.02\n")
        for load in ("load.force=1e-30", "load.force=1e-12", "load.approach=1e-30"):
            self.refused("solve", self.file("t.toml", load + "\n" + base), saying="rounded", timeout=60)


class Streams(InFolder):
    def test_standard_error_is_full_or_closed(self):
        scene = self.file("s.toml", STUDY.replace("8e4", "1e5"))
        for k, where in enumerate((f"2>{FULL}", "2>&-")):
            done = subprocess.run(f"exec {doors.PROGRAM} study {scene} -o {self.folder}/d{k} {where}", shell=True,
                                  stdout=subprocess.DEVNULL, timeout=120)
            self.assertEqual(done.returncode, 0, where)
            self.assertTrue((self.folder / f"d{k}/study.h5").exists())

    def test_no_order_for_a_terminal(self):
        try:
            import h5py
        except ImportError:
            self.skipTest("no h5py")
        self.done("solve", SCENES / "hertz.toml", "-o", "r.h5")
        with h5py.File(self.folder / "r.h5", "r+") as file:
            file.attrs["frame"] = "\x1b]0;evil\x07\x1b[31m"
            file.attrs["scene_text"] = "a = 1 # \x1b[2J"
        evil = self.file("e.txt", "\x1b[31m 1\n" * 9)
        body = self.file("b.toml", '[body]\nkind = "\x1b[31m"\n')
        named = self.file("\x1b[31m.toml", SCENE)
        case = self.file("c.inp", " 3 MODULE\n \x1b[31m\n")
        for words in (["info", "r.h5"], ["info", "--scene", "r.h5"], ["profile", evil, "--kind", "rail"], ["check", body], ["info", evil],
                      ["from-contact", case, "-o", "f"], ["check", named], ["sweep", named, "-o", "s.h5"], ["\x1b[31m"],
                      ["solve", named, "--model", "\x1b[31m"]):
            done = subprocess.run([doors.PROGRAM, *map(str, words)], cwd=self.folder, capture_output=True)
            self.assertNotIn(b"\x1b", done.stdout + done.stderr, words)

    def test_names_of_two_lines(self):
        name = "a\nb.whl"
        self.file(name, (BODIES / "hollow_wheel.txt").read_bytes())
        code, message = self.run_program("conicity", "--wheels", name, "--rails", "60E1", "--csv", "m.csv")
        self.assertEqual(code, 2, message)
        self.assertFalse((self.folder / "m.csv").exists())

    def test_no_temporary_folder_stays(self):
        temporary = self.folder / "t"
        temporary.mkdir()
        sweep = self.file("w.toml", (SCENES / "wear_collective.toml").read_text())
        for words in (["creep-curves", SCENES / "steady_rolling.toml", "--xi=0:4e-3:401", "--jobs", "2", "-o", "c.h5"],
                      ["wear", sweep, "-o", "w", "--depth", "1", "--jobs", "2"]):
            for how in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
                with self.subTest(f"{words[0]} {how}"):
                    run = subprocess.Popen([doors.PROGRAM, *map(str, words)], cwd=self.folder, stdout=subprocess.DEVNULL,
                                           stderr=subprocess.DEVNULL, env=os.environ | {"TMPDIR": str(temporary)})
                    until = time.monotonic() + 60
                    while not list(temporary.iterdir()) and run.poll() is None and time.monotonic() < until:
                        time.sleep(0.01)
                    time.sleep(0.3)
                    run.send_signal(how)
                    self.assertEqual(run.wait(60), -how)
                    self.assertEqual(list(temporary.iterdir()), [])

    @unittest.skipUnless(os.geteuid() == 0, "only root can be somebody else")
    def test_a_folder_that_may_not_be_entered(self):
        closed = self.folder / "closed"
        closed.mkdir(mode=0o700)
        self.file("s.toml", SWEEP)
        self.folder.chmod(0o777)
        words = (["conicity", "--wheel", closed / "a.whl", "--rail", "60E1"], ["conicity", "--wheels", f"{closed}/*.whl", "--rails", "60E1"],
                 ["profile", f"{closed}/a#2", "--kind", "wheel"], ["sweep", "s.toml", "--join", closed / "x.h5", "-o", "j.h5"],
                 ["sweep", "s.toml", "--join", closed, "-o", "j.h5"], ["solve", closed / "s.toml"], ["solve", "s.toml", "-o", closed / "r.h5"],
                 ["study", "s.toml", "-o", closed / "d"], ["wear", "s.toml", "-o", closed / "d"], ["info", closed / "r.h5"],
                 ["report", closed / "r.h5", "-o", "r.html"], ["from-contact", closed / "c.inp", "-o", "f"],
                 ["new", "--wheel", closed / "a.whl", "--rail", "60E1"], ["check", closed / "s.toml"], ["explore", closed / "s.toml"])
        for one in words:
            with self.subTest(one):
                code, message = self.run_program(*one, user=65534, group=65534, extra_groups=[])
                self.assertEqual(code, 2, message)
                self.assertNotIn("did not foresee", message)


class Explore(InFolder):
    """Who does not know the token holds nobody up."""

    def start(self, **options):
        self.run = subprocess.Popen([doors.PROGRAM, "explore", "--no-browser"], stdout=subprocess.PIPE, text=True, **options)
        self.addCleanup(self.run.wait)
        self.addCleanup(self.run.kill)
        self.addCleanup(self.run.stdout.close)
        self.run.stdout.readline()
        host, self.path = re.fullmatch(r"http://(127\.0\.0\.1:\d+)(/\w+/)\n", self.run.stdout.readline().lstrip()).groups()
        self.host, self.port = host, int(host.split(":")[1])

    def ask(self, window):
        connection = http.client.HTTPConnection(self.host, timeout=60)
        connection.request("POST", self.path + "answer", json.dumps({"text": SCENE, "window": str(window)}),
                           {"Content-Type": "application/json"})
        answer = connection.getresponse()
        answer.read()
        connection.close()
        return answer.status

    def slow(self, count):
        opened = []
        for _ in range(count):
            wire = socket.create_connection(("127.0.0.1", self.port), timeout=30)
            wire.sendall(b"GET /x HTTP/1.1\r\nX: ")
            opened.append(wire)
        return opened

    def end(self, how=signal.SIGINT):
        began = time.monotonic()
        self.run.send_signal(how)
        self.assertEqual(self.run.wait(30), 0)
        return time.monotonic() - began

    def test_200_slow_clients(self):
        self.start()
        wires = self.slow(200)
        began = time.monotonic()
        self.assertEqual(self.ask("a"), 200)
        self.assertLess(time.monotonic() - began, 20)
        wires += self.slow(200)
        self.assertLess(self.end(), 2)
        for wire in wires:
            wire.close()

    def test_a_request_has_a_whole_time(self):
        self.start()
        [wire] = self.slow(1)
        began, cut_off = time.monotonic(), False
        while not cut_off and time.monotonic() - began < 20:
            with contextlib.suppress(BlockingIOError, TimeoutError):
                try:
                    wire.sendall(b"X")
                    wire.settimeout(0.2)
                    cut_off = wire.recv(100) == b""
                except (BrokenPipeError, ConnectionResetError):
                    cut_off = True
        self.assertLess(time.monotonic() - began, 6)
        wire.close()
        self.assertLess(self.end(), 2)

    def test_60_questions_at_once(self):
        self.start()
        with ThreadPoolExecutor(60) as all_at_once:
            self.assertEqual(list(all_at_once.map(self.ask, range(60))), [200] * 60)
        self.assertLess(self.end(signal.SIGTERM), 2)

    def test_a_full_standard_output(self):
        with open(FULL, "w") as out:
            done = subprocess.run([doors.PROGRAM, "explore", "--no-browser"], stdout=out, stderr=subprocess.PIPE, text=True, timeout=20)
        self.assertEqual(done.returncode, 1)
        self.assertIn("address", done.stderr)

    def test_the_token_is_nobodys_to_see(self):
        seen = self.folder / "seen"
        program = self.file("xdg-open", f"#!/bin/sh\nprintf %s \"$1\" > {seen}\n")
        program.chmod(0o755)
        self.start_with_browser({"DISPLAY": ":9", "PATH": f"{self.folder}:{os.environ['PATH']}"})
        until = time.monotonic() + 30
        while not (seen.exists() and seen.read_text()) and time.monotonic() < until:
            time.sleep(0.02)
        page = Path(seen.read_text())
        self.assertNotIn(self.path.strip("/"), str(page))
        self.assertIn(self.path, page.read_text())
        self.assertEqual(page.parent.stat().st_mode & 0o077, 0)
        time.sleep(0.5)
        self.assertEqual([child for child in self.children() if child[0] == "Z"], [])
        self.assertLess(self.end(), 2)
        self.assertFalse(page.exists())

    def children(self):
        """State and parent of each child of the server."""
        for file in Path("/proc").glob("[0-9]*/stat"):
            with contextlib.suppress(OSError):
                state, parent = file.read_text().rpartition(") ")[2].split()[:2]
                if int(parent) == self.run.pid:
                    yield state, parent

    def start_with_browser(self, environment):
        self.run = subprocess.Popen([doors.PROGRAM, "explore"], stdout=subprocess.PIPE, text=True, env=os.environ | environment)
        self.addCleanup(self.run.wait)
        self.addCleanup(self.run.kill)
        self.addCleanup(self.run.stdout.close)
        self.run.stdout.readline()
        self.host, self.path = re.fullmatch(r"http://(127\.0\.0\.1:\d+)(/\w+/)\n", self.run.stdout.readline().lstrip()).groups()


@unittest.skipUnless(doors.HAS_PYTHON, "no Python module")
class Python(unittest.TestCase):
    def code_of(self, text):
        return doors.run(sys.executable, "-c", "import bem_contact as b\n" + text, cwd=doors.SOURCE)

    def test_objects_without_an_inside(self):
        for text in ('o=b.Result.__new__(b.Result); o["pmax"]', 'o=b.Result.__new__(b.Result); o.save("x.h5")',
                     "o=b.Table.__new__(b.Table); o.axes", "o=b.Sequence.__new__(b.Sequence); o.solve()",
                     "import copy; copy.copy(b.Result.__new__(b.Result))", "class C(b.Result): pass\nC.__new__(C).pmax",
                     "object.__new__(b.Result).pmax", "import os; os.fspath(b.Profile.__new__(b.Profile))"):
            code, message = self.code_of(text)
            self.assertEqual(code, 1, message)
            self.assertIn("TypeError", message)

    def test_a_daemon_thread(self):
        for call in ("b.profile('data/bodies/hollow_wheel.txt', 'wheel')", "b.standards()", "b.conicity({'rail.profile': '60E1', 'wheel.profile': 'S1002'})",
                     "b.check('data/scenes/hertz.toml')"):
            for _ in range(4):
                code, message = self.code_of(f"import threading, time\ndef work():\n    while True: {call}\n"
                                             "threading.Thread(target=work, daemon=True).start(); time.sleep(0.5)")
                self.assertEqual(code, 0, f"{call} {message}")

    def test_large_numbers(self):
        for value in ("10 ** 30", "[10 ** 400, 1]", "-10 ** 20"):
            code, message = self.code_of(f"b.solve('data/scenes/hertz.toml', {{'load.force': {value}}})")
            self.assertEqual(code, 1)
            self.assertNotIn("OverflowError", message)


if __name__ == "__main__":
    unittest.main()
