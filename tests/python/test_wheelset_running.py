"""The client of tools/examples: a wheelset whose every force is a solution keeps the laws that textbooks have for it."""

import os
import sys
import unittest
from pathlib import Path

EXAMPLES = Path(os.environ["EXAMPLES"])
sys.path.insert(0, str(EXAMPLES))

import linear_model  # noqa: E402
import wheelset  # noqa: E402
import wheelset_running  # noqa: E402


class WheelsetRunning(unittest.TestCase):
    def test_the_wave_has_klingels_length(self):
        found, expected = wheelset_running.klingel()
        self.assertAlmostEqual(found / expected, 1, delta=0.01)

    def test_small_motions_grow_above_the_critical_speed(self):
        found, expected = wheelset_running.critical()
        self.assertAlmostEqual(found / expected, 1, delta=0.02)

    def test_the_sums_of_tractions_are_the_forces(self):
        at = {"position.lateral": 2.0, "position.yaw": 1e-3, "position.roll": -7e-5, "motion.speed": 2e4,
              "motion.pitch_rate": 2e4 / 460}
        for side, sign in (("right", 1), ("left", -1)):
            wheel = wheelset.Wheel(wheelset_running.CONED, side)
            forces, result = wheel.forces(at, (2.0, -460.0)), wheel.solve(at)
            for found, expected in zip(forces.force, (result.Fx, sign * result.Fy, result.Fz)):
                self.assertAlmostEqual(found, expected, delta=1e-6 * result.Fz)
            self.assertGreater(result.Fz, 1e4)
            # Fz acts where the rail's head has the cone's slope, Fy 460 mm below the axle.
            about_x = (sign * 742.5 - 2.0) * result.Fz - 460 * sign * result.Fy
            self.assertAlmostEqual(forces.moment[0] / about_x, 1, delta=1e-3)

    def test_left_and_right_are_mirror_images(self):
        still = wheelset.Track(wheelset_running.CONED, 4e4)
        for state in ([0.5, 0, 0, 0], [0, 2e-4, 0, 0], [0, 0, 5.0, 0], [0, 0, 0, 0.01]):
            right = still(0, [*state, still.pitch_rate])
            left = still(0, [*(-x for x in state), still.pitch_rate])
            for one, other in zip(right[:4], left[:4]):
                self.assertAlmostEqual(one, -other, delta=1e-3 * abs(right).max())

    def test_the_ellipse_is_that_of_hertz(self):
        for found, expected in zip(linear_model.hertz_ellipse(0.5 / 460, 0.5 / 300, 1e5), (7.161676, 5.387172)):
            # At E = 210000, nu = 0.3; the force is scaled so that the modulus is that of these.
            modulus = linear_model.SHEAR_MODULUS / (1 - linear_model.POISSON) / (210000 / 2 / (1 - 0.3**2))
            self.assertAlmostEqual(found * modulus ** (1 / 3), expected, delta=1e-5)


if __name__ == "__main__":
    unittest.main()
