"""All answers to one scene, by the program's command `study`."""

import contextlib
import os
import subprocess
import tempfile
from pathlib import Path

from .executors import results_of
from .program import program_file

_FIRST = ("influence", "wheelset")  # what other parts may use


def call(words):
    """`bem_contact study WORDS`, in the process or thread that an executor has chosen: exit code, what it printed, its last error."""
    from ._core import Error
    program = program_file()
    if program is None:
        raise Error("The program bem_contact was not found (it is neither beside this module nor on PATH) Install it, or put its "
                    "folder on PATH.")
    with tempfile.TemporaryDirectory() as folder:
        told = Path(folder, "messages")  # base/message_file.hpp: a line is a kind, a tab and a text
        done = subprocess.run([program, "study", *words], stdin=subprocess.DEVNULL, capture_output=True, encoding="utf-8", errors="replace",
                              env={**os.environ, "BEM_CONTACT_MESSAGES": str(told)})
        lines = told.read_text(encoding="utf-8", errors="replace").splitlines() if told.exists() else []
    errors = [text for kind, text in (line.split("\t", 1) for line in lines) if kind == "error"]
    return done.returncode, done.stdout, errors[-1] if errors else ""


def raise_what(code, error):
    """What the program has said, as the exception that a function raises."""
    from ._core import ConvergenceError, Error, InputError
    kind = {2: InputError, 3: ConvergenceError}.get(code, Error)
    raise kind(error or f"The program ended with code {code} (it said nothing) Call bem_contact study.")


def identity(file):
    """Changes when the file is written."""
    with contextlib.suppress(OSError):
        found = os.stat(file)
        return found.st_ino, found.st_mtime_ns
    return None


def scene_file(scene, folder, output):
    """The file of a scene, which is written where there is none."""
    from ._core import _text_for_any_folder
    text = _text_for_any_folder(scene, folder)
    is_file = not hasattr(scene, "items") and "\n" not in os.fspath(scene)
    if is_file and folder is None:
        return scene
    output.mkdir(parents=True, exist_ok=True)
    file = output / "scene.toml"
    file.write_text(text, encoding="utf-8")
    return file


def study(scene, output, *, jobs=0, folder=None, executor=None, influence=None):
    """All answers that a scene asks for, in the folder `output`: what `bem_contact study` computes and writes.

    `scene`, `folder`: as solve() takes them; tables such as [wheelset], [creep_curves] and [uncertainty] ask for answers. `jobs`:
    processes of a part; 0: one for each core, with an executor one. What is there and still true is not computed again.
    A dict of what study.h5 holds: "headline" (arrays "value", "element_error", "input_spread", "draws") with "headline_parts",
    "headline_names" and "headline_units" beside it; "taken"; "parts", where "study_status" and "study_errors" of each say how it went,
    and the rest is the answer of its command. Raises InputError where no part can begin.
    `executor`: any of concurrent.futures, or with its methods, does the parts and the draws of the inputs side by side, each as one
    task. Its workers must see the same folder. `influence`: the program that may be started for influence functions (None:
    tools/influence alone); one that the scene names must be given here, too.
    """
    from ._core import _read_record
    output = Path(output)
    words = [str(scene_file(scene, folder, output)), "-o", str(output)]
    if influence is not None:
        words += ["--influence", str(influence)]
    if executor is not None:
        _share(executor, [*words, "--jobs", str(jobs or 1)])
    if jobs or executor is not None:
        words += ["--jobs", str(jobs or 1)]
    file = output / "study.h5"
    before = identity(file)
    code, _, error = call(words)
    if identity(file) == before:
        raise_what(code, error)
    return _read_record(file)


def _share(executor, words):
    """Has the parts and draws computed. What is refused is not said here: the study says it when it is put together."""
    code, listed, error = call([*words, "--list"])
    if code:
        raise_what(code, error)
    tasks = listed.split()
    for name in [one for one in _FIRST if one in tasks]:
        results_of(executor, call, [([*words, "--only", name],)])
    results_of(executor, call, [([*words, "--only", name],) for name in tasks if name not in _FIRST])
