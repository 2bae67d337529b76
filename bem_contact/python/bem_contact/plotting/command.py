"""The command line of `bem_contact plot`. Its help is the program's: bem_contact plot --help."""

import argparse
import sys
from pathlib import Path

from .refusals import refuse, require_modules, run


def main(words=None):
    run(lambda: draw_what_is_asked(sys.argv[1:] if words is None else words))


def draw_what_is_asked(words):
    parser = argparse.ArgumentParser(prog="bem_contact plot", add_help=False, allow_abbrev=False)
    parser.add_argument("-o", "--output")
    asked, rest = parser.parse_known_args(words)
    if asked.output == "":
        refuse("The output of --output cannot be written", "it names no file", "Give it a name, or leave the option out.")
    files, options = split_options(rest)
    if not files:
        refuse("There is nothing to draw", "no file is named", "Name one: bem_contact plot FILE, or see bem_contact plot --help.")
    picture = Path(asked.output) if asked.output else Path(Path(files[0]).resolve().with_suffix(".png").name)
    require_modules()
    from .drawing import draw  # it needs them
    draw(files, picture, options)
    print(f"{picture} written", file=sys.stderr)


def split_options(words):
    """Files first, then the options of bem_contact profile, which may have values."""
    at = next((k for k, word in enumerate(words) if word.startswith("-")), len(words))
    return words[:at], words[at:]
