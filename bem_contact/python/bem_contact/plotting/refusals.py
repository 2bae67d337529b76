"""Wrong input ends in words: an InputError in Python, one line and exit code 2 in a program."""

import importlib
import re
import sys

try:
    from .._core import InputError
except ImportError:  # pictures do not need the compiled part

    class InputError(ValueError):
        """As bem_contact.InputError."""

DRAWING = ("numpy", "h5py", "matplotlib")


def refuse(problem, why, what_to_do):
    """Raises InputError with the words that all messages here have."""
    message = re.sub(r"(\S{90})\S{60,}(\S{50})", r"\1 ... \2", f"{problem} ({why}) {what_to_do}")  # names and values
    raise InputError(message.encode(errors="replace").decode())


def require_module(name, problem, advice=None):
    """The module of that name; without it a refusal says what to do: install the package of Debian that has it."""
    try:
        return importlib.import_module(name)
    except ModuleNotFoundError:
        refuse(problem, f"{sys.executable} has no module {name}",
               advice or f"Install the Debian package python3-{name}: sudo apt-get install python3-{name}")


def require_modules():
    """Refuses to draw without a library."""
    for name in DRAWING:
        require_module(name, "No picture can be drawn")


def run(main):
    """Runs a program: an InputError becomes one line on the error output, and exit code 2."""
    try:
        main()
    except InputError as error:
        print(f"error: {error}", file=sys.stderr)
        raise SystemExit(2) from None
