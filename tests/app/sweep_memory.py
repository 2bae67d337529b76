"""The memory of a part of a sweep, and of --join, does not grow with the sweep. Parts with many cases are made from the records of
one that was solved. `sweep_memory.py 5000000` shows it for 5 million cases (some minutes, 15 GB of disk)."""

import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import h5py
import numpy as np

PROGRAM = os.environ["BEM_CONTACT"]
SIZES = [1_000, 100_000]
SOLVED = 32  # cases
MOST = 100  # MB
FLOOR = 60  # MB: what a child has at most is told from what Python holds when it starts it; less cannot be seen
SCENE = """kind = "patch"
motion.friction = 0.3
grid = { dx = 0.8, ds = 0.8, mx = 12, ms = 12 }
gap = { a = 1e-3, b = 1e-3 }
[sweep]
motion.xi = { from = 0, to = 2e-3, count = %d }
load.force = { from = 4e3, to = 7e3, count = 1000 }
"""


def memory_of(*arguments):
    """MB at most, exit code and output of a run of the program."""
    environment = os.environ | {"OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1"}
    with tempfile.TemporaryFile() as out:
        run = subprocess.Popen([PROGRAM, *map(str, arguments)], stdout=out, stderr=subprocess.STDOUT, env=environment)
        _, status, used = os.wait4(run.pid, 0)
        run.returncode = os.waitstatus_to_exitcode(status)
        out.seek(0)
        return max(used.ru_maxrss / 1024, FLOOR), run.returncode, out.read().decode()


def write_part(solved, file, first, last):
    """As if these cases had been solved: the records of those that were, again and again."""
    with h5py.File(solved) as old, h5py.File(file, "w", libver=("v108", "v108")) as new:
        for name, value in old.attrs.items():
            new.attrs[name] = value
        new.attrs["first_case"], new.attrs["last_case"] = float(first), float(last)
        count = last - first
        times = -(-count // SOLVED)
        of_patch = np.concatenate([old["patches/case"][:] + SOLVED * i for i in range(times)])
        rows = of_patch < count
        old.copy("made_from", new)
        for name, data in [(n, d) for n, d in old.items() if n not in ("patches", "cases", "made_from")] + [
                (f"patches/{n}", d) for n, d in old["patches"].items()]:
            values = np.tile(data[:], times)[:count] if "/" not in name else np.tile(data[:], times)[rows]
            new.create_dataset(name, data=first + of_patch[rows] if name == "patches/case" else values, chunks=values.shape,
                               fletcher32=True)


class Memory(unittest.TestCase):
    def test_it_does_not_grow_with_the_sweep(self):
        of_part, of_join = [], []
        for size in SIZES:
            with tempfile.TemporaryDirectory() as name:
                folder = Path(name)
                scene, parts, output = folder / "s.toml", folder / "parts", folder / "s.h5"
                scene.write_text(SCENE % (size // 1000) if size > 1000 else SCENE.replace(
                    "{ from = 0, to = 2e-3, count = %d }", "[0.0]"))  # the same first cases
                memory, code, said = memory_of("sweep", scene, "-o", folder / "solved.h5", "--cases", f"0:{SOLVED}")
                self.assertEqual(code, 0, said)
                of_part.append(memory)
                parts.mkdir()
                length = min(max(1_000, size // 100), 10_000)  # cases; a join holds one part at a time
                for first in range(0, size, length):
                    write_part(folder / "solved.h5", parts / f"{first}.h5", first, min(size, first + length))
                memory, code, said = memory_of("sweep", scene, "--join", parts, "-o", output, "--csv", folder / "s.csv")
                self.assertEqual(code, 0, said)
                self.assertIn(f"{size} of {size} cases are certified", said)
                of_join.append(memory)
                with h5py.File(folder / "solved.h5") as old, h5py.File(output) as new:
                    self.assertEqual(new["Fx"].shape, (size,))
                    whole = np.tile(old["Fx"][:], -(-length // SOLVED))[:length]
                    np.testing.assert_array_equal(new["Fx"][-len(whole):], whole)
                    self.assertEqual(new["patches/case"][-1], size - 1)
                with open(folder / "s.csv", encoding="utf-8") as lines:
                    self.assertEqual(sum(1 for _ in lines), size + 1)
                print(f"{size} cases: a part {of_part[-1]:.0f} MB, the join {memory:.0f} MB", flush=True)
        for used in (of_part, of_join):
            self.assertLess(max(used), MOST)
        self.assertLess(max(of_part) - min(of_part), 5)


if __name__ == "__main__":
    SIZES += [int(size) for size in sys.argv[1:] if size.isdigit()]
    unittest.main(argv=[sys.argv[0], *(a for a in sys.argv[1:] if not a.isdigit())])
