"""Tables in pages: every number that a program has computed is compared with the CSV file that it comes from.

Before a table with numbers stands a comment that no reader sees:

    <!-- numbers of demo/a.csv and demo/b.csv: position.lateral, a.Fy, b.Fy, -, pmax -->

There is one name for each column of the table: that of a column of the files (b.Fy: of b.csv; else of the first), or - for what no
file has. The first name finds the row. A cell with several numbers ("3 to 7 MPa") takes names with a slash between: low/high.
Other tables say why nobody can compare them: <!-- not compared: REASON -->.

Prose: a number with three digits or more in a sentence that begins with "You should see" is one that a command of the page has printed.
"""

import csv
import re
from pathlib import Path

NUMBER = re.compile(r"(?<![\w.])[-+]?(?:\d+\.?\d*|\.\d+)(?:e[-+]?\d+)?(?![\w.]*\d)")
CELL = re.compile(r"\s*[-+]?(\d+\.?\d*|\.\d+)(e[-+]?\d+)?\s*(\+-.*|%|mm|N|MPa|um)?\s*")
TOLERANCE = 5e-3  # relative: other machines choose other last digits
FOUND = re.compile(r"<!-- numbers of (.*?): (.*?) -->")
LEFT = re.compile(r"<!-- not compared: \S.* -->")


def tables_of(text):
    """(line before the table, its rows of cells), without the head."""
    lines = text.splitlines()
    for k, line in enumerate(lines):
        if line.startswith("|") and not (k and lines[k - 1].startswith("|")):
            rows = [[cell.strip() for cell in row.strip().strip("|").split("|")] for row in lines[k:k + next(
                (n for n, below in enumerate(lines[k:]) if not below.startswith("|")), len(lines) - k)]]
            before = next((above for above in reversed(lines[:k]) if above.strip()), "")
            yield before, rows[2:]


def has_numbers(rows):
    return any(CELL.fullmatch(cell) for row in rows for cell in row)


def read(file):
    with open(file, newline="") as lines:
        return list(csv.DictReader(lines))


def same(cell, values):
    """Whether the numbers of a cell are these values, as far as they are written out; one number may stand for equal ones."""
    numbers = NUMBER.findall(cell.split("+-")[0])
    if values == [""]:
        return not numbers
    if len(numbers) == 1:
        numbers = numbers * len(values)
    if len(numbers) != len(values):
        return False
    for number, value in zip(numbers, values):
        digits = len(number.partition("e")[0].partition(".")[2])
        rounding = 0.5001 * 10.0 ** (int(number.partition("e")[2] or 0) - digits)
        if abs(float(number) - float(value)) > max(rounding, TOLERANCE * abs(float(value))):
            return False
    return True


def faults_of(text, folder, left_out=frozenset()):
    """What is wrong with the tables of a page, in sentences; `left_out`: files that are not made this time."""
    faults = []
    for before, rows in tables_of(text):
        found = FOUND.search(before)
        if not found:
            if has_numbers(rows) and not LEFT.search(before):
                faults.append(f"no comment says where the numbers come from: {rows[0]}")
            continue
        files = re.findall(r"\S+\.csv", found[1])
        if any(file == out or file.startswith(f"{out}/") for file in files for out in left_out):
            continue
        tables = {Path(file).stem: read(Path(folder) / file) for file in files}
        first = next(iter(tables))
        names = [name.strip() for name in found[2].split(",")]
        for row in rows:
            if len(row) != len(names):
                faults.append(f"{len(names)} names for the cells {row}")
                continue
            if value_in(tables, first, names[0], names[0], row[0]) is None:
                faults.append(f"the files have no row {row[0]}")
                continue
            for cell, name in zip(row[1:], names[1:]):
                values = [] if name == "-" else [value_in(tables, first, one, names[0], row[0]) for one in name.split("/")]
                if None in values or (values and not same(cell, values)):
                    faults.append(f"'{cell}' in the row {row[0]} is not {name} = {values}")
    return faults


SEEN = re.compile(r"You should see\b.*?(?:[.:](?=\s|$)|\n\s*\n|\Z)", re.S)
DIGITS_THAT_TELL = 3  # fewer are counts and roundings


def prose_faults(text, printed):
    """Numbers that a page says are to be seen, and that nothing printed has."""
    found = [float(number) for line in printed for number in NUMBER.findall(line)]
    faults = []
    for sentence in SEEN.findall(re.sub(r"`[^`]*`|\([^)]*\.md[^)]*\)", "", text)):
        for number in NUMBER.findall(sentence):
            if len(re.sub(r"e.*|\D|^[-+0.]*", "", number)) >= DIGITS_THAT_TELL and not any(same(number, [value]) for value in found):
                faults.append(f"no command has printed the {number} of '{' '.join(sentence.split())}'")
    return faults


def value_in(tables, first, name, key, wanted):
    """The number of a file in the row whose key is the wanted one; None where there is none."""
    stem, _, column = name.partition(".")
    table, column = (tables[stem], column) if stem in tables and column in tables[stem][0] else (tables[first], name)
    return next((line.get(column) for line in table if is_key(wanted, line[key])), None)


def is_key(wanted, found):
    try:
        return abs(float(wanted) - float(found)) < 1e-9
    except ValueError:
        return wanted == found
