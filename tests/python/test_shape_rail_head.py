"""The example that shapes a rail head: its gradient is that of differences, and what it gains is there on other elements too."""

import os
import sys
import unittest
from unittest import mock

sys.path.insert(0, os.environ["EXAMPLES"])

import numpy as np  # noqa: E402

import bem_contact  # noqa: E402
import shape_rail_head  # noqa: E402


class ShapeRailHead(unittest.TestCase):
    def test_the_gain_is_confirmed_on_other_elements(self):
        with mock.patch.object(shape_rail_head, "COLLECTIVE", [(lateral, 8e4, 1 / 4) for lateral in (-1.0, 0.5, 2.0, 3.5)]):
            shape, _, depth, start, end = shape_rail_head.shaped(stations=4, steps=4)
            self.assertAlmostEqual(start, 1, delta=1e-6)
            self.assertLess(end, 0.98)
            self.assertTrue(((depth >= 0) & (depth <= 0.3)).all())
            self.assertLess(shape_rail_head.Objective(shape, 0.45).value(depth), 0.985)

    def test_lowering_the_whole_head_changes_nothing(self):
        """All points go down by the same along z, to first order along their normals over cos: T-gamma and pmax stay."""
        shape = shape_rail_head.Shape(4)
        r = bem_contact.solve(shape_rail_head.scene(shape.profile(np.zeros(4)), 0.5, 8e4, 0.8), derivatives=["rail_profile"])
        points = r.derivatives["rail_profile"]["points"]
        for name in ("T_gamma", "pmax"):
            by_point = np.array(points[name])
            self.assertGreater(abs(by_point).max(), 0)
            self.assertLess(abs(by_point @ shape.outwards[:, 1]), 1e-3 * abs(by_point * shape.outwards[:, 1]).sum(), name)

    def test_many_points_and_elements_have_derivatives(self):
        """Directions that serve many right sides lose their digits: the system is then solved anew."""
        depth = 0.9 * np.array([0.23369547, 0.09624735, 0.08660389, 0.08883641, 0.07044032, 0.09944423, 0.1, 0.1])
        for step in (1.0, 0.3, 0.2):
            shape = shape_rail_head.Shape(8, step)
            r = bem_contact.solve(shape_rail_head.scene(shape.profile(depth), 3.0, 8e4, 0.42), derivatives=["rail_profile"])
            self.assertGreater(np.count_nonzero(r.derivatives["rail_profile"]["points"]["pmax"]), 20)

    def test_a_standard_has_no_points(self):
        scene = shape_rail_head.scene("60E1", 0.0, 8e4, 1.0)
        scene["rail"] = {"profile": "60E1"}
        with self.assertRaisesRegex(bem_contact.InputError, "no points to move"):
            bem_contact.solve(scene, derivatives=["rail_profile"])


if __name__ == "__main__":
    unittest.main()
