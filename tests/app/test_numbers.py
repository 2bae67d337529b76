"""What `bem_contact influence expand` writes, read by other means, and the ten lines of the format's document."""

import csv
import os
import re
import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path

import h5py
import numpy as np

ROOT = Path(__file__).resolve().parents[2]
PROGRAM = os.environ["BEM_CONTACT"]
RAIL, WHEEL = (ROOT / "data" / "influence" / f"small_{name}.h5" for name in ("rail", "wheel"))
MX, MY, DX, DS = 6, 5, 0.6, 0.5


def expand(*arguments):
    subprocess.run([PROGRAM, "influence", "expand", *map(str, arguments)], check=True, stdout=subprocess.PIPE)


def read_h5(file):
    with h5py.File(file) as f:
        attributes = {k: v.decode() if isinstance(v, bytes) else v for k, v in f.attrs.items()}
        return f["influence_numbers"][:], attributes, {k: v[()] for k, v in f.items()}


def read_csv(file):
    table = np.full((MX, MY, 3, MY, 3), np.nan)
    with open(file) as lines:
        for row in csv.DictReader(line for line in lines if not line.startswith("#")):
            for i, first in enumerate("xsn"):
                for j, second in enumerate("xsn"):
                    table[int(row["m"]), int(row["I"]), i, int(row["J"]), j] = float(row[first + second])
    return table


def read_contact(file):
    """As the program's documentation of the file says; NaN where it has no element."""
    lines = Path(file).read_text().splitlines()
    values = [[float(word) for word in line.split("%")[0].split()] for line in lines if not line.startswith("%")]
    (nmatrix, upper), columns, symmetry, (mx, my, dx, dy) = values[:4]
    assert (nmatrix, upper, columns, symmetry) == (MY, 1, [0, 312], [1, 0]) and (mx, my, dx, dy) == (MX, MY, DX, DS)
    table, rest = np.full((MX, MY, 3, MY, 3), np.nan), iter(values[4:])
    order = (2, 0, 1)
    for loaded in range(MY):
        number, x, s = next(rest)
        assert number == loaded + 1 and x == 0 and abs(s - (loaded - (MY - 1) / 2) * DS) < 1e-4
        for offset in range(1 - MY, MY):
            for m in range(MX):
                index, x, *nine = next(rest)
                assert index == m and abs(x - m * DX) < 1e-4
                if 0 <= loaded + offset < MY:
                    for e, value in enumerate(nine):
                        table[m, loaded + offset, order[e // 3], loaded, order[e % 3]] = value
    assert next(rest, None) is None
    return table


class Numbers(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        self.grid = ["--dx", DX, "--ds", DS, "--mx", MX, "--my", MY]

    def test_every_format_has_the_same_numbers(self):
        pair = [RAIL, WHEEL, *self.grid, "--centre", -30.1, "--wheel-centre", 35.2]
        expand(*pair, "-o", self.folder / "pair.h5")
        expand(*pair, "-o", self.folder / "pair.csv")
        expand(*pair, "--format", "contact", "-o", self.folder / "pair.txt")
        table, attributes, data = read_h5(self.folder / "pair.h5")
        self.assertEqual(table.shape, (MX, MY, 3, MY, 3))
        self.assertEqual((data["dx"], data["ds"]), (DX, DS))
        self.assertIn("displacement of the rail less that of the wheel", attributes["frame"])
        self.assertIn("rail 60E1", attributes["body_rail"])
        np.testing.assert_allclose(data["s_rail"], -30.1 + DS * (np.arange(MY) - 2), atol=1e-12)
        np.testing.assert_allclose(data["s_wheel"], 35.2 - DS * (np.arange(MY) - 2), atol=1e-12)
        np.testing.assert_allclose(data["offset"], DX * np.arange(MX), atol=1e-12)
        np.testing.assert_array_equal(read_csv(self.folder / "pair.csv"), table)
        contact = read_contact(self.folder / "pair.txt")
        self.assertFalse(np.isnan(contact).any())
        np.testing.assert_allclose(contact, 82000 * table, rtol=1e-14, atol=1e-14 * table.max() * 82000)

    def test_numbers_are_those_of_two_elastic_bodies(self):
        expand(RAIL, WHEEL, *self.grid, "-o", self.folder / "pair.h5")
        table = read_h5(self.folder / "pair.h5")[0]
        parity = np.where((np.arange(3) == 0)[:, None] != (np.arange(3) == 0)[None, :], -1, 1)
        np.testing.assert_array_equal(table, parity[None, None, :, None, :] * table.transpose(0, 3, 4, 1, 2))
        columns = [[(parity if m < 0 else np.ones((3, 3)))[None, :, None, :] * table[abs(m)]
                    for m in (i - np.arange(MX))] for i in range(MX)]  # [i][j] for elements i, j along x
        whole = np.block([[block.reshape(3 * MY, 3 * MY) for block in row] for row in columns])
        np.testing.assert_allclose(whole, whole.T, atol=1e-20)
        self.assertGreater(np.linalg.eigvalsh(whole).min(), 0)

    def test_a_pair_is_the_sum_of_its_bodies(self):
        for name, arguments in (("rail", [RAIL, "--centre", -31]), ("wheel", [WHEEL, "--centre", 35]),
                                ("pair", [RAIL, WHEEL, "--centre", -31, "--wheel-centre", 35])):
            expand(*arguments, *self.grid, "--structural-compliance", "included", "-o", self.folder / f"{name}.h5")
        rail, wheel, pair = (read_h5(self.folder / f"{name}.h5")[0] for name in ("rail", "wheel", "pair"))
        turn = np.array([1, -1, -1])
        wheel = wheel[:, ::-1, :, ::-1, :] * turn[None, None, :, None, None] * turn
        np.testing.assert_allclose(pair, rail + wheel, rtol=0, atol=1e-14 * pair.max())

    def test_the_contact_radius_written_is_the_one_used(self):
        """The numbers of a wheel scale with that radius: it is that of the centre, however many rows lie about it."""
        radii = []
        for rows in (4, 5):
            expand(WHEEL, "--dx", DX, "--ds", DS, "--mx", MX, "--my", rows, "--centre", 36.4, "-o", self.folder / "wheel.h5")
            radii.append(read_h5(self.folder / "wheel.h5")[1]["contact_radius"])
        self.assertEqual(radii[0], radii[1])

    def test_ten_lines_of_python(self):
        text = (ROOT / "data" / "INFLUENCE_FORMAT.md").read_text()
        blocks = re.findall(r"```python\n(.*?)```", text, re.S)
        self.assertEqual(len(blocks), 1)
        self.assertLessEqual(len(blocks[0].strip().splitlines()), 10)
        shutil.copy(RAIL, self.folder / "rail.h5")
        done = subprocess.run(["/usr/bin/python3", "-c", blocks[0]], cwd=self.folder, check=True, text=True,
                              stdout=subprocess.PIPE)
        printed = float(re.search(r"A_nn = (\S+) mm/MPa", done.stdout)[1])
        with h5py.File(RAIL) as f:
            stations = f["stations"][:]
            width = f.attrs["station_width"]
        expand(RAIL, "--dx", 1, "--ds", width, "--mx", 1, "--my", 1, "--centre", stations[len(stations) // 2, 0],
               "--structural-compliance", "included", "-o", self.folder / "one.h5")
        self.assertAlmostEqual(printed / read_h5(self.folder / "one.h5")[0][0, 0, 2, 0, 2], 1, delta=5e-3)


if __name__ == "__main__":
    unittest.main()
