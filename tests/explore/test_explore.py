"""`bem_contact explore`: who may ask, what a browser shows, and that nothing is read or written besides."""

import http.client
import json
import os
import re
import signal
import subprocess
import tempfile
import time
import unittest
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import browser

ROOT = Path(__file__).resolve().parents[2]
HAS_FEM = (Path(os.environ["BEM_CONTACT"]).parent / "fem_influence").exists()
LOOK = (ROOT / "tests" / "report" / "look.js").read_text()
SCENE = """# a comment that stays
rail.profile = "60E1"
wheel.profile = "S1002"
load.force = 1e5
motion = { friction = 0.3, free_rolling = false }
[position]
rail_inclination = 0.025
lateral = 0.0 # mm
[grid]
dx = 0.8
ds = 0.8
"""
RAIL = "".join(f"{y:.2f} {y * y / 600 + 36 * abs(y / 36) ** 10:.6f}\n" for y in (0.5 * i for i in range(-72, 73)))


class Program:
    """`bem_contact explore` until close()."""

    def __init__(self, *arguments):
        self.process = subprocess.Popen([os.environ["BEM_CONTACT"], "explore", "--no-browser", *map(str, arguments)],
                                        stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        self.process.stdout.readline()
        self.address = self.process.stdout.readline().strip()
        self.host, self.path = re.fullmatch(r"http://(127\.0\.0\.1:\d+)(/[0-9a-f]{32}/)", self.address).groups()

    def request(self, method="GET", path=None, body=None, headers=(), connection=None):
        own = connection or http.client.HTTPConnection(self.host, timeout=60)
        own.request(method, self.path if path is None else path, body, dict(headers))
        response = own.getresponse()
        text = response.read()
        if not connection:
            own.close()
        return response, text

    def answer(self, text, **more):
        body = json.dumps({"text": text, **more})
        response, answer = self.request("POST", self.path + "answer", body, {"Content-Type": "application/json"})
        return response.status, json.loads(answer)

    def close(self, how=signal.SIGINT):
        self.process.send_signal(how)
        out, err = self.process.communicate(timeout=60)
        return self.process.returncode, out, err


class Requests(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.scene = Path(cls.temporary.name) / "scene.toml"
        cls.scene.write_text(SCENE)
        cls.program = Program(cls.scene)

    @classmethod
    def tearDownClass(cls):
        cls.program.close()
        cls.temporary.cleanup()

    def test_who_is_answered(self):
        p, question = self.program, json.dumps({"text": SCENE})
        as_json = {"Content-Type": "application/json"}
        self.assertEqual(p.request()[0].status, 200)
        self.assertEqual(p.request("HEAD")[0].status, 200)
        for what in ("computing", "cancel"):
            self.assertEqual(p.request("POST", p.path + what, "{}", as_json)[0].status, 200)
            self.assertEqual(p.request("POST", p.path + what, "{}", {**as_json, "Origin": "http://evil.example"})[0].status, 403)
            self.assertEqual(p.request("GET", p.path + what)[0].status, 404)
        self.assertEqual(p.request("POST", p.path + "answer", question, {**as_json, "Origin": f"http://{p.host}"})[0].status, 200)
        port = p.host.split(":")[1]
        for status, more in ((404, {"path": "/"}), (404, {"path": "/" + "0" * 32 + "/"}), (404, {"path": p.path[:-2] + "/"}),
                             (404, {"path": p.path.upper()}), (404, {"path": p.path + "../../etc/passwd"}), (404, {"path": p.path + "other"}),
                             (403, {"headers": {"Host": "evil.example"}}), (403, {"headers": {"Host": f"localhost:{port}"}}),
                             (403, {"headers": {"Origin": "http://evil.example"}}), (403, {"headers": {"Origin": "null"}}),
                             (403, {"headers": {"Origin": f"https://{p.host}"}}),
                             (405, {"method": "PUT"}), (405, {"method": "DELETE"}), (405, {"method": "OPTIONS"}),
                             (403, {"method": "POST", "path": p.path + "answer", "body": question,
                                    "headers": {**as_json, "Origin": "http://evil.example"}}),
                             (415, {"method": "POST", "path": p.path + "answer", "body": question}),
                             (404, {"method": "POST", "path": "/" + "f" * 32 + "/answer", "body": question, "headers": as_json}),
                             (404, {"path": p.path + "answer"})):
            response, text = p.request(**more)
            self.assertEqual(response.status, status, (more, text))
            self.assertNotIn(b"quantities", text)
        response, _ = p.request("POST", p.path + "answer", question, {**as_json, "Accept-Encoding": "gzip, deflate, br"})
        self.assertIsNone(response.getheader("Content-Encoding"))  # to compress takes ten times as long as to solve
        headers = p.request()[0]
        self.assertIn("default-src 'none'", headers.getheader("Content-Security-Policy"))
        self.assertEqual(headers.getheader("Cache-Control"), "no-store")

    def test_malformed_requests(self):
        import socket
        host, port = self.program.host.split(":")
        for text in (b"\r\n\r\n", b"GET\r\n\r\n", b"GET / HTTP/9.9\r\n\r\n", b"\x00\xff" * 5000, b"GET /" + b"a" * 20000 + b" HTTP/1.1\r\n\r\n",
                     b"POST " + self.program.path.encode() + b"answer HTTP/1.1\r\nHost: x\r\nContent-Length: 99999999999999999999\r\n\r\n",
                     b"GET / HTTP/1.1\r\n" + b"A: b\r\n" * 50000 + b"\r\n"):
            with socket.create_connection((host, int(port)), timeout=30) as wire:
                try:
                    wire.sendall(text)
                    wire.shutdown(socket.SHUT_WR)
                    while wire.recv(65536):
                        pass
                except OSError as error:  # it hangs up at once, but it does not wait
                    self.assertNotIsInstance(error, TimeoutError)
        too_large = json.dumps({"text": SCENE, "files": {"a": "x" * (17 << 20)}})
        try:
            status = self.program.request("POST", self.program.path + "answer", too_large, {"Content-Type": "application/json"})[0].status
            self.assertEqual(status, 413)
        except (ConnectionError, BrokenPipeError):
            pass  # refused before all of it was sent
        self.assertIn("data", self.program.answer(SCENE)[1])

    def test_requests_that_come_at_once_or_in_pieces(self):
        """Two in one packet, and one byte by byte: each is answered."""
        import socket
        host, port = self.program.host.split(":")
        body = json.dumps({"text": SCENE}).encode()
        head = f"POST {self.program.path}numbers HTTP/1.1\r\nHost: {host}:{port}\r\nContent-Type: application/json\r\nContent-Length: {len(body)}\r\n"
        with socket.create_connection((host, int(port)), timeout=60) as wire:
            wire.sendall(2 * (head.encode() + b"\r\n" + body))
            for byte in (head + "Connection: close\r\n\r\n").encode() + body:
                wire.sendall(bytes([byte]))
            said = b""
            while part := wire.recv(65536):
                said += part
        self.assertEqual(said.count(b"HTTP/1.1 200 OK"), 3)
        self.assertEqual(said.count(b'"certified": true'), 3)

    def test_numbers_are_those_that_solve_prints(self):
        question = json.dumps({"text": SCENE, "changes": {"position.lateral": 2.5}})
        said = {what: json.loads(self.program.request("POST", self.program.path + what, question, {"Content-Type": "application/json"})[1])
                for what in ("numbers", "fields")}
        with tempfile.TemporaryDirectory() as name:
            scene = Path(name) / "scene.toml"
            scene.write_text(SCENE.replace("lateral = 0.0", "lateral = 2.5"))
            printed = json.loads(subprocess.run([os.environ["BEM_CONTACT"], "solve", scene, "--json"], capture_output=True, text=True).stdout)
        timeless = {key: value for key, value in printed.items() if key != "seconds" and not (isinstance(value, dict) and "seconds" in value)}
        self.assertGreater(len(timeless), 5)
        for key, value in timeless.items():
            self.assertEqual(said["numbers"][key], value, key)
        self.assertEqual(said["fields"]["quantities"]["pmax"], printed["quantities"]["pmax"])
        self.assertEqual(max(map(max, said["fields"]["p_n"])), printed["quantities"]["pmax"])

    def test_a_thousand_requests(self):
        def ask(first):
            connection, kinds = http.client.HTTPConnection(self.program.host, timeout=120), set()
            for k in range(125):
                body = json.dumps({"text": SCENE if k % 5 == 0 else "nonsense", "changes": {}, "window": f"{first}"})
                _, text = self.program.request("POST", self.program.path + "answer", body, {"Content-Type": "application/json"},
                                               connection)
                kinds |= set(json.loads(text))
            return kinds

        with ThreadPoolExecutor(8) as pool:
            self.assertEqual(list(pool.map(ask, range(8))), [{"data", "problem"}] * 8)
        with open(f"/proc/{self.program.process.pid}/status") as status:
            self.assertLess(int(re.search(r"VmRSS:\s+(\d+) kB", status.read())[1]), 600_000)
        self.assertEqual(self.program.answer(SCENE)[0], 200)

    def test_what_is_saved_is_what_the_command_makes(self):
        import h5py
        import numpy as np
        question = json.dumps({"text": SCENE, "changes": {"position.lateral": 2.5, "motion.xi": 0.001}})
        saved = {what: self.program.request("POST", self.program.path + what, question, {"Content-Type": "application/json"})[1]
                 for what in ("scene", "result", "report")}
        self.assertEqual(saved["scene"].decode(), SCENE.replace("lateral = 0.0", "lateral = 2.5")
                         .replace("friction = 0.3", "xi = 0.001, friction = 0.3"))
        with tempfile.TemporaryDirectory() as name:
            folder = Path(name)
            (folder / "saved.toml").write_bytes(saved["scene"])
            (folder / "saved.h5").write_bytes(saved["result"])
            self.assertEqual(subprocess.run([os.environ["BEM_CONTACT"], "solve", folder / "saved.toml", "-o", folder / "own.h5"],
                                            capture_output=True).returncode, 0)
            with h5py.File(folder / "saved.h5") as one, h5py.File(folder / "own.h5") as other:
                for field in ("p_n", "p_x", "p_s", "state"):
                    np.testing.assert_array_equal(one[field][()], other[field][()])
            again = subprocess.run([os.environ["BEM_CONTACT"], "solve", folder / "saved.h5"], capture_output=True, text=True)
            self.assertIn("the same", again.stdout)
        self.assertIn(b"bem_contact report", saved["report"])

    def test_starts_and_ends(self):
        for how in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
            before = set(Path(tempfile.gettempdir()).glob("bem_contact_*"))
            other = Program()
            self.assertIn("problem", other.answer(SCENE, changes={"rail.profile": "a.txt"}, files={"a.txt": "b"})[1])
            mine = set(Path(tempfile.gettempdir()).glob("bem_contact_*")) - before
            self.assertEqual(other.close(how)[0], 0)
            self.assertFalse([folder for folder in mine if folder.exists() and not self.program_owns(folder)])
        taken = subprocess.run([os.environ["BEM_CONTACT"], "explore", "--no-browser", "--port", self.program.host.split(":")[1]],
                               capture_output=True, text=True)
        self.assertEqual(taken.returncode, 2)
        self.assertIn("--port", taken.stderr)

    def program_owns(self, folder):
        """Whether another program that runs now may have made it."""
        return self.program.process.poll() is None and folder.stat().st_mtime < time.time() - 60


@unittest.skipUnless(browser.PROGRAM, "chromium is not installed")
class Page(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.folder = Path(cls.temporary.name)
        (cls.folder / "scene.toml").write_text(SCENE)
        cls.program = Program(cls.folder / "scene.toml")
        cls.show = browser.Browser()
        cls.open_page()

    @classmethod
    def tearDownClass(cls):
        cls.show.close()
        cls.program.close()
        cls.temporary.cleanup()

    @classmethod
    def open_page(cls, address=None, flat=True):
        """Flat: without the figure in 3-D, which takes a second each time where there is no graphics card."""
        cls.show.call("Emulation.setDeviceMetricsOverride", {"width": 1366, "height": 768, "deviceScaleFactor": 1, "mobile": False})
        cls.show.call("Page.navigate", {"url": address or cls.program.address})
        if flat:
            cls.until("document.getElementById('in-3d')")
            cls.show.value("document.getElementById('in-3d').checked = false")
        cls.until("document.body?.dataset.drawn || document.querySelector('#script-errors li')")

    @classmethod
    def until(cls, condition):
        cls.show.value("new Promise(done => { const look = () => %s ? done() : setTimeout(look, 30); look(); })" % condition)

    def set_up(self, script):
        """Runs it, and waits until what it asks for is shown with all figures."""
        self.show.value("delete document.body.dataset.drawn; " + script)
        self.until("document.body.dataset.drawn && !waiting && since === undefined")

    def number(self, name):
        return self.show.value(f"valueOf(contactsOf(data)[0].group.quantities, '{name}')")

    def move(self, key, value):
        self.set_up(f"(s => {{ s.value = {value}; s.dispatchEvent(new Event('input')); }})"
                    f"(document.querySelector('.control:has([name=\"{key}\"]) input[type=range]'))")

    def setUp(self):
        self.set_up("element('reset').click()")

    def tearDown(self):
        self.assertEqual(self.show.value("document.getElementById('script-errors').innerText"), "")

    def test_what_is_there(self):
        self.set_up("element('in-3d').click()")
        for name in ("solid", "section", "patch", "cut-x", "cut-s"):
            self.assertTrue(self.show.value(f"!!document.querySelector('#{name} svg.main-svg')"), name)
        self.assertRegex(self.show.value("element('status').innerText"), r"^Certified. Model: half-space. Answered in \d+ ms")
        self.assertEqual(self.show.value("document.querySelectorAll('.six dd').length"), 6)
        self.assertIn("±", self.show.value("element('six-pmax').innerText"))
        self.assertEqual([r for r in self.show.requests if not r.startswith(("http://127.0.0.1:", "data:", "blob:"))], [])
        self.assertEqual(self.show.value(LOOK), "")
        named = self.show.value("[...document.querySelectorAll('input:not([type=file]), select, textarea')].filter(e => !e.labels?.length && "
                                "!e.getAttribute('aria-label')).map(e => e.outerHTML).join()")
        self.assertEqual(named, "")
        kept = "element('solid').layout.scene.camera.eye.x"
        self.show.value("Plotly.relayout(element('solid'), {'scene.camera.eye': {x: 0.1, y: 0.2, z: 2}}).then(() => 0)")
        self.move("load.force", 50)
        self.assertEqual(self.show.value(kept), 0.1)  # it stays as it was turned
        self.set_up("element('in-3d').click()")
        self.assertTrue(self.show.value("element('solid').hidden"))

    def test_each_slider_moves_the_answer(self):
        for key, value, quantity, wanted in (("position.lateral", 3, "lateral", 3), ("load.force", 60, "Fz", 6e4),
                                             ("motion.xi", 2, "xi", 0.002), ("motion.eta", -1, "eta", -0.001),
                                             ("motion.phi", 0.5, "phi", 5e-4)):
            self.move(key, value)
            self.assertAlmostEqual(self.number(quantity), wanted, delta=1e-6 * max(1, abs(wanted)), msg=key)
        for key, value, quantity in (("position.yaw", 5, "Fy"), ("position.roll", 4, "Fy"), ("motion.friction", 0.4, "Fx"),
                                     ("layer.compliance", 0.2, "Fx")):
            before = self.number(quantity)
            self.move(key, value)
            self.assertGreater(abs(self.number(quantity) - before), 10, key)
            self.assertIn("Certified", self.show.value("element('status').innerText"))
        self.show.value("moved('track.curve_radius', 5e5)")
        self.until("element('problem').innerText.includes('motion.speed')")  # a curve without a speed says nothing
        self.move("motion.speed", 72)
        self.assertTrue(self.show.value("element('problem').hidden"))
        self.assertEqual(self.show.value("scene.changes['motion.speed']"), 2e4)
        self.move("track.curve_radius", 2)
        self.assertEqual(self.show.value("scene.changes['track.curve_radius']"), 5e5)  # 2 per km
        self.assertIn(f"lateral = 3", self.show.value("(async () => (await fileOf('scene', sceneNow())).text())()"))

    def test_the_last_position_wins(self):
        self.set_up("for (let k = 0; k <= 50; ++k) moved('position.lateral', k / 10)")
        self.assertEqual(self.number("lateral"), 5)
        self.assertEqual(self.show.value("element('position-lateral').value"), "5")

    def test_choices_and_fields(self):
        pressure = self.number("pmax")
        self.set_up("(e => { e.value = 'simplified'; e.dispatchEvent(new Event('change')); })(element('solver-model'))")
        self.assertIn("simplified", self.show.value("element('status').innerText"))
        self.set_up("(e => { e.value = '54E1'; e.dispatchEvent(new Event('change')); })(element('rail-profile'))")
        self.assertNotAlmostEqual(self.number("pmax"), pressure, delta=1)
        self.set_up("(e => { e.value = '250'; e.dispatchEvent(new Event('change')); })(element('load-force'))")
        self.assertAlmostEqual(self.number("Fz"), 2.5e5, delta=1)

    def test_files_and_what_is_wrong_is_a_message(self):
        drop = """(async (name, text, at) => { const transfer = new DataTransfer(); transfer.items.add(new File([text], name));
            at.dispatchEvent(new DragEvent("drop", {dataTransfer: transfer, bubbles: true, cancelable: true})); })"""
        at = "document.querySelector('.control:has(#rail-profile)')"
        self.set_up(f"{drop}('mine.txt', {json.dumps(RAIL)}, {at})")
        self.assertEqual(self.show.value("element('rail-profile').value"), "mine.txt")
        good = self.number("pmax")
        self.show.value(f"{drop}('bad.txt', 'no points', {at})")
        self.until("!element('problem').hidden")
        self.assertIn("bad.txt", self.show.value("element('problem').innerText"))
        self.assertTrue(self.show.value("element('page').classList.contains('stale')"))
        self.set_up("document.querySelector('#problem button').click()")
        self.assertTrue(self.show.value("element('problem').hidden"))
        self.assertAlmostEqual(self.number("pmax"), good, delta=1e-6 * good)  # another start, within the tolerance
        self.show.value("moved('position.lateral', 900)")
        self.until("!element('problem').hidden")
        self.show.value("element('text').value = 'load.farce = 3'; element('solve-text').click()")
        self.until("element('problem').innerText.includes('load.force')")
        self.set_up(f"{drop}('other.toml', {json.dumps(SCENE.replace('1e5', '7e4'))}, document.body)")
        self.assertAlmostEqual(self.number("Fz"), 7e4, delta=1)
        self.show.value(f"{drop}('a.bin', 'x', document.body)")
        self.until("element('problem').innerText.includes('Drop a profile on the field')")

    DROP = """(async (name, text, at) => { const transfer = new DataTransfer(); transfer.items.add(new File([text], name));
        at.dispatchEvent(new DragEvent("drop", {dataTransfer: transfer, bubbles: true, cancelable: true})); })"""

    def test_what_a_profile_warns_of_stands_on_the_page_with_a_button(self):
        noisy = "".join(f"{0.25 * i:.2f} {(0.25 * i) ** 2 / 600 + 36 * abs(i / 144) ** 10 + 0.004 * (-1) ** (i * i // 7):.6f}\n" for i in range(-144, 145))
        self.set_up(f"{self.DROP}('noisy.txt', {json.dumps(noisy)}, document.querySelector('.control:has(#rail-profile)'))")
        remarks = self.show.value("[...document.querySelectorAll('.remark')].map(p => p.innerText)")
        scatter = [text for text in remarks if "scatter by" in text]
        self.assertEqual(len(scatter), 1, remarks)
        self.assertTrue(scatter[0].startswith("noisy.txt: "), scatter)  # not a file of the temporary folder
        self.set_up("[...document.querySelectorAll('.remark')].find(p => p.innerText.includes('scatter by')).querySelector('button').click()")
        self.assertGreater(self.show.value("scene.changes['rail.smoothing'] ?? scene.changes['rail.nominal'].length"), 1)
        self.assertFalse(self.show.value("[...document.querySelectorAll('.remark')].some(p => p.innerText.includes('scatter by'))"))

    def test_an_inclination_given_twice_is_taken_back_by_a_button(self):
        inclined = "".join(f"{y * c + z * s:.5f} {z * c - y * s:.5f}\n" for c, s in ((0.9996875, 0.0249974),)
                           for y, z in ((0.25 * i, (0.25 * i) ** 2 / 600 + 36 * abs(i / 144) ** 10) for i in range(-144, 145)))
        self.set_up(f"{self.DROP}('inclined.txt', {json.dumps(inclined)}, document.querySelector('.control:has(#rail-profile)'))")
        said = "[...document.querySelectorAll('.warning')].filter(p => p.innerText.includes('already inclined'))"
        self.assertEqual(self.show.value(said + ".length"), 1)
        self.set_up(said + "[0].querySelector('button').click()")
        self.assertEqual(self.show.value("scene.changes['position.rail_inclination']"), 0)
        self.assertEqual(self.show.value(said + ".length"), 0)

    def test_beside_a_message_stands_what_was_moved_in_the_unit_of_its_field(self):
        for key, value, words in (("position.yaw", 0.9, "You moved: yaw, front to the right, 900 mrad."),
                                  ("load.force", -3, "You moved: vertical force, -0.003 kN.")):
            self.show.value(f"moved('{key}', {value})")
            self.until("!element('problem').hidden")
            said = self.show.value("element('problem').innerText")
            self.assertIn(f"{key} = {value}", said)
            self.assertIn("(out of range)", said)
            self.assertIn(words, said)
            self.set_up("element('reset').click()")

    def test_a_slider_has_its_own_range_after_a_reset(self):
        self.set_up("(e => { e.value = '15'; e.dispatchEvent(new Event('change')); })(element('position-yaw'))")
        range_of = "(s => [s.min, s.max])(element('position-yaw').parentElement.querySelector('[type=range]'))"
        self.set_up("(e => { e.value = '60'; e.dispatchEvent(new Event('change')); })(element('position-yaw'))")
        self.assertEqual(self.show.value(range_of), ["-20", "60"])
        self.set_up("element('reset').click()")
        self.assertEqual(self.show.value(range_of), ["-20", "20"])

    def test_a_standard_that_is_misspelt_is_answered_with_the_nearest(self):
        self.show.value("(e => { e.value = 'UIC99'; e.dispatchEvent(new Event('change')); })(element('rail-profile'))")
        self.until("!element('problem').hidden")
        self.assertRegex(self.show.value("element('problem').innerText"), r"Unknown profile 'UIC99'.*Did you mean .*UIC60")

    def test_paper_has_the_answer_that_is_shown(self):
        self.show.value("Object.keys(HEIGHTS).forEach(id => costs[id] = 1e9); lastMove = performance.now(); moved('position.lateral', 5)")
        self.until("valueOf(contactsOf(data)[0].group.quantities, 'lateral') === 5")
        self.assertTrue(self.show.value("dispatchEvent(new Event('beforeprint')); element('section').data[0].x.join() === "
                                        "sectionFigure(contactsOf(data)[0]).traces[0].x.join()"))

    def test_labels_in_3d_are_whole(self):
        import io

        from matplotlib.image import imread
        self.set_up("element('in-3d').click()")
        box = self.show.value("(b => [b.x + scrollX, b.y + scrollY, b.width, b.height])(element('solid').getBoundingClientRect())")
        import base64
        clip = dict(zip(("x", "y", "width", "height"), box), scale=1)
        picture = imread(io.BytesIO(base64.b64decode(self.show.call("Page.captureScreenshot", {"format": "png", "clip": clip})["data"])))[..., :3]
        self.set_up("element('in-3d').click()")
        for name, edge in (("left", picture[60:, :3]), ("below", picture[-3:])):
            self.assertGreater(edge.min(), 0.5, name)  # no ink
        self.assertGreater((picture[..., 2] - picture[..., 0]).max(), 0.3)  # the patch is blue

    def test_two_cases_side_by_side(self):
        before = self.number("pmax")
        self.show.value("element('hold').click()")
        self.move("load.force", 150)
        cells = self.show.value("[...document.querySelectorAll('#differences tbody tr')].map(r => [...r.cells].map(c => c.textContent))")
        row = next(row for row in cells if row[0] == "largest pressure")
        self.assertAlmostEqual(float(row[3]), self.number("pmax") - before, delta=0.01)
        self.assertIn("load.force", self.show.value("element('differs').innerText"))
        self.until("document.querySelector('#patch-held svg.main-svg') && document.querySelector('#patch-now svg.main-svg')")
        self.set_up("(e => { e.value = 'tangent_plane'; e.dispatchEvent(new Event('change')); })(element('solver-model'))")
        self.show.value("element('release').click()")
        self.assertTrue(self.show.value("element('held').hidden"))

    def test_sweep_and_click(self):
        self.show.value("""element('sweep-key').value = 'position.lateral'; element('sweep-from').value = -2; element('sweep-to').value = 2;
            element('sweep-count').value = 5; element('sweep-run').click()""")
        self.until("!sweep.running && sweep.cases.length === 5 && document.querySelector('#sweep-T_gamma svg.main-svg')")
        self.assertEqual(self.show.value("sweep.cases.map(one => one.value)"), [-2, -1, 0, 1, 2])
        self.assertEqual(self.show.value("sweep.cases.map(one => valueOf(contactsOf(one.reply.data)[0].group.quantities, 'lateral'))"),
                         [-2, -1, 0, 1, 2])
        self.set_up("element('sweep-pmax').emit('plotly_click', {points: [{customdata: element('sweep-pmax').data[0].customdata[4]}]})")
        self.assertEqual(self.number("lateral"), 2)
        self.assertEqual(self.show.value("element('position-lateral').value"), "2")
        self.assertIn("bem_contact sweep", self.show.value("element('commands').innerText"))
        csv = self.show.value("sweepCsv()").splitlines()
        self.assertEqual(len(csv), 6)
        self.assertIn("pmax, MPa", csv[0])
        text = self.show.value("(async () => await (await fileOf('scene', sceneNow())).text() + sweepText())()")
        (self.folder / "sweep.toml").write_text(text)
        done = subprocess.run([os.environ["BEM_CONTACT"], "sweep", self.folder / "sweep.toml", "-o", self.folder / "sweep.h5"], capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stderr)

    def test_two_windows(self):
        first = self.show.session
        self.move("position.lateral", 1)
        target = self.show.call("Target.createTarget", {"url": "about:blank"})["targetId"]
        self.show.session = self.show.call("Target.attachToTarget", {"targetId": target, "flatten": True})["sessionId"]
        try:
            self.open_page()
            self.assertEqual(self.number("lateral"), 0)
            self.move("load.force", 42)
            second = self.show.session
            self.show.session = first
            self.assertEqual(self.number("lateral"), 1)
            self.move("load.force", 77)
            self.assertAlmostEqual(self.number("Fz"), 7.7e4, delta=1)
            self.show.session = second
            self.assertAlmostEqual(self.number("Fz"), 4.2e4, delta=1)
        finally:
            self.show.session = first
            self.show.call("Target.closeTarget", {"targetId": target})

    def test_saving_is_a_download_of_the_browser(self):
        self.show.call("Browser.setDownloadBehavior", {"behavior": "allow", "downloadPath": str(self.folder)})
        for button, name in (("save-scene", "explored.toml"), ("save-result", "explored.h5"), ("save-page", "explored.html"),
                             ("save-csv", "explored.csv"), ("save-png", "patch.png")):
            self.show.value(f"element('{button}').click()")
            until = time.monotonic() + 120
            while not (self.folder / name).exists() and time.monotonic() < until:
                self.show.value("1")
                time.sleep(0.1)
            self.assertTrue((self.folder / name).exists(), name)
        self.assertIn("# a comment that stays", (self.folder / "explored.toml").read_text())

    @unittest.skipUnless(HAS_FEM, "this build has no fem_influence")
    def test_influence_functions_on_a_button(self):
        self.set_up("newScene(%s)" % json.dumps(SCENE.replace("0.8", "1.5")))  # fewer stations
        self.move("position.lateral", 2)
        pressure = self.number("pmax")
        self.show.call("Browser.setDownloadBehavior", {"behavior": "allow", "downloadPath": str(self.folder)})
        self.show.value("element('save-bodies').click()")
        self.until("!element('body-commands').hidden")
        names = re.findall(r"mesh_body (\w+)\.toml", self.show.value("element('body-commands').innerText"))
        self.assertEqual([name.split("_")[0] for name in names], ["rail", "wheel"])
        self.show.value("delete document.body.dataset.drawn; element('compute').click()")
        self.until("element('compute').innerText === 'Cancel'")
        self.until("element('compute').innerText !== 'Cancel'")
        self.assertEqual(self.show.value("element('compute-note').innerText"), "The influence functions are there.")
        self.until("document.body.dataset.drawn && !waiting && since === undefined")
        self.assertIn("Model: finite-element influence functions", self.show.value("element('status').innerText"))
        self.assertNotAlmostEqual(self.number("pmax"), pressure, delta=1e-4 * pressure)
        self.assertAlmostEqual(self.number("pmax"), pressure, delta=0.1 * pressure)
        self.assertEqual(self.show.value("scene.changes['rail.influence']"), f"{names[0]}.h5")
        self.assertIn(f"fem_influence {names[1]}.toml {names[1]}.msh -o {names[1]}.h5", self.show.value("element('commands').innerText"))
        self.show.value("moved('position.lateral', 6.5)")  # beyond the strips
        self.until("element('problem').innerText.includes('strip')")
        self.set_up("document.querySelector('#problem button').click()")
        # Another contact takes its time, and can be cancelled.
        self.set_up("(e => { e.value = 'halfspace'; e.dispatchEvent(new Event('change')); })(element('solver-model'))")
        self.move("position.lateral", -1)
        self.show.value("element('compute').click()")
        self.until("element('compute').innerText === 'Cancel'")
        self.show.value("element('compute').click()")
        self.until("element('compute-note').innerText === 'Cancelled.'")
        self.assertIn("half-space", self.show.value("element('status').innerText"))

    @unittest.skipIf(HAS_FEM, "this build has fem_influence")
    def test_without_finite_elements_the_button_says_so(self):
        self.until("element('compute').disabled")
        self.assertIn("tools/install_packages full", self.show.value("element('compute-note').innerText"))
        self.show.value("element('save-bodies').click()")
        self.until("element('body-commands').innerText.includes('mesh_body rail_')")

    def test_narrow_and_paper(self):
        picture = self.folder / "page.png"
        self.show.of_width(400)
        self.show.screenshot(picture)
        self.assertLessEqual(self.show.value("document.documentElement.scrollWidth"), 400)
        self.show.pdf(self.folder / "page.pdf")
        self.assertGreater((self.folder / "page.pdf").stat().st_size, 20_000)
        self.show.call("Emulation.setDeviceMetricsOverride", {"width": 1366, "height": 768, "deviceScaleFactor": 1, "mobile": False})

    def test_a_scene_that_is_wrong_from_the_start_is_a_message(self):
        (self.folder / "wrong.toml").write_text("load.farce = 3\n")
        program = Program(self.folder / "wrong.toml")
        try:
            self.open_page(program.address)
            self.assertIn("load.force", self.show.value("element('problem').innerText"))
            self.set_up(f"element('text').value = {json.dumps(SCENE)}; element('solve-text').click()")
            self.assertAlmostEqual(self.number("Fz"), 1e5, delta=1)
        finally:
            program.close()
            self.open_page()


if __name__ == "__main__":
    unittest.main()
