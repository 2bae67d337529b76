"""tools/cluster/Snakefile: what its config.toml may say, and whole plans on this machine and by a stand-in of Slurm. Plans need
Debian's package snakemake; tools/checks/try_slurm tries a real Slurm."""

import os
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import h5py

from programs import BIN, ROOT, SMALL_BLOCK

CLUSTER = ROOT / "tools" / "cluster"
sys.path.insert(0, str(CLUSTER))
import cluster_tasks  # noqa: E402

PAIR = """rail.profile = "60E1"
wheel.profile = "S1002"
solver.model = "halfspace"
load.force = 8e4
position.rail_inclination = 0.025
motion = { friction = 0.3, xi = 1e-3, free_rolling = false }
grid = { dx = 0.8, ds = 0.5 }
"""
SWEEP = PAIR + "[sweep]\nposition.lateral = { from = -4, to = -1, count = 9 }\n"
WEAR = PAIR + '[sweep]\nmode = "zip"\nposition.lateral = [ -2.0, -1.0 ]\nweight = [ 1, 3 ]\n'
TABLE = PAIR + "[table]\nposition.lateral = [ -4, -3 ]\nload.force = [ 4e4, 6e4 ]\n"
# A shell would run the second name of a body, if it were given it without quotes.
PLAN = r"""
[[body]]
files = [ "my bodies/*.toml" ]
folder = "influence files"
[[sweep]]
scene = 'a "sweep".toml'
output = "results/it's two  blanks.h5"
csv = "results/it's.csv"
cases = 4
[[wear]]
scene = "wear.toml"
folder = "results/worn 'pair'"
options = [ "--depth", "0.02", "--cap", "0.01" ]
[[study]]
scene = "study.toml"
folder = "results/a study"
[[table]]
scene = "table.toml"
output = "results/forces.h5"
options = [ "--tolerance", "0.5" ]
"""
SBATCH = """#!/usr/bin/env bash
# Runs the script beside its caller, and kills the first part of a sweep: Slurm says that it was cancelled.
set -eu
while [[ $1 == --* ]]; do
  case $1 in --job-name=*) name=${1#*=} ;; esac
  shift
done
id=$(mktemp -p "$SPOOL" job-XXXXXX)
if [[ $name == part_of_* ]] && mkdir "$SPOOL/killed" 2>/dev/null; then
  echo CANCELLED >"$id"
else
  echo RUNNING >"$id"
  { if bash "$1" >"$id.txt" 2>&1; then echo COMPLETED >"$id"; else echo FAILED >"$id"; fi; } >/dev/null 2>&1 &
fi
basename "$id"
"""
SCONTROL = """#!/usr/bin/env bash
echo "JobId=$4 JobName=x JobState=$(cat "$SPOOL/$4") Reason=None"
"""


