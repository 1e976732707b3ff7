# SPDX-License-Identifier: MIT
"""Scenes: keys, units and words of a scene file; nothing that is wrong is kept."""

import pickle
import unittest

import camopt
import numpy as np
import program

WEIGHTS = {"v": 0.4, "a": 0.4, "j": 0.2}


class Keys(unittest.TestCase):
    def test_keywords_are_keys_of_their_tables(self):
        scene = camopt.Scene(lift_mm=10, rise_deg=120, segments=12, speed_rpm=300, weights=WEIGHTS,
                             limits={"velocity_mm_s": 300}, solver="structured")
        self.assertEqual(scene.to_dict(), {
            "motion": {"type": "DRD", "lift_mm": 10, "rise_deg": 120, "speed_rpm": 300},
            "spline": {"segments": 12},
            "objective": {"velocity": 0.4, "acceleration": 0.4, "jerk": 0.2},
            "limits": {"velocity_mm_s": 300}, "solver": {"name": "structured"}})

    def test_every_spelling_of_a_quantity_replaces_the_others(self):
        scene = camopt.Scene(lift_mm=10, weights=WEIGHTS)
        scene["motion.lift_in"] = 0.5
        self.assertNotIn("motion.lift_mm", scene)
        self.assertEqual(scene["motion.lift_in"], 0.5)
        scene.update(spline__segments=8, objective__jerk=0.3)
        self.assertEqual((scene["spline.segments"], scene["objective.jerk"]), (8, 0.3))

    def test_a_program_and_what_leads_into_arrays(self):
        segments = [{"kind": "dwell", "angle_deg": 60}, {"kind": "spline", "angle_deg": 120, "to": 1.0},
                    {"kind": "dwell", "angle_deg": 60}, {"kind": "spline", "angle_deg": 120, "to": 0.0}]
        scene = camopt.Scene(type="program", lift_mm=80, segments=segments, weights=WEIGHTS)
        scene["motion.segments[1].to"] = 0.9
        self.assertEqual(scene["motion.segments[1].to"], 0.9)
        self.assertEqual(camopt.solve(scene).verdict, "optimal")

    def test_numbers_survive_to_the_last_bit(self):
        for value in (0.1 + 0.2, 1e-7, np.float64(2 / 3), np.float32(0.1), 123456789.123456789):
            scene = camopt.Scene(lift_mm=value, weights=WEIGHTS)
            self.assertEqual(camopt.Scene.from_toml(scene.to_toml())["motion.lift_mm"], float(value))

    def test_a_text_keeps_its_comments_until_it_is_changed(self):
        text = "# mine\n[motion]\ntype = \"DRD\"\n[objective]\njerk = 1\n"
        scene = camopt.Scene.from_toml(text)
        self.assertEqual(scene.to_toml(), text)
        scene["spline.segments"] = 6
        self.assertEqual(scene, camopt.Scene(segments=6, weights={"j": 1}))

    def test_keys_are_taken_out(self):
        scene = camopt.Scene.from_file(program.scene_path("cam_roller.toml"))
        self.assertIn("limits", scene)
        del scene["limits"]
        self.assertNotIn("limits", scene)
        scene.update({"cam": None, "spline.segments": 8})
        self.assertEqual((scene["spline.segments"], "cam" in scene), (8, False))
        with self.assertRaises(KeyError):
            scene["cam.base_radius_mm"]
        with self.assertRaises(camopt.InputError):
            del scene["objective"]

    def test_copies_and_pickles_are_the_same_scene(self):
        scene = camopt.Scene.from_file(program.scene_path("cam_forces.toml"))
        scene["spline.segments"] = 20
        again = pickle.loads(pickle.dumps(scene))
        self.assertEqual(again, scene)
        again["spline.segments"] = 21
        self.assertEqual(scene["spline.segments"], 20)
        self.assertNotEqual(again, scene)


