"""One record for each solve: its status, its numbers, its words and its fields.

A record is a dictionary
    status   "certified", "not certified", "refused", "not converged", "died", "no answer" (within the time limit)
    numbers  {name: number or None}; the last word of the name says what it is: "patch 2 Fn", "step 14 approach"
    words    {name: text}: the model, its reason, warnings, the message of a refusal
    effort   {name: number}: iterations and seconds, which may differ although the result is the same
    fields   {name: array}: state (0 exterior, 1 adhesion, 2 slip), p_n, p_x, p_s and more
"""

import csv
import json
import re
import subprocess
import tempfile
from pathlib import Path

import h5py
import numpy as np

from .inputs import ENVIRONMENT

SWEPT_FIELDS = ("state", "p_n", "p_x", "p_s")  # of a sweep's case; a scene on its own keeps every field
EFFORT = {"seconds", "cpu_seconds", "outer_iterations", "normal_iterations", "tangential_iterations", "certificate"}
MODELS = ("hertz", "halfspace", "tangent_plane", "fem")
TIME_LIMIT = 900  # s, for one command


def words_of(text, folder):
    """A message without colours and without the place of the inputs."""
    return re.sub(r"\x1b\[[0-9;]*m", "", text).replace(str(folder), "INPUTS").strip()


def record(status, numbers=None, words=None, effort=None, fields=None):
    return {"status": status, "numbers": numbers or {}, "words": words or {}, "effort": effort or {}, "fields": fields or {}}


def json_record(result, fields):
    """Of the JSON object that `solve --json` prints."""
    numbers = {name: value for name, value in result["quantities"].items() if name not in EFFORT}
    for i, patch in enumerate(result["patches"], 1):
        numbers |= {f"patch {i} {'overlap' if key == 'approach' else key}": value for key, value in patch.items() if not isinstance(value, dict)}
    for i, step in enumerate(result["history"], 1):
        numbers |= {f"step {i} {key}": float(value) for key, value in step.items() if not isinstance(value, dict) and key not in EFFORT and value is not None}
    numbers |= {f"extrapolated {key}": value for key, value in (result["extrapolated"] or {}).items()}
    solver = result["solver"]
    words = {"model": result["model"], "reason": result["why_this_model"], "warnings": "\n".join(result["warnings"]),
             "normal solver": solver["normal"], "tangential solver": solver["tangential"],
             "remark": result.get("solver_note", "")}
    effort = {key: result["quantities"][key] for key in result["quantities"] if key in EFFORT} | {"work": solver["work"]}
    return record("certified" if result["certified"] else "not certified", numbers, words, effort, fields)


def is_numbers(item):
    return isinstance(item, h5py.Dataset) and item.dtype.kind in "fu"


def fields_of(group, wanted=lambda name: True):
    """Every dataset of numbers of a group of a result file, also of its groups (history, stresses). The quantities are
    in the JSON object, too."""
    found = {}

    def keep(name, item):
        if is_numbers(item) and wanted(name) and not name.startswith(("quantities/", "seconds/", "solver/", "certificate/")):
            found[name] = item[()]

    group.visititems(keep)
    if "state" in found:
        found["state"] = found["state"].astype(np.uint8)
    return found


def run(command, folder):
    """Exit code, standard output and messages."""
    try:
        done = subprocess.run(command, cwd=folder, env=ENVIRONMENT, capture_output=True, text=True, timeout=TIME_LIMIT)
    except subprocess.TimeoutExpired:
        return None, "", f"no answer within {TIME_LIMIT} s"
    return done.returncode, done.stdout, done.stderr


def compared(found):
    """The results of a comparison, by their path in its file."""
    sets = {"at_equal_forces": "equal_forces", "at_equal_position": "equal_position"}
    return {f"{path}/{model}": found[key][model] for key, path in sets.items() if found[key] for model in found["models"]}


