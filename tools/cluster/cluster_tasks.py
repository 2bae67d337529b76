"""What tools/cluster/Snakefile computes, from its config.toml. This module knows nothing of Snakemake but which names it
takes."""

import glob
import os
import re
import shutil
import subprocess
import tomllib
from dataclasses import dataclass, field
from pathlib import Path


class ConfigError(Exception):
    """A config.toml that says no plan: <problem> (<why>) <what to do>."""


def is_safe(name):
    """Whether Snakemake can hand a name on. It takes braces as wildcards, and writes names into scripts of the shell as Python
    writes texts: in single quotes, but in double ones if they hold a single quote."""
    return bool(name) and not name.startswith("-") and not re.search(r"[{}\\\n]", name) and not ("'" in name and re.search(r'["$`]', name))


def require_safe(name):
    if not is_safe(name):
        raise ConfigError(f"The name {name!r} cannot be handed to Snakemake (it is empty, begins with -, or has a brace, a backslash, "
                          "or a single quote beside a double quote, $ or `) Rename the file.")
    return name


def require_folder(folder):
    """The folder where Snakemake works: it writes scripts there, and submits them by names in double quotes."""
    if not is_safe(folder) or re.search(r'["$`]', folder):
        raise ConfigError(f"Snakemake cannot work in the folder {folder!r} (its name has a brace, a double quote, a backslash, "
                          "$ or `) Rename the folder.")


def growing(amount):
    """A resource that a task gets more of at each new try."""
    return lambda wildcards, attempt: amount * attempt