class Motions(unittest.TestCase):
    """What a scene says of motions, as dicts: of laws alone, with ends in motion, bounds, repeated parts."""
    LAWS = [dict(kind="law", law="cycloidal", angle_deg=120, to_mm=8), dict(kind="dwell", angle_deg=60),
            dict(kind="law", law="cycloidal", angle_deg=120, to_mm=0), dict(kind="dwell", angle_deg=60)]

    def optimum(self, **keys):
        found = camopt.solve(weights=keys.pop("weights", dict(a=.6, j=.4)), lift_mm=10, rise_deg=120, speed_rpm=600, **keys)
        self.assertEqual(found.verdict, "optimal", found.message)
        return found

    def test_program_of_laws_needs_no_weights(self):
        found = camopt.solve(motion=dict(type="program", lift_mm=8, segments=self.LAWS))
        self.assertEqual(found.verdict, "optimal")
        self.assertAlmostEqual(found.motion(0.5), 0.5, places=12)
        self.assertIn("nothing to optimize", found.report())

    def test_ends_in_motion_have_their_states(self):
        found = self.optimum(degree=5, start=dict(velocity=0.5), end=dict(velocity=0.25, acceleration=-1))
        self.assertAlmostEqual(found.motion(0, order=1), 0.5, places=8)
        self.assertAlmostEqual(found.motion(1, order=1), 0.25, places=8)
        self.assertAlmostEqual(found.motion(1, order=2), -1, places=7)

    def test_corridor_holds(self):
        self.assertGreater(self.optimum().motion(0.5), 0.49)
        found = self.optimum(corridor=[dict(from_deg=40, to_deg=60, displacement_mm=dict(max=4))])
        self.assertAlmostEqual(found.motion(0.5), 0.4, places=8)

    def test_limit_of_one_side_holds(self):
        free = self.optimum()
        per_normalised = 0.010 * (600 * 2 * np.pi / 60 / np.radians(120)) ** 2
        x = np.linspace(0, 1, 1001)
        self.assertLess(free.motion(x, order=2).min() * per_normalised, -40)
        found = self.optimum(limits=dict(acceleration_m_s2=dict(min=-38, max=400)))
        self.assertGreaterEqual(found.motion(x, order=2).min() * per_normalised, -38 * (1 + 1e-8))
        self.assertEqual([row.key for row in found.constraints][0], "limits.acceleration_m_s2.min")

    def test_area_is_a_term(self):
        keys = dict(type="RR", return_deg=120)
        area = [self.optimum(weights=weights, **keys).motion(np.linspace(0, 2, 2001)).mean()
                for weights in (dict(a=.6, j=.4), dict(a=.6, j=.4, area=3))]
        self.assertGreater(area[1], area[0] + 0.01)

    def test_repeated_parts_are_equal(self):
        parts = [dict(kind="spline", angle_deg=60, to_mm=8), dict(kind="dwell", angle_deg=60),
                 dict(kind="spline", angle_deg=60, to_mm=0)]
        found = camopt.solve(motion=dict(type="program", lift_mm=8, repeat=2, segments=parts), weights=dict(a=.6, j=.4))
        self.assertEqual(found.verdict, "optimal")
        x = np.linspace(0.1, 2.9, 29)
        np.testing.assert_allclose(found.motion(x + 3), found.motion(x), atol=1e-9)

    def test_load_over_the_cam_angle_presses_the_follower(self):
        keys = dict(motion=dict(type="program", lift_mm=8, speed_rpm=60, segments=self.LAWS),
                    cam=dict(type="disk", follower="translating_roller", base_radius_mm=30, roller_radius_mm=8))
        forces = [camopt.solve(forces=dict(preload_n=100, **load), **keys).to_dict()["cam"]["forces"]
                  for load in ({}, dict(load_n=[[60, 0], [90, 250], [120, 0]]))]
        self.assertAlmostEqual(forces[0]["largest_force_n"]["value"], 100, places=6)
        self.assertAlmostEqual(forces[1]["largest_force_n"]["value"], 350, places=6)


class Words(unittest.TestCase):
    SETTINGS = [("limits.velocity_mm_s", 300), ("limits.velocity", -2), ("limit.velocity", 2), ("motion.lift_mm", "x"),
                ("spline.degree", 4), ("motion.lift", 3), ("solver.name", "gauss"), ("objective.reference", "nobody"),
                ("cam.offset_mm", 80), ("motion.lift_mm", float("nan")), ("spline.segments", 2.5)]

    @program.needs_program
    def test_wrong_input_says_what_the_program_says(self):
        path = program.scene_path("cam_roller.toml")
        for key, value in self.SETTINGS:
            scene = camopt.Scene.from_file(path)
            before = scene.to_toml()
            setting = f"{key}={value if not isinstance(value, str) else chr(34) + value + chr(34)}"
            said = program.refusal("check", path, "--set", setting)
            with self.subTest(setting), self.assertRaises(ValueError) as caught:
                scene[key] = value
            self.assertIsInstance(caught.exception, camopt.InputError)
            words = str(caught.exception)
            self.assertIn(words, said)
            self.assertFalse(words.startswith("--set"), words)
            self.assertEqual(scene.to_toml(), before)

    @program.needs_program
    def test_a_wrong_file_is_named_with_line_and_column(self):
        path = program.scene_path("cam_roller.toml")
        text = camopt.Scene.from_file(path).to_toml().replace("lift_mm = 20", "lift_mm = -20")
        words = r"^here:\d+:\d+: motion.lift_mm: found -20; allowed: a number > 0$"
        with self.assertRaisesRegex(camopt.InputError, words):
            camopt.Scene.from_toml(text, "here")
        with self.assertRaises(camopt.InputError) as caught:
            camopt.Scene.from_file("no/such/file.toml")
        self.assertIn(str(caught.exception), program.refusal("check", "no/such/file.toml"))

    def test_wrong_calls_are_told(self):
        for call, words in ((lambda: camopt.solve(lift=3), "lift: found no key of this name"),
                            (lambda: camopt.solve("scene.toml"), "found a str; allowed: a camopt.Scene"),
                            (lambda: camopt.Scene(lift_mm=object(), weights=WEIGHTS), "motion.lift_mm: found a object"),
                            (lambda: camopt.Scene(weights=3), "weights: found 3; allowed: a dict"),
                            (lambda: camopt.law("nobody"), "nobody")):
            with self.assertRaisesRegex(camopt.InputError, words):
                call()


if __name__ == "__main__":
    unittest.main(verbosity=2)
