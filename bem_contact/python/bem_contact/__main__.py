"""`python3 -m bem_contact` runs the program: the one installed with this package, else the one on the path."""

import os
import shutil
import sys
from pathlib import Path


def main():
    own = Path(__file__).resolve().parent / "bin" / "bem_contact"
    program = str(own) if own.exists() else shutil.which("bem_contact")
    if program is None:
        print("error: the program bem_contact was not found (it is neither beside this module nor on PATH) "
              "Install it, or put its folder on PATH.", file=sys.stderr)
        return 1
    sys.stdout.flush()
    os.execv(program, [program, *sys.argv[1:]])


if __name__ == "__main__":
    sys.exit(main())
