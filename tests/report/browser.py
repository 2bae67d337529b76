"""A headless Chromium that a test talks to through a pipe (DevTools protocol), with Python's own modules alone."""

import base64
import json
import os
import select
import shutil
import subprocess
import tempfile
import time

PROGRAM = shutil.which("chromium")
# WebGL is drawn by software (swiftshader). The page itself is put together without it, in a sixth of the processor time.
FLAGS = ["--headless", "--no-sandbox", "--disable-gpu-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader",
         "--disable-gpu-compositing",
         "--hide-scrollbars", "--no-first-run", "--disable-extensions", "--disable-background-networking",
         "--disable-component-update", "--remote-debugging-pipe"]


USUAL = (1280, 800)  # px, a laptop's screen


class Browser:
    """One page at a time. `requests` has the address of everything that the page asked for."""

    def __init__(self, seconds=300):  # a 3-D figure takes 2 s on a quiet machine, and 80 s beside many compilers
        self.seconds, self.count, self.buffer, self.requests = seconds, 0, b"", []
        self.folder = tempfile.TemporaryDirectory(ignore_cleanup_errors=True)
        commands, self.to = os.pipe()
        self.answers, answers = os.pipe()

        def as_three_and_four():
            first, second = os.dup(commands), os.dup(answers)
            os.dup2(first, 3)
            os.dup2(second, 4)

        self.process = subprocess.Popen(
            [PROGRAM, *FLAGS, f"--user-data-dir={self.folder.name}"], preexec_fn=as_three_and_four, close_fds=False,
            stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        os.close(commands)
        os.close(answers)
        target = self.call("Target.createTarget", {"url": "about:blank"})["targetId"]
        self.session = self.call("Target.attachToTarget", {"targetId": target, "flatten": True})["sessionId"]
        self.call("Page.enable")
        self.call("Network.enable")
        self.of_width(*USUAL)

    def close(self):
        try:
            self.session = None
            self.call("Browser.close")
        finally:
            self.process.wait(timeout=30)
            self.folder.cleanup()

    def receive(self, until):
        while b"\0" not in self.buffer:
            if not select.select([self.answers], [], [], max(0, until - time.monotonic()))[0]:
                raise TimeoutError(f"the browser has not answered for {self.seconds} s")
            part = os.read(self.answers, 1 << 20)
            if not part:
                raise RuntimeError("the browser has ended")
            self.buffer += part
        message, self.buffer = self.buffer.split(b"\0", 1)
        return json.loads(message)

    def call(self, method, parameters=None):
        self.count += 1
        message = {"id": self.count, "method": method, "params": parameters or {}}
        if getattr(self, "session", None):
            message["sessionId"] = self.session
        os.write(self.to, json.dumps(message).encode() + b"\0")
        until = time.monotonic() + self.seconds
        while True:
            answer = self.receive(until)
            if answer.get("method") == "Network.requestWillBeSent":
                self.requests.append(answer["params"]["request"]["url"])
            if answer.get("id") == self.count:
                if "error" in answer:
                    raise RuntimeError(f"{method}: {answer['error']}")
                return answer["result"]

    def value(self, expression):
        answer = self.call("Runtime.evaluate", {"expression": expression, "awaitPromise": True, "returnByValue": True})
        if "exceptionDetails" in answer:
            raise RuntimeError(f"{expression}: {answer['exceptionDetails']}")
        return answer["result"].get("value")

    def open(self, file):
        """Shows a page and waits until its last figure is drawn, or it says that something went wrong."""
        self.requests = []
        self.call("Page.navigate", {"url": f"file://{file}"})
        self.value("""new Promise(done => { const look = () =>
            document.body?.dataset.drawn || document.querySelector("#script-errors li") ? done() : setTimeout(look, 50);
            look(); })""")

    def of_width(self, width, height=1000):
        """The screen's, px. Waits until all figures that are shown have their new width; in 3-D that takes seconds."""
        self.call("Emulation.setDeviceMetricsOverride", {"width": width, "height": height, "deviceScaleFactor": 1, "mobile": False})
        self.value("""new Promise(done => {
            const until = performance.now() + 60000;
            const follows = ([frame]) => {
              const drawn = frame.querySelector("svg.main-svg");
              return !drawn || frame.offsetParent === null || Math.abs(drawn.getBoundingClientRect().width - widthOf(frame)) <= 1;
            };
            const look = () => typeof widthOf === "undefined" || figures.every(follows) || performance.now() > until ? done()
                                                                                                            : setTimeout(look, 50);
            setTimeout(look, 50);
        })""")

    def screenshot(self, file):
        data = self.call("Page.captureScreenshot", {"captureBeyondViewport": True})["data"]
        file.write_bytes(base64.b64decode(data))

    def pdf(self, file):
        file.write_bytes(base64.b64decode(self.call("Page.printToPDF", {"preferCSSPageSize": True})["data"]))
