# SPDX-License-Identifier: MIT
"""Solutions: the numbers of the program, to the last bit, and what can be asked of them."""

import json
import math
import pathlib
import tempfile
import unittest
import xml.dom.minidom

import camopt
import numpy as np
import program

SCENES = ("drd_cubic_12.toml", "drd_quintic_12.toml", "rr_unequal_return.toml", "drd_physical_limits.toml",
          "cam_roller.toml", "cam_forces.toml", "cam_drdrd.toml", "infeasible_velocity_cap.toml", "drd_free_knots.toml",
          "given_drum.toml", "given_guide_forward.toml")
ROLLER = program.scene_path("cam_roller.toml")


def solved(name):
    return camopt.solve(camopt.Scene.from_file(program.scene_path(name)))


def without_run(result):
    """What two runs of one scene have in common: neither seconds nor who asked."""
    result.pop("seconds")
    result.pop("command")
    for clock in ("seconds", "allowed_seconds"):
        result.get("explanation", {}).pop(clock, None)
    return result


class Numbers(unittest.TestCase):
    @program.needs_program
    def test_they_are_those_of_the_program(self):
        for name in SCENES:
            with self.subTest(name):
                printed = json.loads(program.run("solve", program.scene_path(name), "--json"))
                self.assertEqual(without_run(solved(name).to_dict()), without_run(printed))

    @program.needs_program
    def test_files_are_those_of_the_program(self):
        with tempfile.TemporaryDirectory() as folder:
            theirs, mine = pathlib.Path(folder, "theirs"), pathlib.Path(folder, "mine")
            program.run("solve", ROLLER, "--out", str(theirs), "--dxf")
            solution = solved("cam_roller.toml")
            written = solution.write(str(mine), dxf=True)
            self.assertEqual({pathlib.Path(path).name for path in written}, {path.name for path in theirs.iterdir()})
            for name in ("motion.csv", "profile.csv", "certificate.json", "profile.dxf", "scene.toml", "profile.svg"):
                self.assertEqual((mine / name).read_bytes(), (theirs / name).read_bytes(), name)
            self.assertEqual(solution.dxf(), (theirs / "profile.dxf").read_text())
            self.assertEqual(solution.certificate(), (theirs / "certificate.json").read_text())

    def test_without_a_cam_no_drawing_is_written(self):
        with tempfile.TemporaryDirectory() as folder:
            written = solved("drd_cubic_12.toml").write(folder, dxf=True)
            names = {pathlib.Path(path).name for path in written}
            self.assertIn("motion.csv", names)
            self.assertNotIn("profile.dxf", names)

    @program.needs_program
    def test_a_comparison_is_that_of_the_program(self):
        printed = json.loads(program.run("compare", ROLLER, "--json"))
        compared = json.loads(camopt.compare(camopt.Scene.from_file(ROLLER)).to_json())
        printed.pop("command", None), compared.pop("command", None)
        self.assertEqual(compared, printed)

    def test_of_keywords_they_are_those_of_the_readme(self):
        found = camopt.solve(lift_mm=10, rise_deg=120, segments=12, weights={"v": .4, "a": .4, "j": .2})
        self.assertEqual((found.verdict, found.success, found.proof, found.reason), ("optimal", True, "duality", ""))
        self.assertAlmostEqual(found.fun, 0.939513661, places=8)
        self.assertLessEqual(found.bound, found.fun)
        self.assertLess(found.gap, 1e-7)
        self.assertAlmostEqual(found.peaks.velocity.value, 12 / 7, places=9)
        self.assertEqual(float(found.peaks.jerk), found.peaks.jerk.value)


