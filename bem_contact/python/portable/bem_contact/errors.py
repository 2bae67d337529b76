"""What goes wrong, with the names and the meaning of the package that is built from the sources."""

__all__ = ["ConvergenceError", "Error", "InputError", "fail"]

WRONG_INPUT, NOT_CONVERGED = 2, 3  # of conformal_contact.h; the program's exit codes are the same


class Error(Exception):
    """What is wrong, why, and what to do; of this class itself where the machine is to blame."""


class InputError(Error, ValueError):
    """The scene or a file is wrong."""


class ConvergenceError(Error, RuntimeError):
    """No certified result was found, and there is nothing to return."""


def fail(code, message):
    raise {WRONG_INPUT: InputError, NOT_CONVERGED: ConvergenceError}.get(code, Error)(message)
