"""The ways in: the program, the C interface and Python. Each answers (code, message): 0 solved, 2 refused, ...

All read scenes and files by the same functions. C is the quickest: it needs no new process, each start of which takes as long
as a hundred refusals."""

import ctypes
import os
import subprocess
from pathlib import Path

PROGRAM, SOURCE = os.environ["BEM_CONTACT"], Path(os.environ["CONFORMAL_SOURCE"])
SCENES = SOURCE / "data" / "scenes"


def run(*command, **options):
    """A program of ours: its code and what it wrote to standard error. It may neither crash nor hang."""
    options = {"stdout": subprocess.PIPE, "stderr": subprocess.PIPE, "stdin": subprocess.DEVNULL, "timeout": 120} | options
    done = subprocess.run([str(part) for part in command], **options)
    return done.returncode, done.stderr.decode(errors="replace")


def program(*arguments, **options):
    return run(PROGRAM, *arguments, **options)


class CLibrary:
    """The C interface through ctypes."""

    def __init__(self, path):
        self.library = ctypes.CDLL(path)
        self.library.conformal_message.restype = ctypes.c_char_p
        self.library.conformal_message.argtypes = [ctypes.c_void_p]
        self.library.conformal_close.argtypes = [ctypes.c_void_p]
        self.library.conformal_solve.argtypes = [ctypes.c_void_p]
        self.library.conformal_set_number.argtypes = [ctypes.c_void_p, ctypes.c_int, ctypes.c_double]
        self.library.conformal_set_text.argtypes = [ctypes.c_void_p, ctypes.c_int, ctypes.c_char_p]
        self.library.conformal_key.argtypes = [ctypes.c_void_p, ctypes.c_char_p, ctypes.POINTER(ctypes.c_int)]

    def _opened(self, opened):
        handle, message = ctypes.c_void_p(), ctypes.create_string_buffer(1000)
        code = opened(ctypes.byref(handle), message, len(message))
        return code, message.value.decode(errors="replace"), handle

    def _answer(self, opened, action):
        code, message, handle = self._opened(opened)
        if code == 0:
            code = action(handle) or self.library.conformal_solve(handle)
            message = self.library.conformal_message(handle).decode(errors="replace")
        self.library.conformal_close(handle)
        return code, message

    def text(self, toml, folder=SCENES):
        return self._answer(lambda *out: self.library.conformal_open_text(toml.encode(), str(folder).encode(), *out),
                            lambda handle: 0)

    def file(self, scene):
        return self._answer(lambda *out: self.library.conformal_open_file(str(scene).encode(), *out), lambda handle: 0)

    def change(self, scene, key, value):
        def set_value(handle):
            index = ctypes.c_int(-1)
            code = self.library.conformal_key(handle, key.encode(), ctypes.byref(index))
            if code:
                return code
            if isinstance(value, str):
                return self.library.conformal_set_text(handle, index, value.encode())
            return self.library.conformal_set_number(handle, index, value)

        return self._answer(lambda *out: self.library.conformal_open_file(str(scene).encode(), *out), set_value)


HAS_PYTHON = "WITH_PYTHON_MODULE" in os.environ  # not under sanitizers


def python(scene, changes):
    import bem_contact
    try:
        result = bem_contact.solve(scene, changes)
    except bem_contact.InputError as error:
        return 2, str(error)
    except bem_contact.ConvergenceError as error:
        return 3, str(error)
    return (0 if result.certified else 3), ""
