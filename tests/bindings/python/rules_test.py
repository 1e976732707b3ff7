# SPDX-License-Identifier: MIT
"""Cost terms and limits that are functions of Python: proved, reported and explained like the built-in ones."""

import math
import pickle
import threading
import unittest

import camopt
import numpy as np

WEIGHTS = {"v": 0.4, "a": 0.4, "j": 0.2}


def power(x, y, v, a, j):
    return v * a


def speed_squared(x, y, v, a, j):
    return v * v


class Terms(unittest.TestCase):
    def test_a_linear_one_finds_and_proves_what_the_built_in_one_does(self):
        reference = {"velocity": 1.76, "acceleration": 5.53}
        built_in = camopt.solve(objective={"velocity": 0.5, "acceleration": 0.5, "reference": reference})
        speed = camopt.term("speed", lambda x, y, v, a, j: v, weight=0.5, reference=1.76, shape="linear",
                            highest_order=1)
        found = camopt.solve(objective={"acceleration": 0.5, "reference": reference}, terms=[speed])
        self.assertEqual(found.verdict, "optimal")
        self.assertAlmostEqual(found.fun, built_in.fun, delta=1e-7)
        self.assertAlmostEqual(found.own_terms[0].value, found.peaks.velocity.value, places=9)
        self.assertEqual((found.own_terms[0].name, found.own_terms[0].weight), ("speed", 0.5))

    def test_alone_they_are_the_whole_objective(self):
        jerk = camopt.term("squared_jerk", lambda x, y, v, a, j: j**2, weight=1, reference=69.0**2, shape="convex")
        found = camopt.solve(terms=[jerk])
        least = camopt.solve(objective={"jerk": 1.0, "reference": {"jerk": 69.0}})
        self.assertAlmostEqual(math.sqrt(found.fun), least.fun, delta=1e-6)
        with self.assertRaisesRegex(camopt.InputError, "no weight > 0|objective"):
            camopt.solve(terms=[])

    def test_a_general_one_is_largest_where_it_says(self):
        term = camopt.term("power", power, weight=1, reference=5, highest_order=2)
        found = camopt.solve(weights={"v": 0.2}, terms=[term])
        self.assertTrue(found.success)
        x = np.linspace(0, 1, 20001)
        largest = (found.motion(x, 1) * found.motion(x, 2)).max()
        self.assertAlmostEqual(found.own_terms[0].value, largest, delta=1e-6 * largest)

    def test_scenes_keep_them(self):
        scene = camopt.Scene(weights=WEIGHTS, terms=[camopt.term("power", power, weight=0.1, reference=5)],
                             own_limits=[camopt.limit("slow", speed_squared, 3.0, shape="convex", highest_order=1)])
        again = pickle.loads(pickle.dumps(scene))
        self.assertEqual(again, scene)
        scene["spline.segments"] = 6
        self.assertEqual(len(scene.terms), 1)
        scene.update(terms=[], own_limits=[])
        self.assertEqual(camopt.solve(scene).own_terms, [])
        self.assertNotEqual(again, scene)
        self.assertEqual(camopt.Scene.from_toml(again.to_toml()).terms, ())

    def test_sweeps_have_them(self):
        term = camopt.term("squared_speed", speed_squared, weight=0.3, reference=3, shape="convex", highest_order=1)
        scene = camopt.Scene(weights=WEIGHTS, terms=[term])
        weights = [0.1, 0.2, 0.4]
        swept = camopt.sweep(scene, {"objective.jerk": weights}, workers=2).to_dict()["objective"]
        for weight, objective in zip(weights, swept):
            self.assertAlmostEqual(camopt.solve(scene, objective__jerk=weight).fun, objective, delta=1e-6)


class Limits(unittest.TestCase):
    def test_they_keep_what_the_built_in_ones_keep(self):
        built_in = camopt.solve(weights=WEIGHTS, limits={"velocity": 1.6})
        own = camopt.limit("speed", speed_squared, 1.6**2, unit="1", shape="convex", highest_order=1)
        found = camopt.solve(weights=WEIGHTS, own_limits=[own])
        self.assertEqual(found.verdict, "optimal")
        self.assertAlmostEqual(found.fun, built_in.fun, delta=1e-7)
        row = found.constraints[0]
        self.assertEqual((row.key, row.unit, row.active), ("own.speed", "1", True))
        self.assertAlmostEqual(row.worst, 2.56, delta=1e-7)

    def test_one_that_no_motion_keeps_is_proved_and_explained(self):
        slow = camopt.limit("slow", lambda x, y, v, a, j: v, 0.5, shape="linear", highest_order=1)
        found = camopt.solve(weights=WEIGHTS, segments=8, own_limits=[slow])
        self.assertEqual(found.verdict, "infeasible")
        row = next(row for row in found.relaxation if row.key == "own.slow")
        wider = camopt.limit("slow", slow.f, row.solved, shape="linear", highest_order=1)
        self.assertTrue(camopt.solve(weights=WEIGHTS, segments=8, own_limits=[wider]).success)


