"""`python3 -m bem_contact` runs the program: the one installed with this package, else the one on the path."""

import os
import sys

from .program import program_file


def main():
    words = sys.argv[1:]
    if words[:1] == ["plot"] and not {"-h", "--help"} & set(words):  # in this Python, which has its libraries
        from .plotting.command import main as plot
        return plot(words[1:])
    program = program_file()
    if program is None:
        print("error: the program bem_contact was not found (it is neither beside this module nor on PATH) "
              "Install it, or put its folder on PATH.", file=sys.stderr)
        return 1
    sys.stdout.flush()
    os.execv(program, [program, *words])


if __name__ == "__main__":
    sys.exit(main())