def solve_or_compare(program, folder, scene, arguments):
    """Records, {name: record}, of `solve` (one, "") or `compare` (each model at equal forces and at equal position)."""
    with tempfile.TemporaryDirectory() as scratch:
        output = Path(scratch) / "result.h5"
        code, text, messages = run([program, arguments[0], scene, *arguments[1:], "--json", "-o", output], folder)
        if not text.lstrip().startswith("{"):
            status = {2: "refused", 3: "not converged", None: "no answer"}.get(code, "died")
            return {"": record(status, words={"message": words_of(messages, folder)})}
        found = json.loads(text)
        results = {"": found} if arguments[0] == "solve" else compared(found)
        records = {}
        with h5py.File(output) as file:
            top = {name: item[()] for name, item in file.items() if is_numbers(item)}
            for name, result in results.items():
                records[name] = json_record(result, fields_of(file[name] if name else file) | top)
                records[name]["words"]["message"] = words_of(messages, folder)
                records[name]["numbers"]["exit code"] = code
    return records


def case_record(row, group):
    """Of a case of a sweep: its line of the CSV file and its group of the result file."""
    inputs = {key for key in row if "." in key}
    words = {"reason": row["reason"]}
    numbers, effort = {}, {}
    for key, text in row.items():
        if key not in inputs | {"case", "status", "reason", "creepage_x", "creepage_s"}:
            value = MODELS.index(text) if text in MODELS else float(text) if text else None
            (effort if key in EFFORT else numbers)[key] = value
    fields = {}
    if group is not None and row["status"] in ("certified", "not certified"):
        insides = [group] if "p_n" in group else [item for item in group.values() if isinstance(item, h5py.Group)]
        for inside in insides:  # one; of a wheelset two
            fields |= fields_of(inside, lambda field: field in SWEPT_FIELDS)
    words["model"] = row.get("model", "")
    return record(row["status"], numbers, words, effort, fields)


def sweep(program, folder, scene, arguments):
    """Records by case, {"000012": record}."""
    with tempfile.TemporaryDirectory() as scratch:
        output, table = Path(scratch) / "sweep.h5", Path(scratch) / "sweep.csv"
        code, _, messages = run([program, "sweep", scene, "-o", output, "--csv", table, "--jobs", "1", *arguments[1:]], folder)
        if code not in (0, 3) or not table.exists():
            status = {2: "refused", None: "no answer"}.get(code, "died")
            return {"": record(status, words={"message": words_of(messages, folder)})}
        records = {}
        with h5py.File(output) as file, open(table, newline="") as lines:
            for row in csv.DictReader(lines):
                name = f"{int(row['case']):06d}"
                records[name] = case_record(row, file.get(f"cases/{name}"))
                records[name]["words"]["reason"] = words_of(row["reason"], folder)
    return records


def solve_task(program, folder, task):
    """`task` is "scene: command options", as in "carter: solve --model halfspace"."""
    name, arguments = task.split(": ")
    arguments = arguments.split()
    scene = Path("data") / "scenes" / f"{name}.toml"
    return (sweep if arguments[0] == "sweep" else solve_or_compare)(program, folder, scene, arguments)


def write(group, records):
    """Numbers and words as one JSON text, each field as a dataset."""
    for name, r in records.items():
        into = group.create_group(name or "result")
        into["record"] = json.dumps({key: r[key] for key in ("status", "numbers", "words", "effort")})
        for field, values in r["fields"].items():
            scalar = np.ndim(values) == 0
            into.create_dataset(f"fields/{field}", data=values, **({} if scalar else {"compression": "gzip", "shuffle": True}))


def read(group):
    """Records by name; that of a compared model is a path, "equal_forces/fem"."""
    records = {}

    def keep(name, item):
        if name.endswith("/record"):
            r = json.loads(item[()])
            name = name.removesuffix("/record")
            r["fields"] = fields_of(group[name]["fields"]) if "fields" in group[name] else {}
            records["" if name == "result" else name] = r

    group.visititems(keep)
    return records