class Motions(unittest.TestCase):
    def test_derivatives_have_the_shape_of_x(self):
        motion = solved("drd_cubic_12.toml").motion
        grid = np.linspace(0, 1, 24).reshape(2, 3, 4)
        for order in range(4):
            values = motion(grid, order=order)
            self.assertEqual(values.shape, grid.shape)
            self.assertEqual(values[1, 2, 1], motion(float(grid[1, 2, 1]), order=order))
        self.assertIsInstance(motion(0.5), float)
        self.assertEqual((motion(0), motion([1]).shape), (0.0, (1,)))
        step = 1e-6
        slope = (motion(0.3 + step) - motion(0.3 - step)) / (2 * step)
        np.testing.assert_allclose(slope, motion(0.3, order=1), rtol=1e-8)
        inner = motion.breakpoints[1]
        self.assertNotEqual(motion(inner, 3, "left"), motion(inner, 3, "right"))

    def test_what_it_cannot_give_is_told(self):
        motion = solved("drd_cubic_12.toml").motion
        for call, words in ((lambda: motion(1.5), "1.5"), (lambda: motion([0, -1]), "-1"),
                            (lambda: motion(0, order=4), "order: found 4"),
                            (lambda: motion(0, side="top"), "side: found")):
            with self.assertRaisesRegex(camopt.InputError, words):
                call()

    def test_the_spline_of_scipy_is_the_motion(self):
        try:
            import scipy.interpolate
        except ImportError:
            self.skipTest("*** SKIPPED: SciPy (python3-scipy) is missing")
        for name in ("drd_cubic_12.toml", "drd_quintic_12.toml", "rr_unequal_return.toml"):
            solution = solved(name)
            spline = solution.bspline()
            self.assertIsInstance(spline, scipy.interpolate.BSpline)
            x = np.linspace(solution.motion.begin, solution.motion.end, 301)
            for order, tolerance in ((0, 1e-13), (1, 1e-11), (2, 1e-9)):
                np.testing.assert_allclose(spline(x, order), solution.motion(x, order), atol=tolerance)
        with self.assertRaisesRegex(camopt.InputError, "found a program"):
            solved("cam_drdrd.toml").bspline()

    def test_laws_are_motions_with_peaks(self):
        self.assertIn("modified_sine", camopt.laws())
        for name in camopt.laws():
            law = camopt.law(name)
            self.assertEqual((law.key, law(0.0)), (name, 0.0))
            self.assertAlmostEqual(law(1.0), 1.0, places=12)
            x = np.linspace(0, 1, 5001)
            peak = law.peaks.velocity.value
            self.assertLessEqual(np.abs(law(x, order=1)).max(), peak * (1 + 1e-12))
            self.assertGreater(np.abs(law(x, order=1)).max(), peak * (1 - 1e-3))
        self.assertAlmostEqual(camopt.law("cycloidal").peaks.acceleration.value, 2 * math.pi, places=12)
        self.assertEqual(camopt.law("parabolic").peaks.jerk.value, math.inf)


class Cams(unittest.TestCase):
    def test_profiles_are_columns_of_cam_and_pitch(self):
        profile = solved("cam_roller.toml").profile(720)
        cam = np.column_stack([profile["cam_x_mm"], profile["cam_y_mm"]])
        pitch = np.column_stack([profile["pitch_x_mm"], profile["pitch_y_mm"]])
        self.assertGreaterEqual(len(cam), 720)
        scene = camopt.Scene.from_file(ROLLER)
        roller, base = scene["cam.roller_radius_mm"], scene["cam.base_radius_mm"]
        np.testing.assert_allclose(np.linalg.norm(pitch - cam, axis=1), roller, rtol=1e-12)
        self.assertGreaterEqual(np.linalg.norm(cam, axis=1).min(), base - 1e-9)
        rows = camopt.structured(profile)
        self.assertEqual((rows.dtype.names, len(rows)), (tuple(profile), len(cam)))

    def test_every_plane_cam_has_a_profile_and_pictures(self):
        for name in ("cam_flat.toml", "cam_arm_roller.toml", "tappet_75.toml", "inverse_feeder.toml"):
            scene = camopt.Scene.from_file(program.scene_path(name))
            scene.update(limits=None)  # what takes the time
            solution = camopt.solve(scene)
            with self.subTest(name, verdict=solution.verdict):
                self.assertTrue(solution.success)
                self.assertGreater(len(solution.profile(200)["theta_deg"]), 199)
                xml.dom.minidom.parseString(solution.svg("cam"))
                self.assertIn("SECTION", solution.dxf())

    def test_a_given_cam_comes_from_arrays(self):
        angle = np.linspace(0, 2 * math.pi, 720, endpoint=False)
        points = {"use": "given", "x_mm": list(40 * np.cos(angle)), "y_mm": list(40 * np.sin(angle) - 5)}
        scene = camopt.Scene(type="program", lift_mm=10, measured=points,
                             cam={"type": "disk", "follower": "translating_knife", "base_radius_mm": 35})
        solution = camopt.solve(scene)
        self.assertEqual((solution.verdict, solution.reason), ("feasible", "given_cam"))
        x = np.linspace(0, 1, 50)
        expected = -5 * np.cos(2 * math.pi * x) + np.sqrt(40**2 - (5 * np.sin(2 * math.pi * x))**2) - 35
        np.testing.assert_allclose(10 * solution.motion(x), expected, atol=1e-7)

    def test_a_scene_without_a_cam_has_none(self):
        solution = solved("drd_cubic_12.toml")
        for call in (solution.profile, solution.dxf, lambda: solution.svg("cam")):
            with self.assertRaises(camopt.InputError):
                call()

    def test_notebooks_get_pictures(self):
        solution = solved("cam_roller.toml")
        xml.dom.minidom.parseString(solution._repr_svg_())
        self.assertEqual(solution._repr_html_().count("<img"), 2)
        self.assertEqual(solved("drd_cubic_12.toml")._repr_html_().count("<img"), 1)
        xml.dom.minidom.parseString(camopt.compare(camopt.Scene.from_file(ROLLER))._repr_svg_())

    def test_limits_and_columns_agree_with_the_result(self):
        solution = solved("cam_roller.toml")
        rows = {row["key"]: row for row in solution.to_dict()["constraints"]}
        self.assertTrue(rows)
        for one in solution.constraints:
            self.assertEqual((one.worst, one.limit, one.at_deg, one.active),
                             tuple(rows[one.key][field] for field in ("worst", "limit", "at_deg", "active")))
        table = solution.table()
        self.assertEqual((table["theta_deg"][0], table["s_mm"][0]), (0.0, 0.0))
        self.assertIn("# ", solution.report())


