"""A check: an exact value, ours on several grids, the observed order of convergence, and a bar."""

from dataclasses import dataclass, field

import numpy as np


@dataclass
class Check:
    name: str
    quantity: str
    unit: str
    source: str
    bar: float  # largest error allowed on the finest grid, relative to `scale` (the exact value if that is not 0)
    order_bar: float = 0.0  # least observed order of convergence; 0: not judged
    sizes: list = field(default_factory=list)  # elements across the contact
    exact: list = field(default_factory=list)
    ours: list = field(default_factory=list)
    scale: float = 0.0

    def add(self, size, ours, exact):
        self.sizes.append(size)
        self.ours.append(float(ours))
        self.exact.append(float(exact))

    def errors(self):
        return [abs(o - e) / (self.scale or abs(e)) for o, e in zip(self.ours, self.exact)]

    def order(self):
        """Slope of log(error) over log(element size), by least squares over all grids."""
        e = np.maximum(self.errors(), 1e-15)
        if len(e) < 3:
            return float("nan")
        return float(-np.polyfit(np.log(self.sizes), np.log(e), 1)[0])

    def passed(self):
        good = self.errors()[-1] <= self.bar
        return bool(good and not (self.order_bar and len(self.sizes) > 2 and not self.order() >= self.order_bar))


@dataclass
class Study:
    """One closed form on several grids; `solve(n)` gives {quantity: (ours, exact)} with n elements across."""

    name: str
    source: str
    solve: object
    sizes: tuple
    bars: dict  # quantity: (unit, bar, least order[, scale])

    def run(self, quick):
        sizes = self.sizes[:3] if quick else self.sizes
        checks = {q: Check(self.name, q, b[0], self.source, b[1] * (8 if quick else 1), 0 if quick else b[2],
                           scale=b[3] if len(b) > 3 else 0.0) for q, b in self.bars.items()}
        for n in sizes:
            found = self.solve(n)
            for q, check in checks.items():
                check.add(n, *found[q])
        return list(checks.values())


def norm_of_difference(ours, exact):
    """Root of the mean square difference, relative: (this, 0) is what a study returns for a field."""
    return float(np.sqrt(np.sum((ours - exact) ** 2) / np.sum(exact**2))), 0.0
