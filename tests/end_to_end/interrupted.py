"""Runs that are killed, disks that are full, folders that cannot be written to: a file is whole or absent."""

import os
import random
import re
import signal
import subprocess
import tempfile
import time
import unittest
from pathlib import Path

import h5py
import numpy as np

import programs

BODY = """
[body]
kind = "block"
size = 60
[strip]
from = -3
to = 3
station_width = 0.5
[mesh]
elements_per_station = 1
[harmonic]
degree = 2
shortest_dx = 0.5
samples_per_decade = 5
"""
ENVIRONMENT = os.environ | {name: "1" for name in (
    "OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "OMPI_ALLOW_RUN_AS_ROOT", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM")}


def runs(pid):
    """Whether a process still does something."""
    try:
        return Path(f"/proc/{pid}/stat").read_text().rsplit(")", 1)[1].split()[0] != "Z"
    except (FileNotFoundError, ProcessLookupError):
        return False


def descendants(pid):
    """All processes that `pid` started, and they in turn, and `pid`."""
    found, parents = [pid], {}
    for stat in Path("/proc").glob("[0-9]*/stat"):
        try:
            parents[int(stat.parent.name)] = int(stat.read_text().rsplit(")", 1)[1].split()[1])
        except OSError:
            pass
    for parent in found:
        found += [child for child, of in parents.items() if of == parent]
    return found


