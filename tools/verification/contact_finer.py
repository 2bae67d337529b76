#!/usr/bin/python3
"""Input files of CONTACT on elements half as large, and what CONTACT prints for them.

    tools/verification/contact_finer.py CONTACT_FOLDER FINER
    (run CONTACT in FINER: contact 2 NAME, for each NAME.inp)
    tools/verification/contact_finer.py CONTACT_FOLDER FINER --of RUN.json

The first call writes the input files. A rolling step over one element becomes two of half the length. The second call reads
CONTACT's outputs (.out) of cases that differ in RUN.json, which contact_suite --json wrote, and writes their totals to
contact_finer.csv, beside this file; contact_suite reads it from there. What has no output there stays as it was.
"""

import argparse
import csv
import json
import re
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
import contact_output  # noqa: E402

TABLE = Path(__file__).with_name("contact_finer.csv")
COLUMNS = ["file", "case", "Fn", "Fx", "Fy", "pmax"]


def totals() -> dict:
    """What CONTACT prints on elements half as large: {(file, case): {"Fn": ...}}."""
    with open(TABLE) as lines:
        rows = csv.DictReader(line for line in lines if line[0] != "#")
        return {(row["file"], int(row["case"])): {key: float(row[key]) for key in COLUMNS[2:]} for row in rows}


def finer_line(line: str) -> str:
    """A line of the input file, with its elements halved along both axes."""
    words = re.split(r"\s+", line.split("%")[0].strip())
    values = [w for w in words if re.fullmatch(r"[-+]?[\d.]+(?:[eEdD][-+]?\d+)?d?0?", w)]
    names = "".join(words[len(values):])
    numbers = [float(re.sub("[dD]", "e", v)) if "d" not in v[-2:] else v for v in values]
    if names.startswith("MX,MY"):
        mx, my = int(numbers[0]), int(numbers[1])
        rows = 2 if my > 1 else 1
        rest = numbers[2:]
        if "DX" in names:
            x, y, dx, dy = rest
            first = "XC1" in names  # the centre of the first element, which moves
            rest = [x - first * dx / 4, y - first * (rows - 1) * dy / 4, dx / 2, dy / rows]
        return " ".join(map(str, [2 * mx, rows * my, *rest])) + "  " + names
    if names.startswith("DX,DS,DQREL"):
        return " ".join(map(str, [numbers[0] / 2, numbers[1] / 2, *values[2:]])) + "  " + names
    if names.startswith("CHI,DQ,VELOC"):
        return " ".join(map(str, [values[0], numbers[1] / 2, *values[2:]])) + "  " + names
    return line


def is_rolling_step(block: list) -> bool:
    """Whether a case goes on (P = 0) by a step of transient rolling (T = 2)."""
    module, digits = (re.sub(r"\D", " ", line).split()[0] for line in block[:2])
    digits = digits.zfill(7)
    return module in "13" and digits[1] == "0" and digits[3] == "2"


def blocks_of(text: str) -> list:
    """The cases of a file, each a list of lines that are no remarks; what stands before the first belongs to it."""
    lines = [line for line in text.splitlines() if line.strip() and line.strip()[0] != "%"]
    starts = [k for k, line in enumerate(lines) if re.match(r"\s*[013](?:\s+\d+)*\s+MODULE", line, re.I)]
    return [lines[a:b] for a, b in zip(starts, [*starts[1:], len(lines)])]


def finer(text: str) -> tuple:
    """The file on smaller elements, and of each case of the old file its number in the new one."""
    out, number, numbers = [], 0, []
    for block in blocks_of(text):
        if block[0].split()[0] == "0":
            break
        times = 2 if is_rolling_step(block) else 1
        out += [finer_line(line) for line in block] * times
        number += times
        numbers.append(number)
    return "\n".join([*out, " 0  MODULE", ""]), numbers


def write(folder: Path, to: Path, file: Path):
    text, _ = finer(file.read_text(errors="replace"))
    place = to / file.relative_to(folder)
    place.parent.mkdir(parents=True, exist_ok=True)
    place.write_text(text)


def read(folder: Path, at: Path, run: dict):
    """Adds to the table the totals of those cases of the run that differ."""
    table = totals() if TABLE.exists() else {}
    for name, result in run.items():
        output = (at / name).with_suffix(".out")
        if not output.exists():
            continue
        printed = contact_output.read(output.read_text(errors="replace"))
        _, numbers = finer((folder / name).read_text(errors="replace"))
        if len(numbers) != len(result["cases"]):
            print(f"{name}: {len(numbers)} of its {len(result['cases'])} cases are found: left out", file=sys.stderr)
            continue
        for case, entry in result["cases"].items():
            number = numbers[int(case) - 1]
            if "differences" in entry and entry["state"] != "agrees" and number <= len(printed) and "pmax" in printed[number - 1]:
                table[name, int(case)] = printed[number - 1]
    with open(TABLE, "w") as out:
        print("# Totals (N, MPa) that CONTACT, revision 2707, prints for cases of its own repository on elements half as large "
              "(tools/verification/contact_finer.py)", file=out)
        print(",".join(COLUMNS), file=out)
        for (name, case), found in sorted(table.items()):
            print(",".join(map(str, [name, case, *(found[key] for key in COLUMNS[2:])])), file=out)


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=Path, help="a checkout of github.com/eve70a/CONTACT")
    parser.add_argument("finer", type=Path, help="folder of the files on smaller elements")
    parser.add_argument("--of", type=Path, help="what contact_suite --json wrote: read the outputs of CONTACT")
    parser.add_argument("--only", default="", help="files whose path has this word")
    a = parser.parse_args()
    if not a.folder.is_dir():
        print(f"error: '{a.folder}' is no folder (nothing is there) Give a checkout of github.com/eve70a/CONTACT.", file=sys.stderr)
        return 2
    if a.of:
        read(a.folder, a.finer, json.loads(a.of.read_text()))
    else:
        for file in sorted(f for f in a.folder.rglob("*.inp") if a.only in str(f)):
            write(a.folder, a.finer, file)
    return 0


if __name__ == "__main__":
    sys.exit(main())