class Derivatives(unittest.TestCase):
    FUNCTIONS = {
        "polynomial": lambda x, y, v, a, j: y * y * v + v * a - 0.5 * j**2 + 3 * y - 1 + x * v,
        "quotient": lambda x, y, v, a, j: (1 - a) / (4 + v * v) + 2 / (y + 3) - (-a) / 7,
        "numpy": lambda x, y, v, a, j: np.sin(v) * np.exp(y) + np.log(4 + v) - np.sqrt(a * a + 1) + np.cos(a),
        "inverse": lambda x, y, v, a, j: np.arctan(a) + np.arcsin(v / 9) - np.arccos(y / 9) + np.tan(y / 3),
        "others": lambda x, y, v, a, j: np.tanh(v) * a + abs(v + 9) - abs(v - 9),
        "angles": lambda x, y, v, a, j: np.arctan2(v, a + 20) + np.arctan2(a + 20, v) + np.sinh(y) + np.cosh(y),
        "powers": lambda x, y, v, a, j: (v + 4)**1.5 + 2**y + (y + 3)**(v / 4) + v**3 + v**0 + v**1,
        "branches": lambda x, y, v, a, j: v**3 if v > 1 else 3 * v * v - 3 * v + 1 if v >= 0 else v,
        "numbers of numpy": lambda x, y, v, a, j: np.float64(2) * v * v + np.float64(3) - v / np.float64(4),
        "constant": lambda x, y, v, a, j: 7.0,
    }

    def test_automatic_ones_are_those_of_differences(self):
        for name, function in self.FUNCTIONS.items():
            points = None if name != "branches" else [(0.3, 0.2, speed, 1, 2) for speed in (0.4, 0.7, 1.3, 1.9)]
            with self.subTest(name):
                check = camopt.check_derivatives(function, points=points)
                self.assertTrue(check, check.worst)
                self.assertLess(check.error, 1e-6)

    def test_they_are_exact(self):
        rule = camopt.term("f", self.FUNCTIONS["polynomial"], weight=1)
        value, gradient, hessian = camopt._camopt.evaluate_rule(rule, np.array([0.3, 0.2, 1.5, -3.0, 7.0]))
        self.assertAlmostEqual(value, 0.04 * 1.5 - 4.5 - 24.5 + 0.6 - 1 + 0.45, places=13)
        np.testing.assert_allclose(gradient, [1.5, 2 * 0.2 * 1.5 + 3, 0.04 - 3 + 0.3, 1.5, -7], rtol=1e-14)
        expected = np.zeros((4, 4))
        expected[0, 0], expected[3, 3] = 3, -1
        expected[0, 1] = expected[1, 0] = 0.4
        expected[1, 2] = expected[2, 1] = 1
        np.testing.assert_allclose(hessian, expected, rtol=1e-14, atol=1e-15)

    def test_given_ones_are_used_and_checked_at_once(self):
        hand = {"gradient": lambda x, y, v, a, j: [0, a, v, 0],
                "hessian": lambda x, y, v, a, j: [[0, 0, 0, 0], [0, 0, 1, 0], [0, 1, 0, 0], [0, 0, 0, 0]]}
        given = camopt.term("power", power, weight=1, reference=5, highest_order=2, **hand)
        automatic = camopt.term("power", power, weight=1, reference=5, highest_order=2)
        found = [camopt.solve(weights={"v": 0.2}, terms=[one]).fun for one in (given, automatic)]
        self.assertAlmostEqual(*found, delta=1e-9)
        wrong = dict(hand, gradient=lambda x, y, v, a, j: [0, a, 1.001 * v, 0])
        with self.assertRaisesRegex(camopt.ModelError, "power: found derivatives that disagree .* d/da is"):
            camopt.term("power", power, weight=1, **wrong)
        bent = dict(hand, hessian=lambda x, y, v, a, j: np.zeros((4, 4)))
        check = camopt.check_derivatives(power, **bent)
        self.assertFalse(check)
        self.assertIn("d²/d", check.worst)

    def test_what_has_no_partials_is_told(self):
        for function, words in ((lambda x, y, v, a, j: math.sin(v), "must be real number"),
                                (lambda x, y, v, a, j: "much", "f: found 'much'; allowed: a number"),
                                (lambda x, y, v, a, j: None, "f: found None; allowed: a number")):
            with self.assertRaisesRegex((TypeError, camopt.ModelError), words):
                camopt.check_derivatives(function)
        with self.assertRaisesRegex(camopt.ModelError, "found a gradient without a hessian"):
            camopt.term("power", power, weight=1, gradient=lambda *point: [0, 0, 0, 0])
        with self.assertRaisesRegex(camopt.ModelError, "allowed: a gradient of 4 numbers"):
            camopt.term("power", power, weight=1, gradient=lambda *p: [0, 0], hessian=lambda *p: np.zeros((4, 4)))


class Faults(unittest.TestCase):
    def test_what_a_function_raises_comes_through(self):
        def broken(x, y, v, a, j):
            raise LookupError("no paper left")

        scene = camopt.Scene(weights=WEIGHTS, own_limits=[camopt.limit("broken", broken, 1)])
        with self.assertRaisesRegex(LookupError, "no paper left"):
            camopt.solve(scene)
        with self.assertRaisesRegex(LookupError, "no paper left"):
            camopt.Solver(scene).solve()
        with self.assertRaisesRegex(LookupError, "no paper left"):
            camopt.sweep(scene, {"objective.jerk": [0.1, 0.2]}, workers=2)
        self.assertEqual(threading.active_count(), 1)

    def test_a_false_shape_is_found_out(self):
        for shape in ("linear", "convex"):
            with self.assertRaisesRegex(camopt.ModelError, f"power: declared {shape}"):
                camopt.solve(weights=WEIGHTS, terms=[camopt.term("power", power, weight=1, shape=shape)])

    def test_wrong_input_is_told_when_it_is_given(self):
        for keys, words in (({"name": "Power"}, "own_terms.0..name: found \"Power\""),
                            ({"weight": 0}, "weight: found 0"), ({"shape": "round"}, "shape: found \"round\""),
                            ({"highest_order": 4}, "highest_order: found 4")):
            given = {"name": "power", "weight": 1.0, **keys}
            with self.assertRaisesRegex(camopt.InputError, words):
                camopt.Scene(weights=WEIGHTS, terms=[camopt.term(f=power, **given)])


if __name__ == "__main__":
    unittest.main(verbosity=2)
