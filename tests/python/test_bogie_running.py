"""The bogie of tools/examples: it keeps the linear theory, its derivatives are right, and left and right are the same."""

import csv
import os
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import numpy as np

sys.path.insert(0, os.environ["EXAMPLES"])

import bem_contact  # noqa: E402
import bogie  # noqa: E402
import bogie_running  # noqa: E402


class BogieRunning(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.kept = tempfile.TemporaryDirectory()
        cls.folder = Path(cls.kept.name)
        cls.wheel = bogie_running.contact(bogie_running.CONED, cls.folder, 0.1)
        cls.parameters = bogie.coned_parameters()

    @classmethod
    def tearDownClass(cls):
        cls.kept.cleanup()

    def test_the_critical_speed_is_that_of_the_linear_theory(self):
        expected = bogie_running.critical_speed(lambda speed: bogie_running.linear_theory(speed, self.parameters))

        def system(speed):
            one, rest = bogie_running.at_rest(self.wheel, speed, self.parameters)
            return one.jacobian(0, rest)

        self.assertAlmostEqual(bogie_running.critical_speed(system) / expected, 1, delta=0.02)
        for share, grows in ((0.95, False), (1.05, True)):
            rate = bogie_running.growth(*bogie_running.at_rest(self.wheel, share * expected, self.parameters), 0.02)
            self.assertEqual(rate > 0, grows, rate)

    def test_a_wheelset_alone_has_its_own_linear_theory(self):
        """Without springs between, the theory of the bogie is that of its wheelsets (linear_model.py)."""
        import linear_model
        from wheelset import Wheelset
        free = bogie.Parameters(primary_lateral=0, primary_yaw=0, half_gauge=self.parameters.half_gauge, roll=self.parameters.roll,
                                roll_arm=self.parameters.roll_arm)
        one = Wheelset(mass=free.wheelset_mass, yaw_inertia=free.wheelset_yaw, weight=free.weight, lateral_stiffness=0, yaw_stiffness=0)
        of_one = np.linalg.eigvals(linear_model.matrix(3e4, one))
        of_bogie = np.linalg.eigvals(bogie_running.linear_theory(3e4, free))
        for value in of_one:
            self.assertLess(np.sort(abs(of_bogie - value))[1], 1e-6 * abs(value))  # twice

    def test_derivatives_are_those_of_the_forces(self):
        one = bogie.Bogie(self.wheel, 5e4, self.parameters, curve=2e6)
        state = np.array([0.7, 3e-4, -0.3, 1e-4, 0.2, 5e-5, 2.0, 3e-3, -1.0, 2e-3, 0.5, 1e-3, -30.0, -20.0])
        found = one.jacobian(0, state)
        for k, step in enumerate([1e-4] * 14):
            step *= max(abs(state[k]), 1e-4)
            h = step * (np.arange(14) == k)
            difference = (one(0, state + h) - one(0, state - h)) / (2 * step)
            np.testing.assert_allclose(found[:, k], difference, rtol=1e-4, atol=1e-5 * abs(found[:, k]).max() + 1e-9)

    def test_a_curve_to_the_left_is_the_mirror_image(self):
        found = []
        for side in (1, -1):
            one, state = bogie_running.at_rest(self.wheel, 2e4, self.parameters, curve=side * 1e7)
            self.assertLess(abs(one(0, state)).max(), 1e-3)
            found.append(state)
        np.testing.assert_allclose(found[1][:6], -found[0][:6], rtol=1e-3, atol=1e-9)
        self.assertLess(found[0][0], 0)  # to the right the first wheelset runs to the left, outwards

    def test_a_solution_in_the_loop_goes_where_the_table_goes(self):
        start = np.zeros(14)
        start[0], start[12:] = 0.5, -43.0
        ends = []
        guide = bogie.Bogie(self.wheel, 5e4, self.parameters)
        for contact in (self.wheel, bogie.SolvedContact(bogie_running.CONED, "simplified")):
            run = bogie.Bogie(contact, 5e4, self.parameters).run(start, 0.01, jacobian=guide.jacobian, rtol=1e-4, atol=1e-5)
            ends.append(run.y[:6, -1])
        self.assertGreater(abs(ends[0][0] - 0.5), 0.02)  # it has moved
        np.testing.assert_allclose(ends[1][0], ends[0][0], atol=0.1 * abs(ends[0][0] - 0.5))

    def test_forces_are_smooth_from_tread_to_flange(self):
        """Where the contact passes to the flange, steps of 0.001 mm have second differences far below the stated error, and slopes
        do not jump from cell to cell."""
        lateral = [0, 2, 3, 4, 4.5, 5, 5.25, 5.5, 5.75, 6, 6.25, 6.5]
        made = bem_contact.table(bogie_running.S1002, {"position.lateral": lateral, "motion.xi": [-1e-3, 0, 1e-3]}, hold=["Fx", "Fy"],
                                 tolerance=0.05, output=self.folder / "across.h5")
        table = bem_contact.read_table(self.folder / "across.h5")
        y = np.arange(0, 6500) * 1e-3
        found = [table.force([at, 3e-4], ["Fx", "Fy", "Mz"]) for at in y]
        patches = set(np.round(made["values"]["patch_count"]).ravel())
        self.assertEqual(patches, {1, 2})
        for name in ("Fx", "Fy", "Mz"):
            values = np.array([f["values"][name] for f in found])
            slopes = np.array([f["derivatives"][name]["position.lateral"] for f in found])
            stated = found[0]["errors"][name]
            self.assertLess(abs(np.diff(values, 2)).max(), 1e-3 * stated, name)
            self.assertLess(abs(np.diff(slopes)).max(), 0.02 * abs(slopes).max(), name)
            np.testing.assert_allclose(np.diff(values) / 1e-3, (slopes[1:] + slopes[:-1]) / 2, atol=1e-3 * abs(slopes).max())

    @unittest.skipUnless(shutil.which("cc"), "there is no C compiler")
    def test_the_bogie_in_c_goes_the_same_way(self):
        """The same equations, with the packed table and an integrator of its own."""
        table = self.folder / "coned_bogie.h5"
        subprocess.run([os.environ["BEM_CONTACT"], "table", table, "--columns", "Fx,Fy,Mz,reference_y,T_gamma", "--pack",
                        self.folder / "bogie_table.c"], check=True, stdout=subprocess.DEVNULL)
        program = self.folder / "bogie"
        subprocess.run(["cc", "-std=c99", "-pedantic", "-Wall", "-Wextra", "-Wno-unused-function", "-Werror", "-O2", "-I", self.folder,
                        Path(os.environ["EXAMPLES"]) / "bogie.c", "-o", program, "-lm"], check=True)
        text = subprocess.run([program, "4e7", "2e4", "1", "0.5"], check=True, capture_output=True, text=True).stdout
        found = np.array(text.splitlines()[-1].split()[1:], dtype=float)
        one, _, states = bogie_running.through_the_curve(self.wheel, radius=4e7, speed=2e4, seconds=1.0, transition=0.5)
        self.assertLess(found[0], -1)  # it has moved
        np.testing.assert_allclose(found, states[-1], rtol=1e-4, atol=1e-7)
        for line, (name, wheel) in zip(text.splitlines()[1:], bogie_running.of_wheels(one, states[-1]).items()):
            self.assertIn(f"{name}: Fx {wheel['Fx'] / 1000:6.2f} +- {wheel['errors'][0] / 1000:.2f} kN, "
                          f"Fy {wheel['Fy'] / 1000:6.2f}", line)
        beyond = subprocess.run([program, "1e6"], capture_output=True, text=True)
        self.assertEqual(beyond.returncode, 3)
        self.assertIn("leaves the table (lateral is", beyond.stderr)
        self.assertEqual(subprocess.run([program, "0"], capture_output=True).returncode, 2)

    def test_the_run_is_what_replay_reads(self):
        one, state = bogie_running.at_rest(self.wheel, 2e4, self.parameters, curve=1e7)
        bogie_running.write_run(self.folder / "run.csv", one, [0.0, 0.1], [state, state])
        with open(self.folder / "run.csv", newline="") as file:
            rows = list(csv.DictReader(file))
        asked = {"y": "position.lateral", "psi": "position.yaw", "xi": "motion.xi"}
        for name, side in (("1R", "right"), ("2L", "left")):
            r = bem_contact.solve(bogie_running.CONED, {key: float(rows[1][f"{column}_{name}"]) for column, key in asked.items()}
                                  | {"position.side": side})
            for quantity, own in (("Fx", r.Fx), ("Fy", r.Fy if side == "right" else -r.Fy)):  # a run counts to the right
                stated = self.wheel.table.errors[quantity]["interpolation"]
                self.assertAlmostEqual(float(rows[1][f"{quantity}_{name}"]), own, delta=stated)


if __name__ == "__main__":
    unittest.main()