class Config(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = Path(temporary.name)
        self.addCleanup(os.chdir, os.getcwd())
        os.chdir(self.folder)

    def plan(self, text):
        Path("config.toml").write_text(f'programs = "{BIN}"\n' + text)
        return cluster_tasks.read("config.toml", CLUSTER)

    def refused(self, text):
        with self.assertRaises(cluster_tasks.ConfigError) as caught:
            self.plan(text)
        return str(caught.exception)

    def refused_file(self, file):
        with self.assertRaises(cluster_tasks.ConfigError) as caught:
            cluster_tasks.read(file, CLUSTER)
        return str(caught.exception)

    def test_each_case_is_in_one_part(self):
        Path("s.toml").write_text(PAIR + "[sweep]\nposition.lateral = { from = 0, to = 1, count = 250 }\nload.force = [1e4, 2e4]\n")
        for size in (1, 7, 32, 500, 3200):
            files = self.plan(f'[[sweep]]\nscene = "s.toml"\noutput = "o.h5"\ncases = {size}\n').sweeps[0].part_files()
            ranges = [[int(number) for number in Path(file).stem.split("-")] for file in files]
            self.assertEqual([case for first, last in ranges for case in range(first, last)], list(range(500)))
            self.assertLessEqual(max(last - first for first, last in ranges), size)

    def test_what_is_wrong_is_said(self):
        self.assertIn("Copy tools/cluster/config.toml", self.refused_file("absent.toml"))
        Path("s.toml").write_text(SWEEP)
        self.assertIn("not valid TOML", self.refused("[[sweep]\n"))
        self.assertIn("unknown key 'swep'", self.refused("[[swep]]\n"))
        self.assertIn("sweep is no list of tables", self.refused("[sweep]\n"))
        self.assertIn("unknown key 'case' in [[sweep]]", self.refused('[[sweep]]\nscene = "s.toml"\noutput = "o"\ncase = 3\n'))
        for tries in ('"x"', "-1", "true", "[]", "1.5", "nan"):
            self.assertIn("tries cannot be", self.refused(f"tries = {tries}\n"))
        self.assertIn("begins with -", self.refused('[[sweep]]\nscene = "--help"\noutput = "o.h5"\n'))
        self.assertIn("has no output", self.refused('[[sweep]]\nscene = "s.toml"\n'))
        self.assertIn("sweep.cases cannot be 0", self.refused('[[sweep]]\nscene = "s.toml"\noutput = "o"\ncases = 0\n'))
        self.assertIn("absent.toml", self.refused('[[sweep]]\nscene = "absent.toml"\noutput = "o"\n'))
        self.assertIn("no body file 'b/*.toml'", self.refused('[[body]]\nfiles = ["b/*.toml"]\nfolder = "i"\n'))
        self.assertIn("two tasks write", self.refused('[[table]]\nscene = "a"\noutput = "o"\n[[table]]\nscene = "b"\noutput = "./o"\n'))
        Path("other.toml").write_text('programs = "absent"\n')
        self.assertIn("no program bem_contact", self.refused_file("other.toml"))

    def test_names_that_snakemake_cannot_quote_are_refused(self):
        for name in ("", "a{b}", "a\\b", "a\nb", "it's \"both\"", "it's $(touch ran)", "it's `touch ran`"):
            self.assertFalse(cluster_tasks.is_safe(name), name)
        for name in ("it's fine", 'a "b"', "$(touch ran)", "`touch ran`", "two  blanks", "Räder;&"):
            self.assertTrue(cluster_tasks.is_safe(name), name)
        self.assertIn("Rename the file", self.refused('[[table]]\nscene = "{a}"\noutput = "o"\n'))


@unittest.skipUnless(shutil.which("snakemake"), "Snakemake is not installed (Debian's package snakemake)")
class Plans(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = Path(temporary.name) / "it's a folder"
        (self.folder / "my bodies").mkdir(parents=True)
        for body in ("it's small", '"small" $(touch ran)'):
            (self.folder / "my bodies" / f"{body}.toml").write_text(SMALL_BLOCK)
        for name, text in (('a "sweep".toml', SWEEP), ("wear.toml", WEAR), ("study.toml", PAIR), ("table.toml", TABLE), ("config.toml", PLAN)):
            (self.folder / name).write_text(text)
        self.environment = os.environ | {"CONFORMAL_BIN": str(BIN)}

    def snakemake(self, *arguments):
        done = subprocess.run(["snakemake", "--snakefile", CLUSTER / "Snakefile", *arguments], cwd=self.folder,
                              env=self.environment, capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        return done.stdout + done.stderr

    def check_results(self):
        results = self.folder / "results"
        subprocess.run([BIN / "bem_contact", "sweep", 'a "sweep".toml', "-o", "one.h5", "--jobs", "1"], cwd=self.folder,
                       check=True, capture_output=True)
        with h5py.File(results / "it's two  blanks.h5") as joined, h5py.File(self.folder / "one.h5") as one:
            self.assertEqual(list(joined["position.lateral"]), list(one["position.lateral"]))
            for a, b in zip(joined["Fx"], one["Fx"]):
                self.assertAlmostEqual(a, b, delta=1e-6 * 0.3 * 8e4)
        self.assertEqual(len((results / "it's.csv").read_text().splitlines()), 10)
        self.assertTrue((results / "worn 'pair'" / "rail.txt").exists())
        self.assertTrue((results / "a study" / "study.h5").exists())
        self.assertTrue((results / "forces.h5").exists())
        self.assertEqual(len(list((self.folder / "influence files").glob("*.h5"))), 2)
        self.assertEqual(list(self.folder.rglob("ran")), [])

    def test_on_this_machine(self):
        self.snakemake("--cores", "2")
        self.check_results()
        self.assertIn("Nothing to be done", self.snakemake("--cores", "2"))

    def test_with_slurm(self):
        spool = self.folder.parent / "spool"
        spool.mkdir()
        for name, text in (("sbatch", SBATCH), ("scontrol", SCONTROL)):
            program = self.folder.parent / name
            program.write_text(text)
            program.chmod(0o755)
        self.environment |= {"PATH": f"{self.folder.parent}:{os.environ['PATH']}", "SPOOL": str(spool)}
        told = self.snakemake("--profile", CLUSTER / "profiles" / "slurm", "--jobs", "4")
        self.assertTrue((spool / "killed").exists())
        self.assertIn("Trying to restart job", told)
        self.check_results()


class OldScripts(unittest.TestCase):
    def test_the_old_command_names_the_new_one(self):
        done = subprocess.run([CLUSTER / "slurm_sweep", "s.toml", "s.h5", "8"], capture_output=True, text=True)
        self.assertEqual(done.returncode, 2)
        self.assertIn("snakemake --snakefile", done.stderr)


if __name__ == "__main__":
    unittest.main()