class WithoutMotion(unittest.TestCase):
    def test_an_infeasible_scene_says_what_would_help(self):
        solution = solved("infeasible_velocity_cap.toml")
        self.assertEqual((solution.verdict, solution.success), ("infeasible", False))
        self.assertEqual([solution.motion, solution.fun, solution.peaks, solution.spline], [None] * 4)
        self.assertTrue(any(row.needed for row in solution.relaxation))
        helps = next(row for row in solution.relaxation if row.solved)
        changed = camopt.Scene.from_file(program.scene_path("infeasible_velocity_cap.toml"))
        changed[helps.key] = helps.solved
        self.assertTrue(camopt.solve(changed).success)
        self.assertIsNone(solution._repr_svg_())
        self.assertIn("nfeasible", solution._repr_html_())
        for call in (solution.bspline, solution.table, solution.svg, solution.profile, solution.dxf):
            with self.assertRaises(camopt.InputError):
                call()


class Solvers(unittest.TestCase):
    def test_ranges_are_chosen_with_the_motion(self):
        text = """
[motion]
type = "DRD"
lift_mm = 12
rise_deg = 60
speed_rpm = 380
[spline]
segments = 12
[objective]
jerk = 1
[cam]
type = "disk"
follower = "translating_roller"
base_radius_mm = 40
roller_radius_mm = 8
[forces]
mass_kg = 1
spring_rate_n_mm = 4
[limits]
contact_force_min_n = 10
contact_force_max_n = 500
"""
        scene = camopt.Scene.from_toml(text)
        scene["forces.preload_n"] = {"min": 0, "max": 1000}
        chosen = camopt.solve(scene)
        self.assertEqual(chosen.verdict, "optimal")
        design = chosen.to_dict()["design"]
        preload = dict(zip(design["names"], design["values"]))["forces.preload"]
        self.assertTrue(0 < preload < 1000, preload)
        self.assertEqual(scene["forces.preload_n"], {"min": 0, "max": 1000})
        scene["forces.preload_n"] = preload
        self.assertAlmostEqual(camopt.solve(scene).fun, chosen.fun, delta=1e-7)
        scene["forces.preload_n"] = {"min": 0, "max": 1000}
        columns = camopt.sweep(scene, {"forces.mass_kg": [1, 1.1]}).to_dict()
        self.assertAlmostEqual(columns["preload"][0], preload, delta=1e-3)
        self.assertTrue(0 < columns["preload"][1] < 1000)
        self.assertTrue(np.all(np.isnan(columns["spring_rate"])))
        with self.assertRaisesRegex(camopt.InputError, "found a range from 5"):
            scene["forces.preload_n"] = {"min": 5, "max": 5}
            camopt.solve(scene)

    def test_neighbours_have_the_verdicts_of_cold_solves(self):
        scene = camopt.Scene.from_file(program.scene_path("cam_roller.toml"))
        solver = camopt.Solver(scene)
        for weight in (0.2, 0.3, 0.5):
            solver.update(objective__jerk=weight)
            warm, cold = solver.solve(), camopt.solve(scene, objective__jerk=weight)
            self.assertIs(solver.solution, warm)
            self.assertEqual(warm.verdict, cold.verdict)
            self.assertAlmostEqual(warm.fun, cold.fun, delta=1e-6)
        self.assertEqual(scene["objective.jerk"], 0.2)
        with self.assertRaises(camopt.InputError):
            solver.update({"spline.segments": -1})
        self.assertEqual(solver.scene["objective.jerk"], 0.5)


if __name__ == "__main__":
    unittest.main(verbosity=2)
