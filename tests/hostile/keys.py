"""Every key of a scene, as --print-default declares it, and values that it must refuse."""

import re
import subprocess
from dataclasses import dataclass

from doors import PROGRAM


@dataclass
class Key:
    name: str
    kind: str  # number, whole number, text, true or false, list of numbers
    words: str  # all that its comment says
    patch: bool  # a patch may have it
    wheel_rail: bool

    def out_of_range(self):
        """Values just beyond the declared range."""
        found = []
        for sign, bound in re.findall(r"(?:; |and )(>=|<=|>|<) (-?[\d.e+-]+?)(?=[; )]| and)", self.words):
            value = float(bound)
            step = max(1.0, abs(value)) * (1e-3 if self.kind == "number" else 1)
            beyond = {">=": value - step, ">": value, "<=": value + step, "<": value}[sign]
            found.append(int(beyond) if self.kind == "whole number" else beyond)
        return found

    def choices(self):
        found = re.search(r"\(text; (\w+(?: \| \w+)+);", self.words)
        return found[1].split(" | ") if found else []


def all_keys():
    text = subprocess.run([PROGRAM, "--print-default"], check=True, stdout=subprocess.PIPE, text=True).stdout
    keys, table, comment = [], "", ""
    for line in text.splitlines():
        if heading := re.match(r"^#? ?\[([\w.]+)\]$", line):
            table = heading[1] + "."
        elif entry := re.match(r"^(?:# )?([a-z_]+) = \S", line):
            kind = re.search(r"\((number|whole number|text|true or false|[^;()]*list[^;()]*)[;)]", comment)
            keys.append(Key(table + entry[1], kind[1] if kind else "?", comment,
                            "only where kind is wheel_rail" not in comment, "only where kind is patch" not in comment))
        elif line.startswith("#"):
            comment = line
    return keys


def misspelt(name):
    """Two letters of the last word swapped."""
    table, _, word = name.rpartition(".")
    for i in range(len(word) - 1, 0, -1):
        if word[i] != word[i - 1]:
            swapped = word[:i - 1] + word[i] + word[i - 1] + word[i + 1:]
            return f"{table}.{swapped}" if table else swapped
    return name + "x"
