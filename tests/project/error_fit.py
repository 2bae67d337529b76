"""tools/benchmarks/error_fit: shares that are known are found, of cases that are made from them."""

import sys
import unittest
from pathlib import Path

import numpy as np

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tools" / "benchmarks"))
import error_fit  # noqa: E402

HEADER = ROOT / "bem_contact" / "contact" / "check" / "error_shares.hpp"


def made(shares, count=600, seed=1):
    """Cases whose true errors lie evenly below the stated ones: 96 % of all shares hold, times .96."""
    rng = np.random.default_rng(seed)
    parts = 10 ** rng.uniform(-2, 0, (count, len(shares))) * (np.array(shares) > 0)
    return [(list(part), 0.0, part @ shares, part @ shares * share) for part, share in zip(parts, rng.permutation(np.linspace(0, 1, count)))]


class Fit(unittest.TestCase):
    def test_known_shares_are_found(self):
        wanted = np.array([0.4, 0.05, 0.0, 0.8])
        cases = error_fit.Cases(made(wanted), wanted)
        found = cases.fit()
        within, ratio = cases.judge(found)
        self.assertGreaterEqual(within, 100 * error_fit.GOAL)
        self.assertLessEqual(ratio, cases.judge(0.96 * wanted)[1] * 1.01)
        np.testing.assert_allclose(found, 0.96 * wanted, rtol=0.15, atol=0.03)

    def test_one_part_needs_its_quantile(self):
        cases = error_fit.Cases([([0, 2.0, 0, 0], 0.0, 2.0, error) for error in range(1, 101)], np.array([0, 1.0, 0, 0]))
        np.testing.assert_allclose(cases.fit(), [0, 48, 0, 0])

    def test_a_fixed_part_is_not_scaled(self):
        cases = error_fit.Cases([([1.0, 0, 0, 0], 3.0, 4.0, 5.0)] * 30, np.array([1.0, 0, 0, 0]))
        np.testing.assert_allclose(cases.fit(), [2, 0, 0, 0])

    def test_every_share_that_is_fitted_is_in_the_header(self):
        known = error_fit.committed_shares(HEADER)
        for name in error_fit.SHARED:
            self.assertGreater(known[name, False].sum(), 0, name)
        np.testing.assert_array_equal(known["shear", True], [0.475, 0.289, 0, 0.17])


if __name__ == "__main__":
    unittest.main()
