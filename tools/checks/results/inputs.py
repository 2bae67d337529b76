"""The folder of inputs of a store: scenes, bodies and influence files, so that every program reads the same bytes.

    data/             a copy of the project's scenes, bodies and small influence files
    data/scenes/      also sweeps with their fields kept (swept_*) and random cases (random_*)
    demo/             influence files of the bodies that the scenes name, made by the program's own mesh_body and fem_influence
"""

import importlib.machinery
import importlib.util
import os
import re
import shutil
import subprocess

BODIES = {"rail_60E1": "rail_60E1_gauge_corner", "wheel_S1002": "wheel_S1002_flange_root"}  # as tools/demo names them
RANDOM_CASES, SEED, CASES_A_FILE = 500, 1, 100
ACCURACY = 0.02  # grid.accuracy of the random cases, as tools/benchmarks/random_cases asks for it, and of some sweeps
SWEPT = "swept_"  # begins the name of a sweep that keeps its fields
ENVIRONMENT = os.environ | {"OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1"}


def write_random_cases(root, scenes):
    """The cases of tools/benchmarks/random_cases, cut into files of a hundred so that they can be solved side by side."""
    loader = importlib.machinery.SourceFileLoader("random_cases", str(root / "tools" / "benchmarks" / "random_cases"))
    module = importlib.util.module_from_spec(importlib.util.spec_from_loader("random_cases", loader))
    loader.exec_module(module)
    lists = module.random_lists(SEED, RANDOM_CASES)
    for start in range(0, RANDOM_CASES, CASES_A_FILE):
        part = {key: values[start:start + CASES_A_FILE] for key, values in lists.items()}
        text = re.sub(r'"[^"]*/data/bodies/', '"../bodies/', module.scene(part, ACCURACY, "true"))  # no path of this machine
        (scenes / f"random_{start:03d}.toml").write_text(text)


def write_variants(scenes):
    """Each sweep with its fields kept, also on the files of tools/demo, with an accuracy, frictionless; a scene with an accuracy."""
    for file in sorted(scenes.glob("cases_*.toml")):
        text = re.sub(r"^fields = false$", "fields = true", file.read_text(), flags=re.M)
        texts = {"": text}
        if "../influence/small_" in text:
            demo = text.replace("../influence/small_rail.h5", "../../demo/rail_60E1.h5")
            texts["_demo"] = demo.replace("../influence/small_wheel.h5", "../../demo/wheel_S1002.h5")
        else:
            texts["_frictionless"] = text.replace("[sweep]\n", "motion.frictionless = true\n[sweep]\n").replace(
                'solver.model = "halfspace"', 'solver.model = "auto"')
        if "grid.accuracy" not in text:
            texts |= {f"{kind}_accuracy": t.replace("[sweep]\n", f"grid.accuracy = {ACCURACY}\n[sweep]\n")
                      for kind, t in texts.items()}
        for kind, t in texts.items():
            (scenes / f"{SWEPT}{file.stem}{kind}.toml").write_text(t)
    small = (scenes / "conformal_small.toml").read_text()
    small = re.sub(r"^dx = .*\n", f"accuracy = {ACCURACY}\n", re.sub(r"^ds = .*\n", "", small, flags=re.M), flags=re.M)
    (scenes / "conformal_small_accuracy.toml").write_text(small)


def influence_files(scenes):
    """Names of the files in demo/ that some scene reads."""
    return sorted({name for file in scenes for name in re.findall(r'"\.\./\.\./demo/(\w+)\.h5"', file.read_text())})


def make_influence_file(name, program, folder):
    """By the commands of tools/influence."""
    body = folder / "data" / "bodies" / f"{BODIES.get(name, name)}.toml"
    mesh_body, fem_influence = (program.parent / p for p in ("mesh_body", "fem_influence"))
    if not (mesh_body.exists() and fem_influence.exists()):
        raise SystemExit(f"same_results: the influence file demo/{name}.h5 is not there (it is made by mesh_body and "
                         f"fem_influence, which '{program.parent}' does not have) build the preset `full`, or leave the scenes "
                         "that read it out with --only")
    out = folder / "demo" / f"{name}.h5"
    log = out.with_suffix(".log")
    mpi = {"OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1"}
    with open(log, "w") as file:
        for command in ([mesh_body, body, "-o", out.with_suffix(".msh")],
                        ["mpirun", "-n", "2", "--oversubscribe", fem_influence, body, out.with_suffix(".msh"), "-o", out]):
            done = subprocess.run(command, stdout=file, stderr=subprocess.STDOUT, env=ENVIRONMENT | mpi)
            if done.returncode:
                raise SystemExit(f"same_results: the influence file demo/{name}.h5 was not made (the last lines of '{log}' say "
                                 "why) mend it, or leave the scenes that read it out with --only")


def prepare(root, folder, program, chosen, say):
    """Fills `folder`; what is there is kept. `chosen(file name)` tells which scenes will be solved."""
    for part in ("scenes", "bodies", "influence"):
        if not (folder / "data" / part).exists():
            shutil.copytree(root / "data" / part, folder / "data" / part)
    scenes = folder / "data" / "scenes"
    write_variants(scenes)
    write_random_cases(root, scenes)
    (folder / "demo").mkdir(exist_ok=True)
    for name in influence_files([s for s in scenes.glob("*.toml") if chosen(s.stem)]):
        if not (folder / "demo" / f"{name}.h5").exists():
            say(f"making demo/{name}.h5")
            make_influence_file(name, program, folder)