def resources(entry, processes=1):
    """Memory, time and processes of a task, under the names of Snakemake's executors and of tools/cluster/profiles."""
    threads = entry.get("threads", 1)
    return {"tasks": processes, "nodes": entry.get("nodes", 1), "cpus_per_task": threads, "runtime": entry["minutes"],
            "mem_mb": growing(entry["memory"] * processes), "mem_mb_per_cpu": growing(-(-entry["memory"] // threads))}


@dataclass
class Body:
    """Mesh and influence file of one body."""
    name: str       # of the rule: letters, digits and _
    file: str
    influence: str
    threads: int
    resources: dict
    program: str    # tools/influence


@dataclass
class Task:
    """A scene that one command answers."""
    name: str
    scene: str
    options: list
    inputs: list
    threads: int
    resources: dict
    output: str = ""
    folder: str = ""


@dataclass
class Sweep(Task):
    csv: str = ""
    cases: int = 0   # of all
    of_a_task: int = 1
    join_resources: dict = field(default_factory=dict)

    @property
    def parts(self):
        """Parts of another cut are never joined: they are in another folder."""
        return f"{self.output}.parts/{self.cases}_by_{self.of_a_task}"

    @property
    def outputs(self):
        return [self.output] + ([self.csv] if self.csv else [])

    @property
    def named_outputs(self):
        return ["-o", self.output] + (["--csv", self.csv] if self.csv else [])

    def part_files(self):
        return [f"{self.parts}/{first}-{min(first + self.of_a_task, self.cases)}.h5"
                for first in range(0, self.cases, self.of_a_task)]


# The keys of each table: which must be there, and the others with their defaults.
KEYS = {
    "body": ({"files", "folder"}, {"processes": 1, "memory": 1000, "minutes": 60, "nodes": 1}),
    "sweep": ({"scene", "output"}, {"csv": "", "cases": 3200, "memory": 1000, "minutes": 60, "options": [], "needs": []}),
    "wear": ({"scene", "folder"}, {"threads": 1, "memory": 1000, "minutes": 600, "options": [], "needs": []}),
    "study": ({"scene", "folder"}, {"threads": 1, "memory": 2000, "minutes": 600, "options": [], "needs": []}),
    "table": ({"scene", "output"}, {"threads": 1, "memory": 2000, "minutes": 120, "options": [], "needs": []}),
}


class Plan:
    one_thread = "OMP_NUM_THREADS=1 OPENBLAS_NUM_THREADS=1 "  # tasks are what runs side by side

    def __init__(self, text, source, cluster_folder):
        self.source = source
        given = self.parse(text)
        self.tries = self.number_of_tries(given.pop("tries", 2))
        self.programs = self.folder_of_programs(given.pop("programs", ""), Path(cluster_folder))
        self.bem_contact = str(Path(self.programs) / "bem_contact")
        self.bodies_are_there = ".snakemake/bodies_are_there"
        self.names = set()
        entries = self.entries(given)
        tool = str(Path(cluster_folder).resolve().parent / "influence")
        self.bodies = [body for entry in entries["body"] for body in self.bodies_of(entry, tool)]
        self.sweeps = [self.sweep_of(entry) for entry in entries["sweep"]]
        self.wear, self.studies = ([Task(**self.common(entry, entry["folder"]), folder=entry["folder"]) for entry in entries[kind]]
                                   for kind in ("wear", "study"))
        self.tables = [Task(**self.common(entry, entry["output"]), output=entry["output"]) for entry in entries["table"]]
        self.require_distinct()

    def refuse(self, problem, why, what_to_do):
        raise ConfigError(f"{self.source}: {problem} ({why}) {what_to_do}")

    def parse(self, text):
        try:
            return tomllib.loads(text)
        except tomllib.TOMLDecodeError as error:
            self.refuse(str(error), "the file is not valid TOML", "Correct the line.")

    def number_of_tries(self, given):
        if not isinstance(given, int) or isinstance(given, bool) or not 0 <= given <= 100:
            self.refuse(f"tries cannot be {given!r}", "it is a whole number from 0 to 100", "Correct it.")
        return given

    def folder_of_programs(self, given, cluster_folder):
        """As the file says; or CONFORMAL_BIN, this project's own build, the programs of this installed tree, the PATH."""
        tools = cluster_folder.resolve().parent
        found = shutil.which("bem_contact")
        folders = [given] if given else [os.environ.get("CONFORMAL_BIN", ""), tools.parent / "build" / "bin",
                                         tools.parents[2] / "bin" if len(tools.parts) > 3 else "",
                                         os.path.dirname(found) if found else ""]
        for folder in map(str, folders):
            if folder and os.access(os.path.join(folder, "bem_contact"), os.X_OK):
                return os.path.abspath(folder)
        self.refuse("there is no program bem_contact", f"looked for in {', '.join(repr(str(one)) for one in folders if str(one))}",
                    'Build it, or name its folder: programs = "/path/bin".')

    def entries(self, given):
        for name in given:
            if name not in KEYS:
                self.refuse(f"unknown key '{name}'", "there are programs, tries and " + ", ".join(f"[[{k}]]" for k in KEYS),
                            "Correct it.")
            if not isinstance(given[name], list) or not all(isinstance(one, dict) for one in given[name]):
                self.refuse(f"{name} is no list of tables", "each task has one", f"Begin each with [[{name}]].")
        return {name: [self.entry(name, one) for one in given.get(name, [])] for name in KEYS}

    def entry(self, table, given):
        needed, defaults = KEYS[table]
        for key, value in given.items():
            if key not in needed and key not in defaults:
                self.refuse(f"unknown key '{key}' in [[{table}]]", "there are " + ", ".join(sorted(needed | set(defaults))),
                            "Correct it.")
            wanted = list if key in ("files", "options", "needs") else type(defaults.get(key, ""))
            if not isinstance(value, wanted) or isinstance(value, bool) or wanted is int and value < 1:
                self.refuse(f"{table}.{key} cannot be {value!r}",
                            {int: "it is a whole number from 1", str: "it is a text", list: "it is a list of texts"}[wanted],
                            "Correct it.")
            if wanted is list and not all(isinstance(one, str) and not re.search("[{}]", one) for one in value):
                self.refuse(f"{table}.{key} holds something else than texts without braces",
                            "they are handed on as they are", "Correct it.")
        for key in needed - set(given):
            self.refuse(f"a table [[{table}]] has no {key}", "it cannot do without", "Add it.")
        return defaults | given

    def rule_name(self, file):
        """Of a file, with nothing that a shell or a cluster would take for something else; each once."""
        plain = re.sub(r"[^A-Za-z0-9]+", "_", Path(file).stem) or "task"
        name, k = plain, 1
        while name in self.names:
            k += 1
            name = f"{plain}_{k}"
        self.names.add(name)
        return name

    def bodies_of(self, entry, tool):
        for pattern in entry["files"]:
            files = [pattern] if os.path.exists(pattern) else sorted(glob.glob(pattern))
            if not files:
                self.refuse(f"there is no body file '{pattern}'", "[[body]] names it", "Correct files.")
            for file in files:
                influence = os.path.join(entry["folder"], Path(file).stem + ".h5")
                yield Body(self.rule_name(influence), require_safe(file), require_safe(influence), entry["processes"],
                           resources(entry, entry["processes"]), tool)

    def common(self, entry, result):
        require_safe(result)
        inputs = [require_safe(entry["scene"])] + [require_safe(one) for one in entry["needs"]]
        return {"name": self.rule_name(result), "scene": entry["scene"], "options": entry["options"],
                "inputs": inputs + ([self.bodies_are_there] if self.bodies else []),
                "threads": entry.get("threads", 1), "resources": resources(entry)}

    def sweep_of(self, entry):
        if entry["csv"]:
            require_safe(entry["csv"])
        sweep = Sweep(**self.common(entry, entry["output"]), output=entry["output"], csv=entry["csv"],
                      cases=self.count(entry["scene"]), of_a_task=entry["cases"])
        sweep.join_resources = resources({"memory": 500, "minutes": entry["minutes"]})
        return sweep

    def count(self, scene):
        done = subprocess.run([self.bem_contact, "sweep", scene, "--count"], capture_output=True, text=True)
        if done.returncode != 0:
            raise ConfigError(f"{self.source}: the sweep '{scene}' cannot be done:\n{done.stderr.strip()}")
        if not done.stdout.strip().isdigit():
            self.refuse(f"the sweep '{scene}' has no number of cases", f"bem_contact sweep --count said {done.stdout[:60]!r}",
                        "Call it alone to see why.")
        return int(done.stdout)

    def require_distinct(self):
        seen = set()
        tasks = self.sweeps + self.wear + self.studies + self.tables
        read = {os.path.realpath(name) for name in [task.scene for task in tasks] + [body.file for body in self.bodies]}
        for result in self.results():
            place = os.path.abspath(result)
            if os.path.realpath(result) in read:
                self.refuse(f"'{result}' would be replaced", "a task reads it", "Give the output another name.")
            if place in seen:
                self.refuse(f"two tasks write '{result}'", "one would replace the other's", "Give each its own name.")
            seen.add(place)

    def influence_files(self):
        return [body.influence for body in self.bodies]

    def results(self):
        return (self.influence_files() + [one for sweep in self.sweeps for one in sweep.outputs] +
                [one.folder + "/finished" for one in self.wear + self.studies] + [table.output for table in self.tables])


def read(file, cluster_folder):
    """The plan of a config.toml. Throws ConfigError for a file that says none."""
    require_folder(os.getcwd())
    try:
        text = Path(file).read_text(encoding="utf-8")
    except (OSError, UnicodeDecodeError) as error:
        raise ConfigError(f"'{file}' cannot be read ({error}) Copy tools/cluster/config.toml to the folder where you call "
                          "Snakemake, and change it.") from None
    return Plan(text, file, cluster_folder)
