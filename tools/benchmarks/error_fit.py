"""Shares of the stated errors, fitted to random cases: `tools/benchmarks/estimates --fit`.

A stated error is a weighted sum of parts that the program knows of a result (ErrorParts); the weights are the shares of
bem_contact/contact/check/error_shares.hpp. True errors come from finer grids. Of all shares with which GOAL of the cases are
within their errors, those are taken with which the median of stated over true is least.
"""

import collections
import csv
import itertools
import math
import re

import numpy as np

PARTS = ("change", "local", "peak", "adhesion")
GOAL = 0.96
ROUNDING = 1e-9   # so that the case which decides is within
LEAST_CASES = 20  # of fewer no share is fitted
STEPS = 25        # of each ratio of shares, from one part alone to another alone
ROUNDS = 4        # each looks around the best ratios of the one before, with a quarter of its steps
# The numbers of the table that have the same shares.
SHARED = {"shear_x": ("Fx", "T_gamma"), "shear": ("Fs", "Fy"), "moment": ("Mz",), "approach": ("approach",), "pmax": ("pmax",),
          "area": ("area",), "adhesion_share": ("adhesion_share",), "temperature": ("Tmax_rail", "Tmax_wheel"),
          "creepage_x": ("xi",), "creepage_s": ("eta",)}


class Cases:
    """Those of some numbers: true errors, the parts that make the stated ones, and which of them are fitted."""

    def __init__(self, rows, committed):
        parts, fixed, stated, true = (np.array([row[k] for row in rows]) for k in range(4))
        now = parts @ committed + fixed
        unit = stated / np.where(now > 0, now, 1)  # creepages of wheels and moments have a factor that the parts have not
        self.parts, self.fixed, self.true = parts * unit[:, None], fixed * unit, true
        self.used = np.flatnonzero(np.median(self.parts, axis=0) > 0)

    def judge(self, shares):
        """How many in a hundred are within, and the median of stated over true."""
        stated, some = self.parts @ shares + self.fixed, self.true > 0
        return 100 * np.mean(self.true <= stated), np.median(stated[some] / self.true[some])

    def scaled(self, direction):
        """The least multiple of these shares with which GOAL of the cases are within."""
        sums = self.parts @ direction
        with np.errstate(divide="ignore", invalid="ignore"):
            needed = np.where(sums > 0, np.maximum(self.true - self.fixed, 0) / sums, np.where(self.true > self.fixed, np.inf, 0.0))
        factor = np.sort(needed)[math.ceil(GOAL * len(needed)) - 1]
        return direction * factor * (1 + ROUNDING) if math.isfinite(factor) else None

    def fit(self):
        """Ratios of the parts on a grid, each scaled to the goal; then on finer grids around the best."""
        typical = np.median(self.parts[:, self.used], axis=0)
        middle, reach, best = np.zeros(len(self.used) - 1), 1.0, (math.inf, None)
        for _ in range(ROUNDS):
            around = [m + reach * np.linspace(-1, 1, STEPS) for m in middle]
            for angles in itertools.product(*around):
                weights = spread(np.clip(angles, -1, 1))
                direction = np.zeros(len(PARTS))
                direction[self.used] = weights / typical
                shares = self.scaled(direction)
                if shares is not None and (ratio := self.judge(shares)[1]) < best[0]:
                    best, middle = (ratio, shares), np.array(angles)
            reach /= 4
        return best[1]


def spread(angles):
    """Weights that add up to 1, of numbers from -1 (the first part alone) to 1 (the others alone)."""
    weights, left = [], 1.0
    for angle in angles:
        share = 0.5 * (1 - math.sin(0.5 * math.pi * angle))
        weights.append(left * share)
        left -= weights[-1]
    return np.array([*weights, left])


def committed_shares(header):
    """{(name, line): shares} of error_shares.hpp."""
    out = {}
    for name, body in re.findall(r"(?:GridShares|ErrorShares) (\w+)\{(\{.*?\}\}|.*?\});", header.read_text(), re.S):
        both = [np.array([float((re.search(rf"\.{part} = ([\d.]+)", one) or [0, 0])[1]) for part in PARTS])
                for one in re.findall(r"\.[^{}]+", body)]
        out[name, False], out[name, True] = both[0], both[-1]
    return out


def read(files):
    """{(quantity, line): [parts, fixed, stated, true]} of the tables of bench_cases."""
    out = collections.defaultdict(list)
    for file in files:
        for row in csv.DictReader(open(file, newline="")):
            parts, stated = [float(row[part]) for part in PARTS], float(row["error"])
            if stated > 0 and any(parts):
                out[row["quantity"], row["line"] == "1"].append(
                    (parts, float(row["fixed"]), stated, abs(float(row["value"]) - float(row["exact"]))))
    return out


def text_of(shares):
    return ", ".join(f"{part} {share:.3g}" for part, share in zip(PARTS, shares) if share > 0)


def table(fitted_on, judged_on, header):
    """Markdown lines: the shares that are fitted to some files beside those of the header, and how both do on others."""
    committed, seen, held_out = committed_shares(header), read(fitted_on), read(judged_on)
    lines = ["| shares of | cases | fitted | within, median | committed | within, median |" + (" held out: cases | fitted | committed |" if judged_on else ""),
             "|---" * (9 if judged_on else 6) + "|"]
    for (name, quantities), line in itertools.product(SHARED.items(), (False, True)):
        known = committed[name, line]
        rows, others = ([row for quantity in quantities for row in of[quantity, line]] for of in (seen, held_out))
        if len(rows) < LEAST_CASES:
            continue
        cases = Cases(rows, known)
        shares = cases.fit()
        did = lambda of, what: "{:.1f} %, {:.1f}".format(*of.judge(what))
        cells = [f"{name} ({', '.join(quantities)}){', one row or column' if line else ''}", str(len(cases.true)),
                 text_of(shares), did(cases, shares), text_of(known), did(cases, known)]
        if judged_on:
            cells += [str(len(others)), *((did(Cases(others, known), what) if others else "") for what in (shares, known))]
        lines.append("| " + " | ".join(cells) + " |")
    return lines
