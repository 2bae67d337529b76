"""fem_influence with a process on each of two computers: the same bytes. Both are this machine under two names: instead of ssh,
mpirun calls a script that gives its process another name of the machine. (Its name is not ssh, to which mpirun gives more options.
They reach each other by lo, as both have one address.)"""

import os
import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path

from programs import BIN, SMALL_BLOCK

UNSHARE = ["unshare", "--uts"] + ([] if os.geteuid() == 0 else ["--map-root-user"])
START = f"""#!/usr/bin/env bash
host=$1
shift
exec {" ".join(UNSHARE)} bash -c 'hostname "$1"; exec bash -c "$2"' start "$host" "$*"
"""


class TwoComputers(unittest.TestCase):
    def test_the_file_is_that_of_one_computer(self):
        if not shutil.which("unshare") or subprocess.run([*UNSHARE, "hostname", "other"], capture_output=True).returncode != 0:
            self.skipTest("a process cannot get another name of the machine here")
        with tempfile.TemporaryDirectory() as temporary:
            folder = Path(temporary)
            (folder / "block.toml").write_text(SMALL_BLOCK)
            (folder / "start").write_text(START)
            (folder / "start").chmod(0o755)
            environment = os.environ | {name: "1" for name in (
                "OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "OMPI_ALLOW_RUN_AS_ROOT", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM")}
            subprocess.run([BIN / "mesh_body", "block.toml", "-o", "block.msh"], cwd=folder, check=True, capture_output=True)
            for file, start in (("one.h5", []), ("two.h5", ["mpirun", "-n", "2", "--host", "first:1,second:1", "--mca", "btl_tcp_if_include", "lo",
                                                           "--mca", "plm_rsh_agent", str(folder / "start")])):
                done = subprocess.run([*start, BIN / "fem_influence", "block.toml", "block.msh", "-o", file], cwd=folder,
                                      env=environment, capture_output=True, text=True, timeout=300)
                self.assertEqual(done.returncode, 0, done.stderr)
            self.assertEqual((folder / "one.h5").read_bytes(), (folder / "two.h5").read_bytes())


if __name__ == "__main__":
    unittest.main()
