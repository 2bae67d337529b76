"""What the tools beside this file share: their programs, influence files, and processor time."""

import os
import pathlib
import resource
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


def processor_seconds():
    """Of all programs that were called and have ended."""
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def make_influence_functions(body, file, programs, quiet=False):
    """tools/influence with the programs of a folder: nothing where the file is newer than the body. Processor seconds."""
    begin = processor_seconds()
    said = subprocess.DEVNULL if quiet else None
    done = subprocess.run([ROOT / "tools" / "influence", body, file], stdout=said, stderr=said,
                          env=os.environ | {"CONFORMAL_BIN": str(pathlib.Path(programs).resolve())})
    if done.returncode != 0:
        raise SystemExit(f"No influence functions of '{body}' (tools/influence failed) Call it alone to see why.")
    return processor_seconds() - begin
