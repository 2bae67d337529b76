"""tools/cluster/slurm_influence with a stand-in of sbatch: Slurm runs a copy of the script from its own spool, in the folder of
submission. mpirun is told how many processes there are, which it would ask Slurm."""

import os
import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path

from programs import BIN, ROOT

SBATCH = """#!/usr/bin/env bash
set -eu
cp "$1" "$SPOOL/slurm_script"
shift
export SLURM_SUBMIT_DIR=$PWD
exec bash "$SPOOL/slurm_script" "$@"
"""
MPIRUN = f"""#!/usr/bin/env bash
echo "mpirun $*" >> "$SPOOL/steps"
exec {shutil.which("mpirun")} --oversubscribe -n 2 "$@"
"""
BODY = """[body]
kind = "block"
size = 40.0
[strip]
from = -2.0
to = 2.0
station_width = 0.5
[harmonic]
degree = 2
border_levels = 1
half_period = 120.0
shortest_dx = 0.5
"""


class Slurm(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = Path(temporary.name)
        self.spool = self.folder / "spool"
        self.spool.mkdir()
        for name, text in (("sbatch", SBATCH), ("mpirun", MPIRUN)):
            program = self.folder / name
            program.write_text(text)
            program.chmod(0o755)
        self.body = self.folder / "block.toml"
        self.body.write_text(BODY)
        self.environment = os.environ | {
            "PATH": f"{self.folder}:{os.environ['PATH']}", "SPOOL": str(self.spool), "CONFORMAL_BIN": str(BIN),
            "OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1"}

    def submit(self, *arguments, **changes):
        return subprocess.run(["sbatch", ROOT / "tools" / "cluster" / "slurm_influence", *arguments], cwd=self.folder,
                              env=self.environment | changes, capture_output=True, text=True)

    def test_a_job_writes_the_file_of_a_run_without_slurm(self):
        out = self.folder / "block.h5"
        done = self.submit(self.body, out)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(len((self.spool / "steps").read_text().splitlines()), 1)
        plain = self.folder / "plain.h5"
        subprocess.run([BIN / "fem_influence", self.body, self.folder / "block.msh", "-o", plain], check=True,
                       capture_output=True)
        self.assertEqual(out.read_bytes(), plain.read_bytes())

    def test_the_programs_are_found_from_where_the_job_was_submitted(self):
        (self.folder / "build").mkdir()
        (self.folder / "build" / "bin").symlink_to(BIN)
        del self.environment["CONFORMAL_BIN"]
        done = self.submit("block.toml", "block.h5")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertTrue((self.folder / "block.h5").exists())

    def test_what_is_wrong_is_said(self):
        self.assertIn("two arguments are needed", self.submit(self.body).stderr)
        refused = self.submit(self.body, self.folder / "x.h5", CONFORMAL_BIN=str(self.folder / "absent"))
        self.assertEqual(refused.returncode, 2)
        self.assertIn("no program in", refused.stderr)


if __name__ == "__main__":
    unittest.main()
