"""What a start costs: `bem_contact --version` and a scene without influence files open no library that they do not need."""

import os
import resource
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

PROGRAM = Path(os.environ["CONFORMAL_BIN"]) / "bem_contact"
SCENES = Path(__file__).resolve().parents[2] / "data" / "scenes"
NOT_AT_START = ("libhdf5", "libopenblas", "libcrypto", "libcurl")
MOST_LIBRARIES, MOST_FAULTS = 20, 400


def opened(*words):
    """The libraries that a call opens, sooner or later."""
    with tempfile.TemporaryDirectory() as folder:
        environment = os.environ | {"LD_DEBUG": "files", "LD_DEBUG_OUTPUT": f"{folder}/said"}
        subprocess.run([PROGRAM, *words], env=environment, check=True, stdout=subprocess.DEVNULL)
        said = "".join(file.read_text() for file in Path(folder).glob("said.*"))
    return {line.split("calling init: ")[1].strip().rsplit("/")[-1] for line in said.splitlines() if "calling init: " in line}


class Start(unittest.TestCase):
    def test_it_needs_few_libraries(self):
        libraries = opened("--version")
        self.assertLessEqual(len(libraries), MOST_LIBRARIES, libraries)
        self.assertFalse([name for name in libraries if name.startswith(NOT_AT_START)], libraries)

    def test_a_scene_without_files_opens_none_of_them(self):
        for scene in (SCENES / "hertz.toml", SCENES.parents[1] / "tools" / "benchmarks" / "speed" / "groove_20.toml"):
            self.assertFalse([name for name in opened("solve", scene) if name.startswith(NOT_AT_START)])

    def test_files_open_it(self):
        with tempfile.TemporaryDirectory() as folder:
            self.assertTrue([name for name in opened("solve", SCENES / "hertz.toml", "-o", f"{folder}/r.h5") if name.startswith("libhdf5")])

    @unittest.skipIf("libasan" in str(opened("--version")), "of a release")
    def test_it_touches_few_pages(self):
        before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_minflt
        subprocess.run([PROGRAM, "--version"], check=True, stdout=subprocess.DEVNULL)
        self.assertLessEqual(resource.getrusage(resource.RUSAGE_CHILDREN).ru_minflt - before, MOST_FAULTS)


if __name__ == "__main__":
    sys.exit(unittest.main())
