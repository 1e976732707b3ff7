# SPDX-License-Identifier: MIT
"""Machines of several axes: the numbers of the program, and settings that reach machine and axes."""

import json
import pathlib
import tempfile
import unittest

import camopt
import program

CARTONER = program.scene_path("machines/cartoner.toml")
NARROW = {"machine.speed_rpm": {"min": 150, "max": 200}}


class Machines(unittest.TestCase):
    @program.needs_program
    def test_they_are_those_of_the_program(self):
        found = camopt.solve_machine(CARTONER, NARROW)
        printed = json.loads(program.run("machine", CARTONER, "--json", "--set", "machine.speed_rpm={min=150,max=200}"))
        own = found.to_dict()
        for key in ("verdict", "speed_rpm", "impossible_above_rpm", "limited_by", "clearances"):
            self.assertEqual(own[key], printed[key], key)
        self.assertAlmostEqual(found.speed_rpm, printed["speed_rpm"], delta=1e-9 * found.speed_rpm)
        self.assertEqual(list(found.axes), ["pusher", "gripper", "plunger"])
        for name, axis in found.axes.items():
            self.assertEqual(axis.to_dict()["objective"], printed["axes"][name]["objective"])
        with tempfile.TemporaryDirectory() as folder:
            found.write(folder, plc=["codesys"])
            names = {path.name for path in pathlib.Path(folder).iterdir()}
            self.assertLess({"machine.json", "timing.svg", "report.html", "pusher", "gripper", "plunger"}, names)
            self.assertTrue(pathlib.Path(folder, "pusher/codesys.st").exists())
            self.assertTrue(pathlib.Path(folder, "timing.svg").read_text() == found.svg())

    def test_keys_reach_the_machine_and_its_axes(self):
        least = camopt.solve_machine(CARTONER, {"machine.speed_rpm": 100, "pusher.limits.acceleration_m_s2": 20})
        self.assertEqual((least.verdict, least.speed_rpm, least.impossible_above_rpm), ("optimal", 100.0, None))
        row = next(row for row in least.axes["pusher"].constraints if row.key == "limits.acceleration_m_s2")
        self.assertEqual(row.limit, 20.0)
        self.assertLessEqual(row.worst, 20.0 * (1 + 1e-9))

    def test_what_is_wrong_is_told(self):
        with self.assertRaisesRegex(camopt.InputError, r"machine\.pace: found an unknown key; allowed: speed_rpm"):
            camopt.solve_machine(CARTONER, {"machine.pace": 3})
        none = camopt.solve_machine(CARTONER, {"clearance[0].at_least_mm": 200})
        self.assertEqual((none.verdict, none.at_standstill, none.axes, none.svg()), ("infeasible", True, {}, None))


class Motors(unittest.TestCase):
    def test_figures_are_those_of_the_result(self):
        solution = camopt.solve(camopt.Scene.from_file(program.scene_path("servo_drd.toml")))
        self.assertEqual(solution.drive, solution.to_dict()["drive"])
        self.assertAlmostEqual(solution.drive["peak_torque_nm"], 4.2, delta=1e-6)
        self.assertIsNone(camopt.solve(lift_mm=10, rise_deg=120, segments=8, weights=dict(a=1)).drive)

    def test_valve_lobes_have_their_events(self):
        solution = camopt.solve(camopt.Scene.from_file(program.scene_path("valve_intake.toml")))
        at_checking = next(event for event in solution.valve["events"] if abs(event["height_mm"] - 0.15) < 1e-9)
        self.assertAlmostEqual(at_checking["duration_crank_deg"], 248, delta=1e-9)
        self.assertIsNone(camopt.solve(lift_mm=10, rise_deg=120, segments=8, weights=dict(a=1)).valve)


if __name__ == "__main__":
    unittest.main(verbosity=2)
