"""What tools/cluster/Snakefile computes, from its config.toml. This module knows nothing of Snakemake but which names it
takes."""

import glob
import json
import os
import re
import shutil
import subprocess
import time
import tomllib
from dataclasses import dataclass, field
from pathlib import Path


class ConfigError(Exception):
    """A config.toml that says no plan: <problem> (<why>) <what to do>."""


def is_safe(name):
    """Whether Snakemake can hand a name on. It takes braces as wildcards, and writes names into scripts of the shell as Python
    writes texts: in single quotes, but in double ones if they hold a single quote."""
    return (bool(name) and not name.startswith("-") and not re.search(r"[{}\\\n]", name) and
            not ("'" in name and re.search(r'["$`]', name)))


def require_safe(name):
    if not is_safe(name):
        raise ConfigError(f"The name {name!r} cannot be handed to Snakemake (it is empty, begins with -, or has a brace, a backslash, or a "
                          "single quote beside a double quote, $ or `) Rename the file.")
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
    return {"attempt_number": growing(1), "tasks": processes, "nodes": entry.get("nodes", 1), "cpus_per_task": threads, "runtime": entry["minutes"],
            "mem_mb": growing(entry["memory"] * processes), "mem_mb_per_cpu": growing(-(-entry["memory"] // threads))}


def is_main(workflow):
    """Whether this is the Snakemake that somebody has called, and not one of its jobs on another computer."""
    main = getattr(workflow, "is_main_process", None)  # from version 8 on
    return workflow.mode == 0 if main is None else bool(main)


@dataclass
class Body:
    """Mesh and influence file of one body."""
    name: str       # of the rule: letters, digits and _
    file: str
    influence: str
    threads: int
    resources: dict
    program: str    # tools/influence

    @property
    def log(self):
        return f"{LOGS}/{self.name}.txt"


def remove_if_empty(folder):
    try:
        os.rmdir(folder)
    except OSError:  # it is not, or is not there
        pass


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

    @property
    def log(self):
        return f"{LOGS}/{self.name}.txt"


CHUNK = 32          # cases: where parts end between chunks, the digits are those of one process
SHARE_OF_A_ROUND = 0.6  # of the cases that are left, which each round hands out (tools/benchmarks/fleet_efficiency)


def rounds_of(cases, of_a_task, slots):
    """The parts of a sweep as lists of [first case, last case). Without slots: one list of equal ones. With slots: rounds of one
    part for each slot, and each round is smaller than the one before, so that the last ones to be waited for are short."""
    rounds, at = [], 0
    while at < cases:
        graded = int(SHARE_OF_A_ROUND * (cases - at) / slots) // CHUNK * CHUNK if slots else 0
        last_round = graded <= of_a_task
        size = of_a_task if last_round else graded
        end = cases if last_round else at + slots * size
        rounds.append([(first, min(first + size, cases)) for first in range(at, end, size)])
        at = end
    return rounds


@dataclass
class Sweep(Task):
    csv: str = ""
    cases: int = 0   # of all
    of_a_task: int = 1
    slots: int = 0   # 0: all parts are alike
    minutes: int = 60  # that a part may take
    join_resources: dict = field(default_factory=dict)

    @property
    def folder_of_cuts(self):
        return f"{self.output}.parts"

    @property
    def parts(self):
        """Parts of another cut are never joined: they are in another folder."""
        return f"{self.folder_of_cuts}/{self.cases}_by_{self.of_a_task}" + (f"_on_{self.slots}" if self.slots else "")

    def rounds(self):
        return rounds_of(self.cases, self.of_a_task, self.slots)

    def prefix(self, number):
        """Of the names of a round's parts. The first round has none."""
        return f"{number}_" if number else ""

    def pattern(self, number):
        """The part of a round, for Snakemake's wildcards."""
        return f"{self.parts}/{self.prefix(number)}" + "{first}-{last}.h5"

    def log_of_part(self, number):
        return f"{LOGS}/{self.name}/{self.prefix(number)}" + "{first}-{last}.txt"

    @property
    def outputs(self):
        return [self.output] + ([self.csv] if self.csv else [])

    @property
    def named_outputs(self):
        return ["-o", self.output] + (["--csv", self.csv] if self.csv else [])

    def remove_leftovers(self, now):
        """What a Snakemake that was killed has left: parts of another cut, parts that are joined, and files that nobody writes
        any more, because no task may take so long."""
        joined = self.joined_at()
        for folder in glob.glob(glob.escape(self.folder_of_cuts) + "/*_by_*"):
            if not re.fullmatch(r"\d+_by_\d+(_on_\d+)?", os.path.basename(folder)):
                continue
            for entry in os.scandir(folder):
                whole = re.fullmatch(r"(\d+_)?\d+-\d+\.h5", entry.name)
                begun = re.fullmatch(r"(\d+_)?\d+-\d+\.h5\.tmp\d+", entry.name)
                changed = entry.stat(follow_symlinks=False).st_mtime
                if whole and (os.path.normpath(folder) != os.path.normpath(self.parts) or changed < joined) or \
                        begun and changed < now - 60 * self.minutes:
                    os.remove(entry.path)
            remove_if_empty(folder)
        remove_if_empty(self.folder_of_cuts)

    def joined_at(self):
        """When all results were there; 0: one is not, or is older than what it is made of and will be made again."""
        if not all(map(os.path.exists, self.outputs)):
            return 0
        joined = min(map(os.path.getmtime, self.outputs))
        newest = max((os.path.getmtime(one) for one in self.inputs if os.path.exists(one)), default=0)
        return joined if newest <= joined else 0

    def part_files(self):
        return [f"{self.parts}/{self.prefix(number)}{first}-{last}.h5" for number, parts in enumerate(self.rounds()) for first, last in parts]


LOGS = ".snakemake/tasks"           # what a task says, while it runs and if it fails
MEMORY = ".snakemake/asked.json"    # what the programs said of each scene: jobs on other computers need not ask again

# The keys of each table: which must be there, and the others with their defaults.
KEYS = {
    "body": ({"files", "folder"}, {"processes": 1, "memory": 1000, "minutes": 60, "nodes": 1}),
    "sweep": ({"scene", "output"}, {"csv": "", "cases": 3200, "slots": 0, "memory": 1000, "minutes": 60, "options": [], "needs": []}),
    "wear": ({"scene", "folder"}, {"threads": 1, "memory": 1000, "minutes": 600, "options": [], "needs": []}),
    "study": ({"scene", "folder"}, {"threads": 1, "memory": 2000, "minutes": 600, "options": [], "needs": []}),
    "table": ({"scene", "output"}, {"threads": 1, "memory": 2000, "minutes": 120, "options": [], "needs": []}),
}


class Plan:
    one_thread = "OMP_NUM_THREADS=1 OPENBLAS_NUM_THREADS=1 "  # tasks are what runs side by side

    def __init__(self, text, source, cluster_folder, main):
        self.source = source
        given = self.parse(text)
        self.tries = self.number_of_tries(given.pop("tries", 2))
        self.programs = self.folder_of_programs(given.pop("programs", ""), Path(cluster_folder))
        self.bem_contact = str(Path(self.programs) / "bem_contact")
        self.run_task, self.join_parts = (str(Path(cluster_folder).resolve() / name) for name in ("run_task", "join_parts"))
        self.names = set()
        entries = self.entries(given)
        tool = str(Path(cluster_folder).resolve().parent / "influence")
        self.bodies = [body for entry in entries["body"] for body in self.bodies_of(entry, tool)]
        self.sweeps = [self.sweep_of(entry) for entry in entries["sweep"]]
        self.wear, self.studies = ([Task(**self.common(entry, entry["folder"]), folder=entry["folder"]) for entry in entries[kind]]
                                   for kind in ("wear", "study"))
        self.tables = [Task(**self.common(entry, entry["output"]), output=entry["output"]) for entry in entries["table"]]
        self.require_distinct()
        self.ask(main)

    def task(self, accepted):
        """How the command of a task begins. `accepted`: an exit code of its program that is no failure."""
        return self.one_thread + "{plan.run_task:q} {log:q} {resources.attempt_number} " + f"{accepted} "

    def remove_leftovers(self):
        for sweep in self.sweeps:
            sweep.remove_leftovers(time.time())

    def number_of_tries(self, given):
        if not isinstance(given, int) or isinstance(given, bool) or given < 0:
            self.refuse(f"tries cannot be {given!r}", "it is a whole number from 0", "Correct it.")
        return given

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
        if not isinstance(given, str):
            self.refuse(f"programs cannot be {given!r}", "it is a text, the folder of the programs", "Correct it.")
        return self.found_folder(given, cluster_folder)

    def found_folder(self, given, cluster_folder):
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
            if not isinstance(value, wanted) or isinstance(value, bool) or wanted is int and value < (key != "slots"):
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
        return {"name": self.rule_name(result), "scene": entry["scene"], "options": entry["options"], "inputs": inputs,
                "threads": entry.get("threads", 1), "resources": resources(entry)}

    def sweep_of(self, entry):
        if entry["csv"]:
            require_safe(entry["csv"])
        sweep = Sweep(**self.common(entry, entry["output"]), output=entry["output"], csv=entry["csv"],
                      of_a_task=entry["cases"], slots=entry["slots"], minutes=entry["minutes"])
        sweep.join_resources = resources({"memory": 500, "minutes": entry["minutes"]})
        return sweep

    def ask(self, main):
        """Adds to each task the files that its scene names, and to sweeps how many cases they have. A job of a cluster takes what
        the Snakemake that submitted it was told."""
        known = {} if main or not os.path.exists(MEMORY) else json.loads(Path(MEMORY).read_text(encoding="utf-8"))
        made = {os.path.abspath(one): one for one in self.influence_files()}
        for task in self.sweeps + self.wear + self.studies + self.tables:
            if task.scene not in known:
                known[task.scene] = {"inputs": self.said(task.scene, "check", task.scene, "--inputs").splitlines()}
            task.inputs = list(dict.fromkeys(task.inputs + list(self.named_by(task.scene, known[task.scene]["inputs"], made))))
        for sweep in self.sweeps:
            if "cases" not in known[sweep.scene]:
                known[sweep.scene]["cases"] = self.cases_of(sweep.scene)
            sweep.cases = known[sweep.scene]["cases"]
        if main:
            Path(MEMORY).parent.mkdir(exist_ok=True)
            Path(MEMORY + ".new").write_text(json.dumps(known), encoding="utf-8")
            os.replace(MEMORY + ".new", MEMORY)

    def said(self, scene, *arguments):
        done = subprocess.run([self.bem_contact, *arguments], capture_output=True, text=True)
        if done.returncode != 0:
            raise ConfigError(f"{self.source}: the scene '{scene}' cannot be solved:\n{done.stderr.strip()}")
        return done.stdout

    def cases_of(self, scene):
        said = self.said(scene, "sweep", scene, "--count")
        if not said.strip().isdigit():
            self.refuse(f"the sweep '{scene}' has no number of cases", f"bem_contact sweep --count said {said[:60]!r}",
                        "Call it alone to see why.")
        return int(said)

    def named_by(self, scene, files, made):
        """Those as Snakemake knows them: one of a body has the name that its rule gives it."""
        for file in files:
            if os.path.abspath(file) in made:
                yield made[os.path.abspath(file)]
            elif not os.path.exists(file):
                self.refuse(f"the scene '{scene}' names '{file}'", "there is no such file, and no [[body]] makes it",
                            "Correct the scene, or add the body.")
            elif is_safe(file):
                yield os.path.normpath(file)

    def require_distinct(self):
        seen = {os.path.abspath(self.source)} | {os.path.abspath(one) for one in self.given_files()}
        tasks = self.sweeps + self.wear + self.studies + self.tables
        read = {os.path.realpath(name) for name in [task.scene for task in tasks] + [body.file for body in self.bodies]}
        for result in self.results():
            place = os.path.abspath(result)
            if os.path.realpath(result) in read:
                self.refuse(f"'{result}' would be replaced", "a task reads it", "Give the output another name.")
            if place in seen:
                self.refuse(f"two tasks write '{result}', or one does that is given it", "what is there would be replaced",
                            "Give each result a name of its own.")
            seen.add(place)

    def given_files(self):
        return ([body.file for body in self.bodies] +
                [one for task in self.sweeps + self.wear + self.studies + self.tables for one in task.inputs])

    def influence_files(self):
        return [body.influence for body in self.bodies]

    def results(self):
        return (self.influence_files() + [one for sweep in self.sweeps for one in sweep.outputs] +
                [one.folder + "/finished" for one in self.wear + self.studies] + [table.output for table in self.tables])


def read(file, cluster_folder, main=True):
    """The plan of a config.toml. `main`: is_main(). Throws ConfigError for a file that says none."""
    require_folder(os.getcwd())
    try:
        text = Path(file).read_text(encoding="utf-8")
    except (OSError, UnicodeDecodeError) as error:
        raise ConfigError(f"'{file}' cannot be read ({error}) Copy tools/cluster/config.toml to the folder where you call "
                          "Snakemake, and change it.") from None
    return Plan(text, file, cluster_folder, main)