def on_a_small_disk(size, command, folder):
    """Runs the command with `folder` on a disk of `size` bytes, in a mount namespace of its own; its result, and
    the names of the files that were left there. None where this machine lets nobody do that."""
    script = 'mount -t tmpfs -o size="$1" tmpfs "$2" || exit 77; cp "$2.before"/* "$2"; shift; folder=$1; shift; ' \
             '"$@"; code=$?; ls "$folder" >"$folder.after"; exit $code'
    unshare = ["unshare", "--mount"] + ([] if os.geteuid() == 0 else ["--map-root-user"])
    run = subprocess.run([*unshare, "sh", "-c", script, "sh", str(size), folder, *command], env=ENVIRONMENT, text=True,
                         stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    after = Path(f"{folder}.after")
    if not after.exists():
        return None
    return run, after.read_text().split()


class Interrupted(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.folder = Path(cls.temporary.name)
        (cls.folder / "body.toml").write_text(BODY)
        subprocess.run([programs.BIN / "mesh_body", cls.folder / "body.toml", "-o", cls.folder / "body.msh"], check=True,
                       stdout=subprocess.DEVNULL)
        cls.largest_part = 0  # bytes of all finished wavenumbers
        run = cls.start("whole.h5", 1)
        while run.poll() is None:
            cls.largest_part = max(cls.largest_part, cls.size("whole.h5.part"))
            time.sleep(0.002)
        assert run.returncode == 0, run.stderr.read()
        run.stderr.close()

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    @classmethod
    def size(cls, name):
        try:
            return (cls.folder / name).stat().st_size
        except FileNotFoundError:
            return 0

    @classmethod
    def command(cls, output, processes=1):
        start = ["mpirun", "-n", str(processes), "--oversubscribe"] if processes > 1 else []
        return [*start, programs.BIN / "fem_influence", cls.folder / "body.toml", cls.folder / "body.msh", "-o",
                cls.folder / output]

    @classmethod
    def start(cls, output, processes):
        return subprocess.Popen(cls.command(output, processes), env=ENVIRONMENT, stderr=subprocess.PIPE, text=True)

    def complete(self, output, processes=1, **options):
        return subprocess.run(self.command(output, processes), env=ENVIRONMENT, text=True, stderr=subprocess.PIPE,
                              **options)

    def finish_all_but_the_file(self, output, parts):
        """As if killed between the last wavenumber and the file: second names keep the parts that a run removes."""
        run = self.start(output, 1)
        for part in parts:
            while not (self.folder / f"{part}.kept").exists():
                self.assertIsNone(run.poll())
                try:
                    os.link(self.folder / part, self.folder / f"{part}.kept")
                except FileNotFoundError:
                    time.sleep(0.001)
        self.assertEqual(run.wait(), 0)
        run.stderr.close()
        (self.folder / output).unlink()
        for part in parts:
            (self.folder / f"{part}.kept").rename(self.folder / part)

    def kill(self, output, processes, part):
        """Starts a run and kills it, with all its processes, as soon as its finished part is so large. Their numbers."""
        run = self.start(output, processes)
        while run.poll() is None and self.size(output + ".part") < part:
            time.sleep(0.001)
        killed = descendants(run.pid)
        for pid in killed:
            try:
                os.kill(pid, signal.SIGKILL)
            except ProcessLookupError:
                pass
        run.wait()
        while any(map(runs, killed)):  # what was killed within a call of the system ends with that call
            time.sleep(0.001)
        run.stderr.close()
        return killed

    def assert_same_file(self, output):
        with h5py.File(self.folder / "whole.h5") as whole, h5py.File(self.folder / output) as other:
            self.assertEqual(set(whole), set(other))
            for name in whole:
                np.testing.assert_allclose(other[name][:], whole[name][:], rtol=0, atol=1e-12 * abs(whole[name][:]).max(),
                                           err_msg=name)
            for name in whole.attrs:
                if "error" not in name:
                    self.assertEqual(whole.attrs[name], other.attrs[name], name)
        subprocess.run([programs.BIN / "bem_contact", "info", self.folder / output], check=True, stdout=subprocess.DEVNULL)

    def assert_nothing_under(self, output):
        """Neither the file nor anything half-written but the finished wavenumbers."""
        self.assertEqual([p.name for p in self.folder.glob(output + "*") if not p.name.endswith(".part")], [])

    def test_killed_at_any_time_a_second_call_ends_with_the_same_file(self):
        chance, resumed = random.Random(7), 0
        for run in range(10):
            output, processes = f"killed{run}.h5", 1 + run % 2
            killed = self.kill(output, processes, chance.uniform(0, self.largest_part))
            if (self.folder / output).exists():  # on a busy machine a run may end before it is killed: its file is whole
                self.assert_same_file(output)
                continue
            for pid in killed:  # one that was killed as it wrote the whole file could not tidy up
                (self.folder / f"{output}.tmp{pid}").unlink(missing_ok=True)
            self.assert_nothing_under(output)
            second = self.complete(output, 1 + chance.randrange(2), check=True)
            resumed += int(re.search(r"\((\d+) from an earlier run\)", second.stderr)[1]) > 0
            self.assertFalse((self.folder / (output + ".part")).exists())
            self.assert_same_file(output)
        self.assertGreater(resumed, 4)  # the kills did hit the runs

    def full(self, size, program, arguments, output, before=()):
        """The error of a run whose output goes to a full disk; nothing but inputs and finished parts is left."""
        with tempfile.TemporaryDirectory() as name:
            folder = Path(name, "disk")
            (folder.parent / "disk.before").mkdir()
            folder.mkdir()
            for file in (*before, "body.toml"):
                (folder.parent / "disk.before" / Path(file).name).write_bytes((self.folder / file).read_bytes())
            done = on_a_small_disk(size, [programs.BIN / program, *arguments, "-o", folder / output], folder)
        if done is None:
            self.skipTest("a small disk cannot be mounted here")
        run, left = done
        self.assertGreater(run.returncode, 0, run.stderr)  # no signal
        self.assertEqual([f for f in left if not f.endswith(".part")], ["body.toml"])
        return run.stderr

    def test_a_full_disk(self):
        inputs = [self.folder / "body.toml", self.folder / "body.msh"]
        for size in (8192, self.largest_part // 2):
            self.assertRegex(self.full(size, "fem_influence", inputs, "x.h5"),
                             r"x\.h5(\.companion)?\.part' cannot be written")
        # All wavenumbers are done and there is no room for the file itself.
        parts = ["end.h5.part", "end.h5.companion.part"]
        self.finish_all_but_the_file("end.h5", parts)
        self.assertGreaterEqual(self.size(parts[0]), self.largest_part)
        room = sum(8192 * (self.size(part) // 8192 + 2) for part in parts) + self.size("whole.h5") // 2
        self.assertIn("end.h5' cannot be written", self.full(room, "fem_influence", inputs, "end.h5", before=parts))
        self.assertIn("from an earlier run", self.complete("end.h5", check=True).stderr)
        self.assert_same_file("end.h5")

    def test_a_full_disk_for_the_other_programs(self):
        file, grid = self.folder / "whole.h5", ["--dx", "0.5", "--ds", "0.5", "--mx", "9", "--my", "9"]
        for program, arguments, output in (
                ("mesh_body", [self.folder / "body.toml"], "x.msh"),
                ("bem_contact", ["influence", "expand", file, *grid], "x.h5"),
                ("bem_contact", ["influence", "expand", file, *grid], "x.csv"),
                ("bem_contact", ["influence", "expand", file, file, *grid, "--format", "contact"], "x.txt")):
            with self.subTest(output):
                error = self.full(8192, program, arguments, output)
                self.assertIn("cannot be written", error)
                self.assertIn(output, error)

    def test_a_folder_that_cannot_be_written_to(self):
        (self.folder / "file").write_text("")
        for where in ("none", "file"):
            run = self.complete(f"{where}/x.h5")
            self.assertEqual(run.returncode, 2)
            self.assertIn("cannot be written", run.stderr)
        if os.geteuid() != 0:  # root may write everywhere
            (self.folder / "closed").mkdir(mode=0o500)
            self.assertIn("cannot be written", self.complete("closed/x.h5").stderr)


if __name__ == "__main__":
    unittest.main()
