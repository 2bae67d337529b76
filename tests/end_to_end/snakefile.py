"""tools/cluster/Snakefile: what its config.toml may say, and whole plans on this machine and by a stand-in of Slurm. Plans need
Debian's package snakemake; tools/checks/try_slurm tries a real Slurm."""

import os
import shutil
import subprocess
import sys
import tempfile
import time
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
  case $1 in --job-name=*) name=${1#*=} ;; --mem-per-cpu=*) echo "$1" >>"$SPOOL/memory" ;; esac
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

    def refused_text(self, text):
        Path("config.toml").write_text(text)
        return self.refused_file("config.toml")

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

    def test_with_slots_the_last_parts_are_the_shortest(self):
        for cases, least, slots in ((500, 32, 1000), (5000, 64, 10), (100_000, 64, 8), (5_000_000, 96, 1000)):
            rounds = cluster_tasks.rounds_of(cases, least, slots)
            parts = [part for parts in rounds for part in parts]
            self.assertEqual([first for first, last in parts], [0] + [last for first, last in parts[:-1]])
            self.assertEqual(parts[-1][1], cases)
            self.assertTrue(all(first % 32 == 0 for first, last in parts))
            sizes = [parts[0][1] - parts[0][0] for parts in rounds]
            self.assertEqual(sizes, sorted(sizes, reverse=True))
            self.assertEqual(sizes[-1], least)
            self.assertTrue(all(len(parts) == slots for parts in rounds[:-1]))

    def test_keys_of_a_wrong_type(self):
        for tries in ('"x"', "-1", "true", "[]", "1.5", "nan"):
            self.assertIn("tries cannot be", self.refused(f"tries = {tries}\n"))
        self.assertIn("programs cannot be 3", self.refused_text("programs = 3\n"))
        self.assertIn("Rename the file", self.refused('[[sweep]]\nscene = "--help"\noutput = "o"\n'))
        Path("s.toml").write_text(SWEEP)
        for result in ('output = "s.toml"', 'output = "o.h5"\ncsv = "./s.toml"', 'output = "config.toml"'):
            self.assertIn("would be replaced", self.refused(f'[[sweep]]\nscene = "s.toml"\n{result}\n'))

    def test_a_wrong_scene_is_refused_before_anything_runs(self):
        Path("s.toml").write_text(SWEEP.replace("load.force", "load.farce"))
        self.assertIn("load.farce", self.refused('[[sweep]]\nscene = "s.toml"\noutput = "o.h5"\n'))
        Path("s.toml").write_text('rail.influence = "absent.h5"\n' + SWEEP)
        self.assertIn("no [[body]] makes it", self.refused('[[sweep]]\nscene = "s.toml"\noutput = "o.h5"\n'))

    def test_inputs_are_what_the_scene_names(self):
        """Half-space scenes have no body's file among them, and a file of a list is one."""
        Path("bodies").mkdir()
        for name in ("a", "b", "c"):
            Path("bodies", f"{name}.toml").write_text(SMALL_BLOCK)
        Path("s.toml").write_text(SWEEP + 'rail.influence = ["influence/a.h5", "influence/c.h5"]\n')
        Path("h.toml").write_text(SWEEP)
        Path("f.toml").write_text(SWEEP + '[fit]\nmeasured = ["points.csv", "absent.csv"]\nparameters = "motion.friction"\n')
        Path("points.csv").write_text("xi,Fx\n1e-3,500\n")
        plan = self.plan('[[body]]\nfiles = ["bodies/*.toml"]\nfolder = "influence"\n'
                         '[[sweep]]\nscene = "s.toml"\noutput = "o.h5"\n[[sweep]]\nscene = "h.toml"\noutput = "h.h5"\n'
                         '[[study]]\nscene = "f.toml"\nfolder = "f"\n')
        self.assertEqual([sweep.inputs for sweep in plan.sweeps], [["s.toml", "influence/a.h5", "influence/c.h5"], ["h.toml"]])
        self.assertEqual([study.inputs for study in plan.studies], [["f.toml", "points.csv"]])

    def test_what_a_killed_snakemake_leaves_is_removed(self):
        Path("s.toml").write_text(SWEEP)
        sweep = self.plan('[[sweep]]\nscene = "s.toml"\noutput = "o.h5"\ncases = 4\nminutes = 10\n').sweeps[0]
        files = {name: Path("o.h5.parts", name) for name in ("9_by_4/0-4.h5", "9_by_4/4-8.h5.tmp77", "9_by_4/8-9.h5.tmp8", "9_by_4/mine.h5",
                                                             "9_by_3/0-3.h5", "notes/0-3.h5")}
        for file in files.values():
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_text("")
        os.utime(files["9_by_4/8-9.h5.tmp8"], (0, 0))
        left = lambda: {name for name, file in files.items() if file.exists()}
        sweep.remove_leftovers(time.time())  # a task may still write 4-8.h5
        self.assertEqual(left(), {"9_by_4/0-4.h5", "9_by_4/4-8.h5.tmp77", "9_by_4/mine.h5", "notes/0-3.h5"})
        Path("o.h5").write_text("joined")
        os.utime(files["9_by_4/0-4.h5"], (1, 1))
        sweep.remove_leftovers(time.time() + 700)
        self.assertEqual(left(), {"9_by_4/mine.h5", "notes/0-3.h5"})

    def test_names_that_snakemake_cannot_quote_are_refused(self):
        for name in ("", "-a", "a{b}", "a\\b", "a\nb", "it's \"both\"", "it's $(touch ran)", "it's `touch ran`"):
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

    def check_sweep(self):
        results = self.folder / "results"
        subprocess.run([BIN / "bem_contact", "sweep", 'a "sweep".toml', "-o", "one.h5", "--jobs", "1"], cwd=self.folder,
                       check=True, capture_output=True)
        with h5py.File(results / "it's two  blanks.h5") as joined, h5py.File(self.folder / "one.h5") as one:
            self.assertEqual(list(joined["position.lateral"]), list(one["position.lateral"]))
            for a, b in zip(joined["Fx"], one["Fx"]):
                self.assertAlmostEqual(a, b, delta=1e-6 * 0.3 * 8e4)
        self.assertEqual(len((results / "it's.csv").read_text().splitlines()), 10)
        self.assertEqual(list(self.folder.rglob("ran")), [])

    def check_results(self):
        self.check_sweep()
        results = self.folder / "results"
        self.assertTrue((results / "worn 'pair'" / "rail.txt").exists())
        self.assertTrue((results / "a study" / "study.h5").exists())
        self.assertTrue((results / "forces.h5").exists())
        self.assertEqual(len(list((self.folder / "influence files").glob("*.h5"))), 2)

    def test_on_this_machine(self):
        self.snakemake("--cores", "2")
        self.check_results()
        self.assertIn("Nothing to be done", self.snakemake("--cores", "2"))

    def planned(self):
        """How many tasks of each rule a call would run."""
        told = self.snakemake("--dry-run")
        if "Nothing to be done" in told:
            return {}
        lines = told[told.index("Job stats:"):].split("\n\n")[0].splitlines()[3:]
        return {words[0]: int(words[1]) for words in map(str.split, lines) if words and words[0] not in ("all", "total")}

    def only(self, *tables):
        """A plan of the half-space sweep and these tables."""
        sweep = PLAN[PLAN.index("[[sweep]]"):PLAN.index("[[wear]]")]
        (self.folder / "config.toml").write_text("\n".join(tables) + "\n" + sweep)

    def test_one_more_body_makes_that_body(self):
        bodies = PLAN[:PLAN.index("[[sweep]]")]
        (self.folder / "fem.toml").write_text('rail.influence = "influence files/it\'s small.h5"\n' + TABLE)
        table = '[[table]]\nscene = "fem.toml"\noutput = "fem.h5"\noptions = [ "--tolerance", "0.5" ]\n'
        self.only(bodies, table)
        self.assertEqual(self.planned(), {"body_it_s_small": 1, "body__small_touch_ran_": 1, "part_of_it_s_two_blanks": 3,
                                          "join_it_s_two_blanks": 1, "table_fem": 1})
        self.snakemake("--cores", "2")
        self.assertEqual(self.planned(), {})
        (self.folder / "my bodies" / "third.toml").write_text(SMALL_BLOCK)
        self.assertEqual(self.planned(), {"body_third": 1})
        (self.folder / "my bodies" / "it's small.toml").write_text(SMALL_BLOCK + "# corrected\n")
        self.assertEqual(self.planned(), {"body_third": 1, "body_it_s_small": 1, "table_fem": 1})

    def test_damaged_parts_are_removed_and_solved_again(self):
        """A join that finds them names all, and the next call solves them and no others."""
        self.only()
        parts = self.folder / "results" / "it's two  blanks.h5.parts" / "9_by_4"
        program = self.folder / "programs" / "bem_contact"
        program.parent.mkdir()
        # Before it joins for the first time, the disk loses two of the parts.
        program.write_text(f"""#!/usr/bin/env bash
case "$*" in *--all-cases*) if [ ! -e damaged ]; then
  touch damaged
  truncate --size=100 results/*/9_by_4/0-4.h5
  truncate --size=100 results/*/9_by_4/8-9.h5
fi ;; esac
echo "$*" >> calls
exec '{BIN}/bem_contact' "$@"
""")
        program.chmod(0o755)
        config = self.folder / "config.toml"
        config.write_text('programs = "programs"\n' + config.read_text())
        told = self.failed("--cores", "2")
        for name in ("0-4.h5", "8-9.h5"):
            self.assertRegex(told, f"removed, because it is damaged: .*{name}")
        self.assertIn("2 parts of the sweep cannot be joined", told)
        calls = (self.folder / "calls").read_text()
        self.assertEqual(calls.count("--all-cases"), 1)
        self.assertEqual(self.planned(), {"part_of_it_s_two_blanks": 2, "join_it_s_two_blanks": 1})
        self.snakemake("--cores", "2")
        self.assertEqual(self.planned(), {})
        self.assertFalse(parts.exists())

    def failed(self, *arguments):
        done = subprocess.run(["snakemake", "--snakefile", CLUSTER / "Snakefile", *arguments], cwd=self.folder, env=self.environment,
                              capture_output=True, text=True)
        self.assertNotEqual(done.returncode, 0)
        return done.stdout + done.stderr

    def test_with_slurm(self):
        """One sweep: each of its jobs is a Snakemake of its own, whose start takes longer than its cases."""
        self.begin_slurm()
        self.only()
        told = self.snakemake("--profile", CLUSTER / "profiles" / "slurm", "--jobs", "4")
        self.assertTrue((self.folder.parent / "spool" / "killed").exists())
        self.assertIn("Trying to restart job", told)
        self.check_sweep()

    def test_a_task_is_tried_as_often_as_asked_and_a_wrong_scene_once(self):
        """With more memory each time. Slurm's jobs are Snakemakes, too, and try nothing again."""
        self.begin_slurm()
        (self.folder.parent / "spool" / "killed").mkdir()
        program = self.folder / "programs" / "bem_contact"
        program.parent.mkdir()
        for code, tries in ((1, 3), (2, 1)):
            program.write_text(f"""#!/usr/bin/env bash
case "$*" in *--cases*) echo tried >> tried-{code}; echo "no memory, or no scene" >&2; exit {code} ;; esac
exec '{BIN}/bem_contact' "$@"
""")
            program.chmod(0o755)
            self.only('programs = "programs"', "tries = 2")
            config = self.folder / "config.toml"
            config.write_text(config.read_text().replace("cases = 4", "cases = 9"))
            told = self.failed("--profile", CLUSTER / "profiles" / "slurm", "--jobs", "4")
            self.assertEqual((self.folder / f"tried-{code}").read_text().splitlines(), ["tried"] * tries, told)
            self.assertIn("no memory, or no scene", told)
        memory = (self.folder.parent / "spool" / "memory").read_text().split()
        self.assertEqual(memory[:3], ["--mem-per-cpu=1000", "--mem-per-cpu=2000", "--mem-per-cpu=3000"])

    def begin_slurm(self):
        spool = self.folder.parent / "spool"
        spool.mkdir()
        for name, text in (("sbatch", SBATCH), ("scontrol", SCONTROL)):
            program = self.folder.parent / name
            program.write_text(text)
            program.chmod(0o755)
        self.environment |= {"PATH": f"{self.folder.parent}:{os.environ['PATH']}", "SPOOL": str(spool)}


class OldScripts(unittest.TestCase):
    def test_the_old_command_names_the_new_one(self):
        done = subprocess.run([CLUSTER / "slurm_sweep", "s.toml", "s.h5", "8"], capture_output=True, text=True)
        self.assertEqual(done.returncode, 2)
        self.assertIn("snakemake --snakefile", done.stderr)


if __name__ == "__main__":
    unittest.main()
