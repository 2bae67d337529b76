"""Why a case differs from CONTACT's output: as somebody found out by runs of both programs (contact_reasons.toml)."""

import csv
import tomllib
from pathlib import Path

UNKNOWN = ("not looked at", "")


def read() -> dict:
    """The file: "why", sentences by name, and "shown", what showed which of them in which cases."""
    return tomllib.loads(Path(__file__).with_name("contact_reasons.toml").read_text())


class Reasons:
    """The reasons of single cases, each with the run that showed it."""

    def __init__(self):
        found = read()
        self._of = {(entry["file"], case): (found["why"][entry["why"]], entry["shown"])
                    for entry in found["shown"] for case in cases_of(entry["cases"])}

    def __len__(self) -> int:
        return len(self._of)

    def of(self, file: Path, case: int) -> tuple:
        """In words: why it differs, and what showed it."""
        return self._of.get((file.as_posix(), case), UNKNOWN)


def cases_of(text: str) -> list:
    """The numbers of "1-3, 7"."""
    out = []
    for part in text.split(","):
        first, _, last = part.strip().partition("-")
        out += range(int(first), int(last or first) + 1)
    return out


def friction_of(scene: Path) -> float:
    """The largest coefficient of a scene."""
    motion = tomllib.loads(scene.read_text()).get("motion", {})
    if table := motion.get("friction_table"):
        with open(scene.parent / table) as lines:
            return max(float(row["mu"]) for row in csv.DictReader(lines))
    return motion.get("friction", 0.3)
