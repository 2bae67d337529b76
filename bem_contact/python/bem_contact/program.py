"""Where the program is."""

import os
import shutil
from pathlib import Path


def program_file():
    """The program in the folder CONFORMAL_BIN, else of this package, of its build or of its installed tree, else on the path."""
    package = Path(__file__).resolve().parent
    folders = [os.environ.get("CONFORMAL_BIN"), package / "bin", *(folder / "bin" for folder in package.parents[1:4:2])]
    files = [Path(folder) / "bem_contact" for folder in folders if folder]
    return next((str(file) for file in files if file.is_file()), None) or shutil.which("bem_contact")
