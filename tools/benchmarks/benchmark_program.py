"""Builds the benchmark programs for the tools beside this file."""

import pathlib
import subprocess

ROOT = pathlib.Path(__file__).resolve().parents[2]


def build_benchmark(folder, name):
    """The program's path, built anew where its sources changed. A folder without a build gets one without finite elements."""
    if not (folder / "build.ninja").exists():
        subprocess.run(["cmake", "-S", ROOT, "-B", folder, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release",
                        "-DCONFORMAL_WITH_FEM=OFF"], check=True, stdout=subprocess.DEVNULL)
    done = subprocess.run(["cmake", "--build", folder, "-j", "2", "--target", name], stdout=subprocess.PIPE, text=True)
    if done.returncode != 0:
        raise SystemExit(f"{done.stdout[-2000:]}\n{name} could not be built in '{folder}' (see above) Mend it, or give another "
                         "folder with --build.")
    return folder / "bin" / name
